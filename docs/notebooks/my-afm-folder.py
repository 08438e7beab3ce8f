# ---
# jupyter:
#   SPDX-License-Identifier: GPL-3.0-or-later
#   jupytext:
#     formats: py:percent
# ---
# %% [markdown]
# # My AFM folder
#
# This notebook reads every map of a folder, removes the tilt, and compares roughness and spectra of the maps. The maps are simulated here;
# replace `files` with the files of your folder.

# %%
import pathlib
import subprocess
import sys

import matplotlib.pyplot as plt
import pandas

import setae

subprocess.run([sys.executable, "-m", "setae", "lab", "make", "examples/tutorial/recipe.toml", "-o", "mine"], check=True)
files = sorted(pathlib.Path("mine/rougher").glob("afm_*.txt"))
scans = [setae.read(file).assign_metadata(instrument="afm", tip_radius="10 ± 0.5 nm").level() for file in files]

# %% [markdown]
# Problems of the measurements come first: spikes, scars, noise, or a blunt tip.

# %%
for alert in setae.check(scans).alerts:
    print(alert)

# %% [markdown]
# One row per map: rms height and slope from heights, and the slope inside the band that the tip resolves.

# %%
rows = []
for file, scan in zip(files, scans):
    found = setae.parameters(scan)
    rows.append({"file": file.name, **{name: f"{found[name]}" for name in ("Sq", "rms_slope", "rms_slope_from_spectrum")}})
pandas.DataFrame(rows)

# %% [markdown]
# The first map, and the spectra of all maps.

# %%
figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4), layout="constrained")
scans[0].plot(left)
for file, scan in zip(files, scans):
    setae.power_spectrum(scan).plot(right, label=file.stem)
right.legend()
figure.savefig("afm_folder.png")
