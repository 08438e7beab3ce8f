# SPDX-License-Identifier: GPL-3.0-or-later
"""Arrays as arguments and results: no copy if none is needed; correct numbers or a clear exception otherwise."""

from __future__ import annotations

import os
import time

import numpy as np
import pytest
import setae

N, SIZE = 64, 5e-6


def rough(dtype=np.float64) -> np.ndarray:
    return (1e-8 * np.random.default_rng(3).standard_normal((N, N))).astype(dtype)


def scan_of(array, **arguments) -> setae.Scan:
    return setae.scan(array, **{"size": "5 um x 5 um", "unit": "m", **arguments})


def density(array, **arguments) -> np.ndarray:
    return setae.power_spectrum(scan_of(array, **arguments)).C1D


def address(array: np.ndarray) -> int:
    return array.__array_interface__["data"][0]


def test_arrays_go_in_without_a_copy():
    array = rough()
    scan = scan_of(array)
    assert scan.heights is array
    assert scan.size == pytest.approx((SIZE, SIZE)) and scan.pixel_size == pytest.approx((SIZE / N, SIZE / N))


def test_arrays_come_out_without_a_copy(tmp_path):
    np.save(tmp_path / "map.npy", rough())
    scan = setae.read(tmp_path / "map.npy", size="5 um x 5 um", unit="m")
    assert address(scan.heights) == address(scan.heights)
    assert not scan.heights.flags.writeable and not scan.heights.flags.owndata
    psd = setae.power_spectrum(scan)
    handle = psd.columns["C1D"].base
    assert handle is not None and not psd.C1D.flags.owndata and not psd.C1D.flags.writeable


def test_an_array_outlives_its_scan(tmp_path):
    np.save(tmp_path / "map.npy", rough())
    heights = setae.read(tmp_path / "map.npy", size="5 um x 5 um", unit="m").heights
    densities = setae.power_spectrum(scan_of(rough())).C1D
    rubbish = [np.ones((N, N)) for _ in range(100)]
    assert len(rubbish) == 100
    np.testing.assert_array_equal(heights, rough())
    np.testing.assert_array_equal(densities, density(rough()))


def test_given_and_read_heights_are_the_same(tmp_path):
    np.save(tmp_path / "map.npy", rough())
    read = setae.power_spectrum(setae.read(tmp_path / "map.npy", size="5 um x 5 um", unit="m"))
    np.testing.assert_array_equal(read.C1D, density(rough()))
    np.testing.assert_array_equal(read.q, setae.power_spectrum(scan_of(rough())).q)


@pytest.mark.parametrize("age", [0.0, 60.0], ids=["just written", "written a minute ago"])
def test_a_file_that_changed_is_read_as_it_is(tmp_path, age):
    file = tmp_path / "map.txt"

    def written(heights, seconds_ago):
        np.savetxt(file, heights, fmt="%+.6e")
        os.utime(file, (time.time() - seconds_ago,) * 2)
        return setae.read(file, size="5 um x 5 um", unit="m")

    first, other, wide = rough(), -rough(), rough().reshape(N // 2, 2 * N)
    scan = written(first, age)
    np.savetxt(file, other, fmt="%+.6e")
    np.testing.assert_allclose(scan.heights, other.T, rtol=1e-6)
    scan = written(first, age)
    np.savetxt(file, wide, fmt="%+.6e")
    assert scan.heights.shape == (2 * N, N // 2)
    scans = [written(heights, age) for heights in (first, other)]
    for scan in scans:  # both scans are of this file
        np.testing.assert_allclose(scan.heights, other.T, rtol=1e-6)


@pytest.mark.parametrize(
    "same",
    [
        lambda a: np.asfortranarray(a),
        lambda a: np.repeat(a, 2, axis=0)[::2],
        lambda a: a[::-1][::-1],
        lambda a: a.astype(">f8"),
        lambda a: np.ma.masked_array(a, mask=np.zeros_like(a, dtype=bool)),
    ],
    ids=["fortran", "strided", "negative strides", "byte-swapped", "masked"],
)
def test_other_layouts_are_the_same_heights(same):
    np.testing.assert_array_equal(density(same(rough())), density(rough()))


def test_a_read_only_array_is_not_copied():
    array = rough()
    array.flags.writeable = False
    assert scan_of(array).heights is array
    np.testing.assert_array_equal(density(array), density(rough()))


def test_float32_and_integers_are_converted():
    single = rough(np.float32)
    np.testing.assert_array_equal(density(single), density(single.astype(np.float64)))
    steps = np.arange(N * N, dtype=np.int16).reshape(N, N) % 7
    np.testing.assert_array_equal(density(steps, unit="nm"), density(steps * 1e-9))


def test_arrays_in_memory_are_not_changed():
    array = rough()
    before = array.copy()
    scan = scan_of(array).level("polynomial").despike()
    assert scan.heights is not array
    setae.power_spectrum(scan)
    np.testing.assert_array_equal(array, before)


def test_masked_and_undefined_heights_are_nan():
    array = rough()
    mask = np.zeros_like(array, dtype=bool)
    mask[3:6, 7] = True
    holed = array.copy()
    holed[mask] = np.nan
    scan = scan_of(np.ma.masked_array(array, mask=mask))
    assert np.isnan(scan.heights).sum() == 3
    psd = setae.power_spectrum(scan)
    assert [alert.code for alert in psd.alerts].count("UNDEFINED") == 1
    np.testing.assert_array_equal(psd.C1D, density(holed))


@pytest.mark.parametrize(
    ("array", "arguments", "error", "words"),
    [
        (np.ones((4, 4, 4)), {}, setae.InvalidArgument, "3 dimensions"),
        (np.float64(1.0), {}, setae.InvalidArgument, "0 dimensions"),
        (np.ones(8), {}, setae.InvalidArgument, "2 sizes"),
        (np.ones((8, 8)), {"size": "5 um"}, setae.InvalidArgument, "1 sizes"),
        (np.ones((8, 8)), {"size": "5 um x 5 kg"}, setae.InvalidArgument, "kg"),
        (np.ones((8, 8)), {"size": 5e-6}, setae.InvalidArgument, "5e-06"),
        (np.ones((8, 8)), {"size": "-5 um x 5 um"}, setae.InvalidArgument, "size"),
        (np.ones((8, 8)), {"size": None}, setae.InvalidArgument, "size"),
        (np.ones((8, 8)), {"unit": None}, setae.InvalidArgument, "unit"),
        (np.ones((8, 8)), {"unit": "furlong"}, setae.InvalidArgument, "furlong"),
        (np.ones((8, 8)), {"unit": "kg"}, setae.InvalidArgument, "kg"),
        (np.full((8, 8), np.nan), {}, setae.UndefinedDataError, "array"),
        (np.full((8, 8), np.inf), {}, setae.InvalidArgument, "array"),
        (np.ones((1, 8)), {}, setae.InvalidArgument, "array"),
        (np.ones((0, 8)), {}, setae.InvalidArgument, "array"),
        (np.ones((8, 8), dtype=complex), {}, TypeError, "complex128"),
        (np.full((8, 8), "a"), {}, TypeError, "<U1"),
        (np.full((8, 8), None), {}, TypeError, "object"),
        ("text", {}, TypeError, "<U4"),
        (np.ones((8, 8)), {"instrument": "camera"}, setae.InvalidArgument, "stylus"),
        (np.ones((8, 8)), {"tip_radius": "10"}, setae.InvalidArgument, "10"),
        (np.ones((8, 8)), {"tip_radius": 10}, setae.InvalidArgument, "10"),
        (np.ones((8, 8)), {"tip_radius": [10]}, TypeError, "list"),
        (np.ones((8, 8)), {"trend": "cubic"}, setae.InvalidArgument, "cubic"),
    ],
)
def test_wrong_measurements_are_refused(array, arguments, error, words):
    with pytest.raises(error, match=words):
        scan_of(array, **arguments)


def test_an_unknown_step_is_refused():
    with pytest.raises(setae.InvalidArgument, match="level_plane"):
        scan_of(rough()).process("level_plan")
    with pytest.raises(setae.InvalidArgument, match="threshold"):
        scan_of(rough()).despike(treshold=3)
    assert "despike" in setae.steps()


def test_one_measurement_or_several():
    one, two = scan_of(rough()), scan_of(2 * rough(), name="second")
    several = setae.power_spectrum([one, two])
    assert several.n == 2 and "instrument_count" in several.columns
    assert setae.power_spectrum(one).n == setae.power_spectrum([one]).n == 1
    with pytest.raises(setae.InvalidArgument, match="at least one"):
        setae.power_spectrum([])


def test_xarray():
    xarray = pytest.importorskip("xarray")
    step = SIZE / N
    coordinates = {"x": 1e6 * step * np.arange(N), "y": 1e6 * step * np.arange(N)}
    given = xarray.DataArray(1e9 * rough(), dims=("x", "y"), coords=coordinates, attrs={"units": "nm"})
    for axis in "xy":
        given.coords[axis].attrs["units"] = "um"
    scan = setae.scan(given)
    np.testing.assert_allclose(scan.size, (SIZE, SIZE), rtol=1e-12)
    np.testing.assert_allclose(scan.heights, rough(), rtol=1e-15)
    back = scan.to_xarray()
    np.testing.assert_allclose(back.x, step * np.arange(N), rtol=1e-12)
    assert setae.power_spectrum(given).n == 1
    with pytest.raises(setae.InvalidArgument, match="no unit"):
        setae.scan(given.assign_coords(x=np.arange(N)))
    with pytest.raises(setae.InvalidArgument, match="equal steps"):
        setae.scan(given.assign_coords(x=("x", np.arange(N) ** 2, {"units": "um"})))


def test_like_surface_topography():
    class Topography:
        """The interface of a topography of SurfaceTopography."""

        physical_sizes, unit, is_periodic, is_uniform = (5.0, 5.0), "µm", True, True

        def heights(self):
            return 1e6 * rough()

    scan = setae.scan(Topography())
    assert scan.periodic and scan.size == pytest.approx((SIZE, SIZE))
    np.testing.assert_allclose(scan.heights, rough(), rtol=1e-15)
    assert setae.power_spectrum([Topography(), scan]).n == 2
    Topography.unit = None
    with pytest.raises(setae.InvalidArgument, match="no unit"):
        setae.scan(Topography())


def test_plots():
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("svg")
    scan = scan_of(rough())
    axes = scan.plot()
    assert axes.images[0].get_array().shape == (N, N)
    assert setae.power_spectrum(scan).plot(ax=axes.figure.subplots()).get_xscale() == "log"
    line = setae.scan(rough()[0], size="5 um", unit="m")
    assert len(line.plot().lines[0].get_xdata()) == N


def test_labels_of_log_axes_do_not_overlap():
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("agg")
    import matplotlib.pyplot as plt

    for points in (12, 24, N):  # from less than one decade of wavevectors to more
        ax = setae.power_spectrum(scan_of(rough()[:points, :points])).plot(ax=plt.figure(figsize=(3.4, 2.8)).subplots())
        ax.figure.canvas.draw()
        for axis in (ax.xaxis, ax.yaxis):
            low, high = axis.get_view_interval()
            ticks = [*axis.get_major_ticks(), *axis.get_minor_ticks()]
            shown = [tick.label1 for tick in ticks if low <= tick.get_loc() <= high and tick.label1.get_text()]
            boxes = [label.get_window_extent() for label in shown]
            assert len(shown) >= 2
            assert not any(a.overlaps(b) for i, a in enumerate(boxes) for b in boxes[:i])


def test_channels_have_numbers_and_names(tmp_path):
    rng = np.random.default_rng(3)
    first, second = rng.normal(size=(6, 5)), rng.normal(size=(6, 5))
    np.savez(tmp_path / "maps.npz", other=first, Height=second, index=np.arange(9.0))
    given = {"size": "6 um x 5 um", "unit": "m"}
    assert np.array_equal(setae.read(tmp_path / "maps.npz", **given).heights, second)
    assert np.array_equal(setae.read(tmp_path / "maps.npz", channel=0, **given).heights, first)
    assert np.array_equal(setae.read(tmp_path / "maps.npz", channel="oth", **given).heights, first)
    assert [channel["not_heights"] != "" for channel in setae.info(tmp_path / "maps.npz").channels] == [False, False, True]
    with pytest.raises(setae.InvalidArgument, match="no channel 'x'; there are 0 'other', 1 'Height', 2 'index'"):
        setae.read(tmp_path / "maps.npz", channel="x", **given)
