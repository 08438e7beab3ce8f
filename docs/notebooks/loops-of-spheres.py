# SPDX-License-Identifier: GPL-3.0-or-later
# ---
# jupyter:
#   jupytext:
#     formats: py:percent
# ---
# %% [markdown]
# # Loops of soft spheres
#
# Soft spheres pressed on surfaces and pulled off: modulus, work of adhesion and loss of each, then what all of them say together. The
# files are generated; what should come out stands in `mine/truth.json`.

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
# The file says force, displacement and contact radius; the sphere's radius is said here.

# %%
loop = setae.loop(files[0], radius="1.25 mm")
print(loop.units, loop.metadata)
fit = loop.fit()
fit

# %% [markdown]
# Every route to the modulus and the work of adhesion, one beside the other; where they differ, something is not as JKR has it.

# %%
for name, found in fit["loading"]["fits"].items():
    if found is not None:
        print(f"{name:34} E* {found['contact_modulus']}, W {found.get('work_of_adhesion', 'not its own')}")
print(fit.alerts)

# %% [markdown]
# Where the energy goes: the loop's own area, the jumps a smooth sphere would lose, too, and what is left for roughness and viscosity.

# %%
print(loop.energy()["ledger"])

# %% [markdown]
# ## All of them
#
# A table with a row a loop; means over the loops of one surface with the scatter between lenses and places, and one more measurement's interval.

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
