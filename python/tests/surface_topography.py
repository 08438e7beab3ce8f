#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Topographies of SurfaceTopography as arguments and results, with equal spectra; needs an interpreter with SurfaceTopography."""

from __future__ import annotations

import sys

import numpy as np
import SurfaceTopography

try:
    import setae
except ImportError as error:
    print(f"skipped: the package is for another Python ({error})")
    sys.exit(77)

heights = 1e-8 * np.random.default_rng(3).standard_normal((64, 64))
theirs = SurfaceTopography.Topography(1e9 * heights, (5000.0, 5000.0), unit="nm", periodic=True)
ours = setae.scan(theirs)
assert ours.periodic and np.allclose(ours.size, 5e-6, rtol=1e-15) and np.allclose(ours.heights, heights, rtol=1e-15)

back = ours.to_surface_topography()
assert back.unit == "m" and back.is_periodic and np.array_equal(back.heights(), ours.heights)

q, density = theirs.power_spectrum_from_profile(window="None", reliable=False, resampling_method=None)
psd = setae.power_spectrum(theirs, window="none", trend="none")
n = len(q) - 1  # SurfaceTopography: the last point is before the Nyquist wavevector, the first is q = 0
np.testing.assert_allclose(1e9 * q[1:], psd.q[:n], rtol=1e-12)
np.testing.assert_allclose(1e-27 * density[1:], psd.C1D[:n], rtol=1e-12)

line = SurfaceTopography.UniformLineScan(1e6 * heights[0], 5.0, unit="µm")
assert np.allclose(setae.scan(line).to_surface_topography().heights(), heights[0], rtol=1e-15)
assert setae.power_spectrum([theirs, theirs.detrend("center")]).n == 2
try:
    setae.scan(SurfaceTopography.NonuniformLineScan(np.array([0.0, 1.0, 3.0]), np.array([0.0, 1.0, 0.0]), unit="nm"))
    sys.exit("a nonuniform line was taken")
except setae.InvalidArgument as error:
    assert "grid" in str(error)
