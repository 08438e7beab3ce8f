# ---
# jupyter:
#   SPDX-License-Identifier: GPL-3.0-or-later
#   jupytext:
#     formats: py:percent
# ---
# %% [markdown]
# # Coming from SurfaceTopography
#
# This notebook applies the corresponding calls of SurfaceTopography and setae to one map. For each pair it prints the largest relative
# difference and both times. [Parity](../validation/parity.md) lists the definitions that differ, with reasons. Here the options of every call
# select the same definition.

# %%
import sys
import time
from collections.abc import Callable
from typing import Any

import numpy as np

import setae

try:
    import SurfaceTopography
except ImportError:
    print("SurfaceTopography is not installed: pip install SurfaceTopography")
    sys.exit(0)

# %% [markdown]
# The next cell makes a periodic self-affine map of 512 × 512 points, and a topography of SurfaceTopography with the same heights. No copy is
# made.

# %%
scan = setae.synthesize(hurst_exponent=0.8, rolloff="1 um", short_cutoff="40 nm", rms_height="20 nm", size="5 um", pixels=512, seed=1).scan
theirs = scan.to_surface_topography()
line = setae.scan(scan.heights[0].copy(), size="5 um", unit="m", periodic=True)
their_line = line.to_surface_topography()
holes = scan.heights.copy()
holes[100:110, 200:220] = np.nan
our_holes = setae.scan(holes, size="5 um x 5 um", unit="m")
with_holes = SurfaceTopography.Topography(np.ma.masked_invalid(holes), (5e-6, 5e-6), unit="m")

# %% [markdown]
# Each row contains the quantity, the call of SurfaceTopography and the call of setae. A setae call for one parameter computes all parameters
# of its kind, such as three dozen of ISO 25178-2. In your own scripts, call the function once and keep the result.

# %%
plain: dict[str, Any] = {"window": "none", "trend": "none"}
whole: dict[str, Any] = {"trend": "none", "all": True}


def parameter(name: str) -> setae.Quantity:
    found: setae.Quantity = setae.parameters(scan, **plain)[name]
    return found


def areal(symbol: str) -> setae.Quantity:
    found: setae.Quantity = setae.texture(scan, "iso25178", trend="none")[symbol]
    return found


def processed(step: str, **options: Any) -> np.ndarray[Any, Any]:
    return scan.process(step, **options).heights


rows: list[tuple[str, Callable[[], Any], Callable[[], Any]]] = [
    ("Sq", lambda: theirs.rms_height_from_area(), lambda: parameter("rms_height")),
    ("Rq of the lines", lambda: theirs.rms_height_from_profile(), lambda: parameter("rms_height_of_lines")),
    ("slope of the map", lambda: theirs.rms_gradient(), lambda: parameter("rms_slope")),
    ("slope along x", lambda: theirs.rms_slope_from_profile(), lambda: parameter("rms_slope_x")),
    ("half the Laplacian", lambda: theirs.rms_laplacian() / 2, lambda: parameter("rms_curvature")),
    ("largest height", lambda: theirs.max() - theirs.mean(), lambda: areal("Sp")),
    ("deepest", lambda: theirs.mean() - theirs.min(), lambda: areal("Sv")),
    ("share above the mean", lambda: theirs.bearing_area()(theirs.mean()), lambda: areal("Smr(c)")),
    ("C1D of the lines", lambda: theirs.power_spectrum_from_profile(window="None", reliable=False, resampling_method=None)[1][1:],
     lambda: setae.power_spectrum(scan, **plain).C1D),
    ("C1D of one line", lambda: their_line.power_spectrum_from_profile(window="None", reliable=False, resampling_method=None)[1][1:],
     lambda: setae.power_spectrum(line, **plain).C1D),
    ("its wavevectors", lambda: their_line.power_spectrum_from_profile(window="None", reliable=False, resampling_method=None)[0][1:],
     lambda: setae.power_spectrum(line, **plain).q),
    ("autocorrelation of a line", lambda: their_line.autocorrelation_from_profile(reliable=False, resampling_method=None)[1][1:100],
     lambda: setae.autocorrelation(line, **whole).value),
    ("plane", lambda: theirs.detrend("height").heights(), lambda: processed("level_plane")),
    ("mean", lambda: theirs.detrend("center").heights(), lambda: processed("level_mean")),
    ("long waves alone",
     lambda: theirs.shortcut(cutoff_wavelength=200e-9, kind="circular step").heights(), lambda: processed("fourier_cut", shortest="200 nm")),
    ("short waves alone",
     lambda: theirs.longcut(cutoff_wavelength=200e-9, kind="circular step").heights(), lambda: processed("fourier_cut", longest="200 nm")),
    ("scaled", lambda: theirs.scale(2.0).heights(), lambda: setae.scan(2.0 * scan.heights, size="5 um x 5 um", unit="m").heights),
    ("more points", lambda: theirs.interpolate_fourier((1024, 1024)).heights(), lambda: processed("resample", nx=1024, ny=1024, method="fourier")),
    ("x and y changed", lambda: theirs.transpose().heights(), lambda: processed("transpose")),
    ("holes filled", lambda: with_holes.interpolate_undefined_data().heights(), lambda: our_holes.fill().heights),
    ("heights", lambda: theirs.heights(), lambda: scan.heights),
    ("size", lambda: theirs.physical_sizes, lambda: scan.size),
    ("pixels", lambda: theirs.pixel_size, lambda: scan.pixel_size),
    ("and back", lambda: theirs.heights(), lambda: setae.scan(theirs).heights),
]

# %% [markdown]
# setae returns more values at the end of some arrays (the Nyquist wavevector, longer distances). They are left out of the comparison.


# %%
def timed(call: Callable[[], Any]) -> tuple[np.ndarray[Any, Any], float]:
    began = time.perf_counter()
    result = call()
    seconds = time.perf_counter() - began
    return np.atleast_1d(np.asarray(float(result) if isinstance(result, setae.Quantity) else result, dtype=float)), seconds


print(f"{'':28}{'difference':>12}{'theirs':>12}{'ours':>12}")
largest = 0.0
for name, their_call, our_call in rows:
    (a, their_seconds), (b, our_seconds) = timed(their_call), timed(our_call)
    n = min(len(a), len(b))
    difference = float(np.max(np.abs(a[:n] - b[:n])) / np.max(np.abs(a[:n])))
    largest = max(largest, difference)
    print(f"{name:28}{difference:12.1e}{1e3 * their_seconds:9.1f} ms{1e3 * our_seconds:9.1f} ms")
print(f"largest difference {largest:.1e}")
