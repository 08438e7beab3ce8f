# ---
# jupyter:
#   SPDX-License-Identifier: GPL-3.0-or-later
#   jupytext:
#     formats: py:percent
# ---
# %% [markdown]
# # Hysteresis of my pair
#
# This notebook compares the energy that a loop loses with the prediction of the retraction models. Surfaces and loops are simulated here.

# %%
import subprocess
import sys

import matplotlib.pyplot as plt

import setae

subprocess.run([sys.executable, "-m", "setae", "lab", "make", "examples/tutorial/recipe.toml", "-o", "mine"], check=True)
loop = setae.loop("mine/loops/rougher_soft.csv", radius="1.25 mm")
print(loop.energy())

# %% [markdown]
# A study assigns measurements and loops to pairs of surface and elastomer. W_app is the work of adhesion of approach, W_ret of retraction.

# %%
study = setae.study("mine/study.toml").run(output="mine/results")
pairs = [(f"{pair['surface']}, {pair['elastomer']}", pair["measured"]) for pair in study["pairs"]]
for name, measured in pairs:
    print(f"{name:20} W_app {measured['work_of_adhesion_approach']}, W_ret {measured['work_of_adhesion_retraction']}")
study.predict()

# %% [markdown]
# The difference of both works is the hysteresis of the pair.

# %%
figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4), layout="constrained")
loop.plot(left)
for branch, colour in (("approach", "tab:blue"), ("retraction", "tab:red")):
    works = [measured[f"work_of_adhesion_{branch}"].to("mJ/m2") for _, measured in pairs]
    names, errors = [name for name, _ in pairs], [work.standard_error for work in works]
    right.errorbar([work.value for work in works], names, xerr=errors, fmt="o", color=colour, label=branch)
right.set_xlabel("work of adhesion [mJ/m²]")
right.legend()
figure.savefig("hysteresis.png")
