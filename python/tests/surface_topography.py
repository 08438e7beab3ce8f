#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Topographies of SurfaceTopography as arguments and results, with equal spectra; needs an interpreter with SurfaceTopography."""

from __future__ import annotations

import pathlib
import sys
import tempfile

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

# nonuniform lines both ways, with the radius of the tip
about = {"unit": "nm", "info": {"instrument": {"parameters": {"tip_radius": {"value": 10.0, "unit": "nm"}}}}}
curve = SurfaceTopography.NonuniformLineScan(np.array([0.0, 1.0, 3.0, 4.0]), np.array([0.0, 1.0, -1.0, 0.5]), **about)
traced = setae.scan(curve)
assert np.allclose(traced.positions, 1e-9 * curve.positions(), rtol=1e-15) and traced.tip_radius == "10.0 nm"
returned = traced.to_surface_topography()
assert np.array_equal(returned.positions(), traced.positions) and np.array_equal(returned.heights(), traced.heights)
assert returned.info["instrument"]["parameters"]["tip_radius"] == {"value": 10.0, "unit": "nm"}
assert setae.check([curve, traced]).data == []

# containers both ways: in memory, and as files
scans = [setae.scan(heights, size="5 um x 5 um", unit="m", tip_radius="10 nm"), traced]
container = setae.surface(scans, instrument="afm").to_surface_topography()
assert len(container) == 2 and np.array_equal(container[0].heights(), heights)
from_container = setae.surface(container, instrument="afm")
assert from_container.n == 2 and float(from_container["rms_slope"]) == float(setae.surface(scans, instrument="afm")["rms_slope"])
with tempfile.TemporaryDirectory() as folder:
    file = pathlib.Path(folder) / "surface.zip"
    setae.write_container(file, scans[:1], name="rough")
    (read,) = SurfaceTopography.read_container(str(file))
    assert np.allclose(read[0].heights(), heights - heights.mean(), rtol=1e-12, atol=1e-22)
    assert np.allclose(setae.scan(read[0]).size, 5e-6, rtol=1e-12) and setae.power_spectrum(read).n == 1
