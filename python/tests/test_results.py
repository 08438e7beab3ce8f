# SPDX-License-Identifier: GPL-3.0-or-later
"""Results are small, frozen, and can be copied and pickled."""

from __future__ import annotations

import copy
import dataclasses
import math
import pickle

import numpy as np
import pytest
import setae


@pytest.fixture(scope="module")
def scan() -> setae.Scan:
    heights = 1e-8 * np.random.default_rng(1).standard_normal((64, 64)).cumsum(axis=0)
    return setae.scan(heights, size="5 um x 5 um", unit="m", tip_radius="10 ± 1 nm", instrument="afm")


def test_a_quantity_is_a_number_in_si(scan):
    slope = setae.surface([scan, scan.process("crop", x_from="1 um", x_to="4 um")], spectrum="average")["rms_slope"]
    assert float(slope) == slope.value and slope.unit == "1" and slope.n == 2
    assert slope.interval.lower < slope.value < slope.interval.upper and slope.interval.level == 0.95
    assert slope.band.lower < slope.band.upper and slope.source
    assert math.isnan(setae.parameters(scan)["rms_slope"].standard_error)


def test_results_are_valid_arguments():
    radius = setae.Quantity("tip_radius", "R", 1e-8, "m", standard_error=2e-9)
    wave = setae.scan(1e-9 * np.sin(np.arange(512.0)), size="2 um", unit="m")
    by_quantity = setae.power_spectrum(wave, tip_radius=radius, instrument="afm")
    assert by_quantity.json() == setae.power_spectrum(wave, tip_radius="1e-08 ± 2e-09 m", instrument="afm").json()


@pytest.mark.parametrize("make", [setae.power_spectrum, setae.parameters, setae.surface, lambda s: s, lambda s: s.level().processing])
@pytest.mark.parametrize("moved", [copy.copy, copy.deepcopy, lambda r: pickle.loads(pickle.dumps(r))])
def test_results_are_copied_and_pickled(scan, make, moved):
    result = make(scan)
    other = moved(result)
    if isinstance(result, setae.Scan):
        np.testing.assert_array_equal(other.heights, result.heights)
        assert other.tip_radius == result.tip_radius
        return
    assert other.json() == result.json()
    assert other.alerts == result.alerts
    if hasattr(result, "columns"):
        np.testing.assert_array_equal(other.q, result.q)


def test_a_pickled_surface_is_analysed_again(scan):
    surface = setae.surface(scan)
    solids = {"youngs_modulus": "0.7 MPa", "W_int": "37 mJ/m2", "surface_energy": "25 mJ/m2"}
    other = pickle.loads(pickle.dumps(surface))
    assert setae.work_of_adhesion(other, **solids).json() == setae.work_of_adhesion(surface, **solids).json()


def test_results_are_frozen(scan):
    psd = setae.power_spectrum(scan)
    with pytest.raises(dataclasses.FrozenInstanceError):
        psd.text = ""
    with pytest.raises(dataclasses.FrozenInstanceError):
        scan.steps = ()
    with pytest.raises(ValueError, match="read-only"):
        psd.C1D[0] = 1.0
    with pytest.raises(TypeError):
        setae.parameters(scan)["rms_slope"] = 1.0


def test_results_have_html_for_notebooks(scan):
    surface = setae.surface(scan)
    work = setae.work_of_adhesion(surface, youngs_modulus="0.7 MPa", W_int="37 mJ/m2", surface_energy="25 mJ/m2")
    for shown in (scan, scan.level(), setae.power_spectrum(scan), setae.parameters(scan), surface, work, work.estimate, scan.level().processing):
        assert shown._repr_html_().startswith("<") and repr(shown)
    known = setae.Quantity("work_of_adhesion", "W", 0.03709, "J/m2", 0.0021, setae.Interval(0.03262, 0.04156))
    assert known._repr_html_().startswith("<i>W</i> = <span") and "\u00a0mJ m⁻²" in known.to_html() and "95 % interval" in known.to_html()
    assert repr(work) == f"WorkOfAdhesion(W_app = {work.estimate})" and "mJ/m²" in repr(work)


def test_a_fit_begins_with_its_numbers(data):
    fit = setae.loop(data / "loops/rougher_soft.csv", radius="1.25 mm").fit()
    assert repr(fit) == f"LoopFit(E* = {fit.E_star}, W = {fit.W}, E_loss = {fit.loss})"


def test_columns_of_a_loop_are_chosen(data, tmp_path):
    whole = setae.loop(data / "loops/rougher_soft.csv", radius="1.25 mm")
    time, force, displacement = (whole[name] for name in ("time", "force", "displacement"))
    rows = "".join(f"{t!r},{-1e6 * f!r},{1e6 * d!r}\n" for t, f, d in zip(time.tolist(), force.tolist(), displacement.tolist()))
    table = tmp_path / "kraft.csv"
    table.write_text("Zeit [s],Kraft,Weg [um]\n" + rows)
    with pytest.raises(setae.FormatError, match="has no unit"):
        setae.loop(table, radius="1.25 mm")
    loop = setae.loop(table, radius="1.25 mm", columns={"force": "-1 uN * kraft"})
    assert np.allclose(loop["force"], force, rtol=1e-12, atol=0) and np.allclose(loop["displacement"], displacement, rtol=1e-12, atol=0)
    with pytest.raises(setae.UndefinedDataError, match='--column force="-1 \\* kraft\\[uN\\]"'):
        setae.loop(table, radius="1.25 mm", columns={"force": "Kraft[uN]"}).fit()


def test_one_model_may_be_given_as_a_text(data):
    loop = setae.loop(data / "loops/rougher_soft.csv", radius="1.25 mm")
    assert loop.fit(models="jkr").json() == loop.fit(models=["jkr"]).json()
    with pytest.raises(setae.InvalidArgument, match="unknown contact model 'jkk'"):
        loop.fit(models="jkk")


def test_other_packages_accept_results(scan):
    pandas, xarray = pytest.importorskip("pandas"), pytest.importorskip("xarray")
    psd = setae.power_spectrum(scan)
    frame = psd.to_pandas()
    assert isinstance(frame, pandas.DataFrame) and frame.attrs["units"]["C1D"] == "m3"
    assert isinstance(psd.to_xarray(), xarray.Dataset) and psd.to_xarray().C1D.attrs["units"] == "m3"


def test_uncertainties_and_pint():
    pytest.importorskip("uncertainties"), pytest.importorskip("pint")
    work = setae.Quantity("work_of_adhesion", "W", 37e-3, "J/m2", standard_error=2e-3)
    assert work.to_uncertainties().std_dev == 2e-3
    assert work.to_pint().value.to("mJ/m**2").magnitude == pytest.approx(37.0)


def test_parts_of_an_answer(scan):
    work = setae.work_of_adhesion(setae.surface(scan), youngs_modulus="0.7 MPa", W_int="37 mJ/m2", surface_energy="25 mJ/m2")
    assert float(work) == work["work_of_adhesion"].value
    assert work["answers"]["recommended"] == "patches"
    assert isinstance(work["scales"], setae.Answer) and len(work["scales"]["gained"]) == len(work["scales"]["wavevector"])
    with pytest.raises(KeyError):
        work["no such thing"]
    with pytest.raises(TypeError, match="analysed already"):
        setae.work_of_adhesion(setae.surface(scan), youngs_modulus="0.7 MPa", W_int="37 mJ/m2", surface_energy="25 mJ/m2", tip_radius="3 nm")


def test_budgets_contain_inputs_of_loops(data, tmp_path):
    """W ∝ F/R, E_loss ∝ F: a study with known errors, one per cent of the radius of the lens and two of the force."""
    text = (data / "study.toml").read_text().replace('file = "', f'file = "{data}/')
    text = text.replace('sphere_radius = "0.00125 m"', 'sphere_radius = "lens = 0.00125 ± 0.0000125 m"')
    text = text.replace("[[experiments]]\n", '[[experiments]]\nforce_calibration = "cell = 1 ± 0.02"\n')
    (tmp_path / "study.toml").write_text(text)
    pairs = setae.study(tmp_path / "study.toml").run(output=tmp_path / "results").data["pairs"]
    assert len(pairs) == 4
    both = math.hypot(0.01, 0.02)
    for name, share in (("work_of_adhesion_approach", both), ("work_of_adhesion_retraction", both), ("energy_loss", 0.02)):
        for pair in pairs:
            value = pair["measured"][name]
            parts = value["standard_error_budget"]
            assert parts["shared_inputs"] == pytest.approx(share * value["value"], rel=2e-3)
            assert parts["own_noise"] == value["standard_error"] > 0
            assert parts["all"] ** 2 == pytest.approx(parts["own_noise"] ** 2 + parts["shared_inputs"] ** 2)
