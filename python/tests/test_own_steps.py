# SPDX-License-Identifier: GPL-3.0-or-later
"""Functions of Python as processing steps: the same numbers as without setae, the record of the steps, and what is refused."""

from __future__ import annotations

import functools
import pickle

import numpy as np
import pint
import pytest
import scipy.ndimage
import setae
import xarray

SIDE = "32 um x 16 um"


def rough() -> setae.Scan:
    heights = np.random.default_rng(7).normal(size=(32, 16))
    heights[3, 4] = np.nan
    return setae.scan(heights, size=SIDE, unit="nm", tip_radius="10 nm", name="rough.csv")


def median(heights, size):
    return scipy.ndimage.median_filter(heights, size=size)


def test_a_function_of_scipy_changes_the_heights():
    scan = rough()
    filtered = scan.process(scipy.ndimage.median_filter, size=3)
    assert np.array_equal(filtered.heights, scipy.ndimage.median_filter(scan.heights, size=3), equal_nan=True)
    assert filtered.size == scan.size and filtered.name == "rough.csv" and filtered.tip_radius == "10 nm"
    assert np.isnan(scan.heights[3, 4])


def test_steps_are_recorded_in_their_order():
    scan = rough().process(["fill_undefined", functools.partial(median, size=3), "level_plane"]).process(np.fliplr)
    names = [step.step for step in scan.processing.steps]
    assert names == ["fill_undefined", "median(size=3)", "level_plane", "fliplr()"] == scan.processing.data["pipeline"]
    assert {q.quantity for q in scan.processing.steps[2].numbers} >= {"removed_slope_x", "areal_rms_height"}
    assert "median(size=3)" in repr(scan.processing) and "fliplr()" in scan._repr_html_()
    assert float(setae.parameters(scan)["Sq"]) == pytest.approx(float(setae.parameters(setae.scan(scan.heights, scan.size, "m"))["Sq"]), rel=1e-12)


def test_library_steps_give_the_same_heights_around_a_function():
    by_hand = setae.scan(2.0 * rough().level().heights, SIDE, "m").process("level_mean")
    assert np.array_equal(rough().process(["level_plane", lambda h: 2.0 * h, "level_mean"]).heights, by_hand.heights, equal_nan=True)


def test_a_scan_may_have_another_size():
    def half(heights, scan):
        length, width = map(float, scan.size)
        return setae.scan(heights[:16], size=(f"{length / 2} m", f"{width} m"), unit="m")

    cut = rough().process(half)
    assert cut.heights.shape == (16, 16) and cut.size == pytest.approx((16e-6, 16e-6)) and cut.tip_radius == "10 nm"
    assert [step.step for step in cut.processing.steps] == ["half()"]
    again = rough().process(lambda heights, scan: scan.level().process("crop", x_from="0 um", x_to="8 um"))
    assert again.heights.shape[0] < 12 and len(again.processing.steps) == 1


@pytest.mark.parametrize(
    ("made", "problem"),
    [
        (lambda h: None, "returned None"),
        (lambda h: h[1:], r"shape \(31, 16\); expected \(32, 16\)"),
        (lambda h: h.astype(complex), "complex128; expected real numbers"),
        (lambda h: h / 0.0, "infinite heights"),
        (lambda h: pint.UnitRegistry().Quantity(h, "s"), "'s'|second"),
        (lambda h: 1.0, r"shape \(\)"),
    ],
)
@pytest.mark.filterwarnings("ignore::RuntimeWarning")
def test_wrong_results_are_refused_with_the_step(made, problem):
    with pytest.raises(setae.InvalidArgument, match=rf"step 2 <lambda>\(\): .*({problem})"):
        rough().process(["level_mean", made])


def test_units_are_converted():
    expected = rough().heights
    with_unit = rough().process(lambda h: pint.UnitRegistry().Quantity(1e9 * h, "nm"))
    labelled = rough().process(lambda h: xarray.DataArray(1e6 * h, dims=("x", "y"), attrs={"units": "um"}))
    assert np.allclose(with_unit.heights, expected, rtol=1e-14, equal_nan=True)
    assert np.allclose(labelled.heights, expected, rtol=1e-14, equal_nan=True)


def test_an_error_of_the_function_names_the_step():
    with pytest.raises(setae.Error, match=r"step 1 median\(size=-1\): ") as raised:
        rough().process(median, size=-1)
    assert raised.value.__cause__ is not None
    with pytest.raises(TypeError, match="common parameters"):
        rough().process([median], size=3)


def test_traced_curves_keep_their_positions():
    curve = setae.scan([0.0, 2.0, 1.0], x=[0.0, 1.0, 4.0], unit="um, nm").process(lambda h: -h)
    assert curve.positions == pytest.approx([0.0, 1e-6, 4e-6]) and curve.heights == pytest.approx([0.0, -2e-9, -1e-9])


def test_the_result_pickles_without_the_function():
    scan = pickle.loads(pickle.dumps(rough().process(["fill_undefined", lambda h: h + 1e-9, "level_mean"])))
    assert [step.step for step in scan.processing.steps] == ["fill_undefined", "<lambda>()", "level_mean"]


def test_warnings_about_reading_are_kept(tmp_path):
    file = tmp_path / "marked.csv"
    heights = np.random.default_rng(1).normal(size=(8, 8))
    heights[::5, ::5] = -9999.0
    np.savetxt(file, heights, delimiter=",")
    scan = setae.read(file, size="8 um x 8 um", unit="nm")
    assert scan.alerts and scan.process(np.nan_to_num).alerts == scan.alerts
