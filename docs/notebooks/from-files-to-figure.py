# ---
# jupyter:
#   SPDX-License-Identifier: GPL-3.0-or-later
#   jupytext:
#     formats: py:percent
# ---
# %% [markdown]
# # From files to the figure
#
# Two surfaces were measured with a stylus, an AFM and a TEM. Two soft spheres were pressed on them and pulled off. This notebook makes one
# figure that compares the prediction from roughness with the measurement. The files are simulated, so the true values are known. The same
# steps work for your own files.

# %%
import subprocess
import sys

import setae

subprocess.run([sys.executable, "-m", "setae", "lab", "make", "examples/tutorial/recipe.toml", "-o", "mine"], check=True)
setae.info("mine/rougher", "mine/loops")

# %% [markdown]
# ## One measurement
#
# Heights are a NumPy array in metres. Each processing step is recorded and returns a new scan.

# %%
scan = setae.read("mine/rougher/afm_1.txt").assign_metadata(instrument="afm", tip_radius="10 ± 0.5 nm")
levelled = scan.level("plane").despike(threshold=5)
print(levelled.heights.shape, levelled.heights.std())
levelled.processing

# %% [markdown]
# The next cell computes the power spectral density. The tip radius limits the band in which the spectrum is reliable.

# %%
psd = setae.power_spectrum(scan)
print(psd, psd.q[:3], psd.C1D[:3])
psd.alerts

# %%
parameters = setae.parameters(scan)
print(parameters["rms_slope"], "from heights;", parameters["rms_slope_from_spectrum"], "from the spectrum")

# %% [markdown]
# ## One surface
#
# All measurements of the surface give one spectrum, and moments with standard errors. The instruments and tip radii are not in the files, so
# the calls state them.

# %%
stylus = [setae.read(f"mine/rougher/stylus_{i}.csv").assign_metadata(instrument="stylus", tip_radius="5 ± 0.2 um") for i in (1, 2, 3)]
afm = [setae.read(f"mine/rougher/afm_{i}.txt").assign_metadata(instrument="afm", tip_radius="10 ± 0.5 nm") for i in (1, 2, 3)]
tem = [setae.read(f"mine/rougher/tem_{i}.csv").assign_metadata(instrument="tem") for i in (1, 2, 3, 4)]
surface = setae.surface(stylus + afm + tem)
surface

# %% [markdown]
# The next cell computes the work of adhesion of a soft solid on this surface.

# %%
w = setae.work_of_adhesion(surface, youngs_modulus="0.7 MPa", poisson_ratio=0.5, W_int="37 ± 2 mJ/m2", surface_energy="25 mJ/m2")
print(f"W_app {w.estimate}, of it stored {w['stored_energy']}; conforms: {w.conforms}")

# %% [markdown]
# ## One loop

# %%
loop = setae.loop("mine/loops/rougher_soft.csv", radius="1.25 mm")
fit = loop.fit()
print(f"E* {fit.E_star}, W {fit.W}, lost {fit.loss}")

# %% [markdown]
# ## The study
#
# A TOML file assigns the measurements to surfaces, elastomers and loops. Results are kept between runs.

# %%
study = setae.study("mine/study.toml").run(output="mine/results")
print(study.work_of_adhesion)
study.figures["4"]

# %%
study.report("mine/report.html")
study.figures["4"].save("mine/figure_4.csv")
