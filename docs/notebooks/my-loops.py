# ---
# jupyter:
#   SPDX-License-Identifier: GPL-3.0-or-later
#   jupytext:
#     formats: py:percent
# ---
# %% [markdown]
# # My loops
#
# This notebook fits a folder of loops: spheres that were pressed on a surface and pulled off. The loops are simulated here.

# %%
import pathlib
import subprocess
import sys

import matplotlib.pyplot as plt

import setae

subprocess.run([sys.executable, "-m", "setae", "lab", "make", "examples/tutorial/recipe.toml", "-o", "mine"], check=True)
files = sorted(pathlib.Path("mine/loops").glob("*.csv"))
loops = {file.stem: setae.loop(file, radius="1.25 ± 0.01 mm") for file in files}
fits = {name: loop.fit() for name, loop in loops.items()}
for name, fit in fits.items():
    print(f"{name:20} E* {fit.E_star}, W {fit.W}, loss {fit.loss}")

# %% [markdown]
# Each fit has all of its numbers as a table. E* and W of one fit are correlated, and calculations with them use the correlation.

# %%
first = next(iter(fits.values()))
print("E* W =", first.E_star * first.W)
first

# %% [markdown]
# Force against displacement of all loops, and the work of adhesion of each loop.

# %%
figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4), layout="constrained")
for loop in loops.values():
    loop.plot(left, linewidth=0.8)
works = [fit.W.to("mJ/m2") for fit in fits.values()]
right.errorbar([work.value for work in works], list(fits), xerr=[work.standard_error for work in works], fmt="o")
right.set_xlabel("W of approach [mJ/m²]")
figure.savefig("loops.png")
