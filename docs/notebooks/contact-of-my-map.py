# ---
# jupyter:
#   SPDX-License-Identifier: GPL-3.0-or-later
#   jupytext:
#     formats: py:percent
# ---
# %% [markdown]
# # Contact of my map
#
# This notebook presses an elastic body on a rough map and compares the contact area with Persson's theory. The map is simulated here; replace
# it with `setae.read("map.gwy").level()`.

# %%
import matplotlib.pyplot as plt

import setae

scan = setae.synthesize(hurst_exponent=0.8, rolloff="2 um", short_cutoff="250 nm", rms_height="50 nm", size="8 um", pixels=256).scan
solved = setae.contact(scan, contact_modulus="4 MPa", pressure="50 kPa", tolerance=1e-6)
print("in contact:", solved["area_fraction_corrected"], "mean gap:", solved["mean_gap"])

# %% [markdown]
# Contact is where the pressure is above zero. The theory needs only the spectrum of the map.

# %%
pressures = ("10 kPa", "20 kPa", "50 kPa", "100 kPa", "200 kPa")
areas = [setae.contact(scan, contact_modulus="4 MPa", pressure=p, tolerance=1e-6)["area_fraction_corrected"] for p in pressures]
theory = setae.persson(scan, contact_modulus="4 MPa", pressure="10 kPa:200 kPa")

# %%
figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4), layout="constrained")
solved.plot(left, of="pressure")
theory.plot(right, label="Persson's theory")
right.plot([setae.quantity(p).to("Pa").value for p in pressures], [float(area) for area in areas], "o", label="solved")
right.legend()
figure.savefig("contact.png")
