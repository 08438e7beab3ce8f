# ---
# jupyter:
#   SPDX-License-Identifier: GPL-3.0-or-later
#   jupytext:
#     formats: py:percent
# ---
# %% [markdown]
# # My spectrum and the literature
#
# This notebook compares the spectrum of a map with four nanodiamond surfaces of Dalvi et al., PNAS 116 (2019) 25484. The paper gives moments
# (Table S1); the study file reconstructs self-affine spectra with these moments. The map is simulated here; replace it with your own.

# %%
import matplotlib.pyplot as plt

import setae

scan = setae.synthesize(hurst_exponent=0.8, rolloff="1 um", short_cutoff="20 nm", rms_height="20 nm", size="5 um", pixels=512).scan
published = setae.study("examples/nanodiamond/published.toml").run(output="published")
published.write()

# %% [markdown]
# Slopes depend on the smallest wavelength. The slope of the map is smaller where its pixels do not resolve the waves that the paper includes.

# %%
print("mine", setae.parameters(scan)["rms_slope_from_spectrum"])
for name, surface in published["surfaces"].items():
    print(f"{name:6} rms height {surface['rms_height']}, rms slope {surface['rms_slope']}")

# %% [markdown]
# Spectra can be compared only in one normalisation. The reconstructed spectra are C_iso, so the map needs C_iso, too.

# %%
psd = setae.power_spectrum(scan, isotropic=True)
figure, axes = plt.subplots()
for name in published["surfaces"]:
    setae.surface(f"published/psd_{name}.csv").plot(axes, label=name)
axes.plot(psd.q, psd.C_iso, label="my map", color="black")
axes.legend()
figure.savefig("literature.png")
