# ---
# jupyter:
#   SPDX-License-Identifier: GPL-3.0-or-later
#   jupytext:
#     formats: py:percent
# ---
# %% [markdown]
# # A study in twenty lines
#
# This notebook goes from measurements to a report and to the figure that compares prediction and measurement. The measurements are simulated.

# %%
import subprocess
import sys

import setae

subprocess.run([sys.executable, "-m", "setae", "lab", "make", "examples/tutorial/recipe.toml", "-o", "mine"], check=True)
study = setae.study("mine/study.toml").run(output="mine/results")
print(study.work_of_adhesion)
for surface, found in study["surfaces"].items():
    print(f"{surface}: slope {found['rms_slope']}, true area {found['true_area_ratio']}")
for entry in study.next_measurements()["measurements"][:3]:
    print(f"{entry['measurement']}: ± smaller by {100 * entry['gain']:.0f} %")
study.report("mine/report.html")
study.figures["4"].save("mine/figure_4.svg")
study.figures["4"]
