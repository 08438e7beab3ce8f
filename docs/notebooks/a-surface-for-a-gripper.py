# ---
# jupyter:
#   SPDX-License-Identifier: GPL-3.0-or-later
#   jupytext:
#     formats: py:percent
# ---
# %% [markdown]
# # A surface for a gripper
#
# A soft pad of E = 3 MPa and ν = 0.5 must hold a part by adhesion. The part is available in three finishes at different prices. With which of
# them is the pad in full contact, and what is the work of adhesion? The surfaces are simulated here; replace them with files of your own.

# %%
from typing import Any

import setae

finishes = {
    "polished": setae.synthesize(hurst_exponent=0.8, rolloff="2 um", short_cutoff="20 nm", rms_slope=0.05, size="10 um", pixels=512, seed=1).scan,
    "ground": setae.synthesize(hurst_exponent=0.8, rolloff="2 um", short_cutoff="20 nm", rms_slope=0.3, size="10 um", pixels=512, seed=2).scan,
    "blasted": setae.synthesize(hurst_exponent=0.8, rolloff="2 um", short_cutoff="20 nm", rms_slope=1.5, size="10 um", pixels=512, seed=3).scan,
}
pad: dict[str, Any] = {"E": "3 MPa", "W_int": "40 mJ/m2", "gamma": "25 mJ/m2"}

# %% [markdown]
# Roughness has two effects. It increases the true area, which increases adhesion, and it costs the elastic energy that brings the pad into
# every valley. Where W_app of full contact is below zero, the pad touches only the peaks.

# %%
print(f"{'finish':10}{'slope':>10}{'W_app':>18}{'stored':>18}  conforms")
for name, scan in finishes.items():
    w = setae.work_of_adhesion(scan, **pad)
    slope = setae.parameters(scan)["rms_slope_from_spectrum"]
    print(f"{name:10}{float(slope):10.2f}{1e3 * float(w):12.1f} mJ/m²{1e3 * float(w['stored_energy']):12.1f} mJ/m²  {w.conforms}")

# %% [markdown]
# ## Contact area under pressure
#
# The next cell computes the contact area of the polished part without adhesion, in two ways: with boundary elements on the map, and with
# Persson's theory from the spectrum. At light loads the theory predicts a smaller area, here by a quarter at the smallest pressure and by a
# seventh at the middle one. Both agree in full contact.

# %%
polished = setae.scan(finishes["polished"].heights[::4, ::4], size="10 um x 10 um", unit="m", periodic=True)
for pressure in ("3 kPa", "30 kPa", "150 kPa"):
    solved = setae.contact(polished, contact_modulus="4 MPa", pressure=pressure, tolerance=1e-6)
    theory = setae.persson(polished, contact_modulus="4 MPa", pressure=pressure)
    print(f"{pressure:8} in contact {100 * solved['area_fraction_corrected']:5.1f} %, by Persson's theory {100 * theory['area_fraction'][-1]:5.1f} %")
print(solved.pressures.max(), "Pa at most,", solved.gaps.max(), "m apart at most")

# %% [markdown]
# ## Largest acceptable roughness
#
# The rms slope of this spectrum increases step by step until W_app is half the value of the smooth part.

# %%
slope, held = 0.01, float("inf")
while held > 20e-3:
    slope *= 1.3
    rough = setae.synthesize(hurst_exponent=0.8, rolloff="2 um", short_cutoff="20 nm", rms_slope=slope, size="10 um", pixels=256, seed=4).scan
    held = float(setae.work_of_adhesion(rough, **pad))
print(f"rms slope {slope:.2f}: W_app {1e3 * held:.1f} mJ/m²")
