# ---
# jupyter:
#   SPDX-License-Identifier: GPL-3.0-or-later
#   jupytext:
#     formats: py:percent
# ---
# %% [markdown]
# # Loops of soft spheres
#
# Soft spheres were pressed on surfaces and pulled off. This notebook determines modulus, work of adhesion and energy loss of each loop, and
# then the means over all loops. The files are simulated; `mine/truth.json` contains the true values.

# %%
import csv
import pathlib
import subprocess
import sys

import setae

subprocess.run([sys.executable, "-m", "setae", "lab", "make", "examples/tutorial/recipe.toml", "-o", "mine"], check=True)
files = sorted(pathlib.Path("mine/loops").glob("*.csv"))
print([file.name for file in files])

# %% [markdown]
# ## One loop
#
# The file contains force, displacement and contact radius. The call gives the radius of the sphere.

# %%
loop = setae.loop(files[0], radius="1.25 mm")
print(loop.units, loop.metadata)
fit = loop.fit()
fit

# %% [markdown]
# The next cell lists the modulus and the work of adhesion from every method. Where the methods disagree, the loop deviates from JKR.

# %%
for name, found in fit["loading"]["fits"].items():
    if found is not None:
        print(f"{name:34} E* {found['contact_modulus']}, W {found.get('work_of_adhesion', 'not its own')}")
print(fit.alerts)

# %% [markdown]
# The energy budget of the loop contains the area of the loop, the energy that a smooth sphere would also lose in its jumps, and the rest,
# which is due to roughness and viscosity.

# %%
print(loop.energy()["ledger"])

# %% [markdown]
# ## All loops
#
# The next cell writes a table with one row per loop. It prints the mean over the loops of each surface, with the scatter between lenses and
# places and the interval for one further measurement.

# %%
with open("fits.csv", "w", newline="") as table:
    writer = csv.writer(table)
    writer.writerow(["surface", "lens", "E* [Pa]", "E*_se", "W [J/m2]", "W_se"])
    for file in files:
        fit = setae.loop(file, radius="1.25 mm").fit()
        surface, lens = file.stem.split("_")[:2]
        row = [fit.E_star.value, fit.E_star.standard_error, fit.W.value, fit.W.standard_error]
        writer.writerow([surface, lens, *row])
        print(f"{file.stem:20} E* {fit.E_star}, W {fit.W}, lost {fit.loss}")

means = setae.replicates("fits.csv", group_by=["surface"])
for entry in means["surfaces"]:
    print(entry["surface"], entry["mean"])
