# SPDX-License-Identifier: GPL-3.0-or-later
"""Results are one family: mappings with names and symbols as keys and as attributes, with tables, plots and HTML."""

from __future__ import annotations

import pathlib
import pickle
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
import pytest
import setae

from conftest import ROOT

DATA = ROOT / "tests/cli/data"
SOLIDS = {"youngs_modulus": "0.7 MPa", "W_int": "37 mJ/m2", "surface_energy": "25 mJ/m2"}
BODY = {"contact_modulus": "1 GPa", "pressure": "10 MPa"}
ATTRACTION = {"contact_modulus": "1 MPa", "W_int": "50 mJ/m2", "interaction_range": "400 nm"}


@pytest.fixture(scope="module")
def scan() -> setae.Scan:
    return setae.synthesize(hurst_exponent=0.8, rolloff="1 um", short_cutoff="300 nm", rms_height="10 nm", size="5 um", pixels=32).scan


def spiky() -> setae.Scan:
    heights = 1e-9 * np.random.default_rng(1).standard_normal((64, 64))
    heights[3, 5] = 1e-6
    return setae.scan(heights, size="1 um x 1 um", unit="m")


#: Every kind of result, by the name of its class.
MAKERS: dict[str, Callable[[setae.Scan, pathlib.Path], Any]] = {
    "PowerSpectrum": lambda scan, data: setae.power_spectrum(scan),
    "Parameters": lambda scan, data: setae.parameters(scan),
    "Texture": lambda scan, data: setae.texture(scan, "iso25178", only="Sq, Sdr"),
    "Surface": lambda scan, data: setae.surface(scan),
    "WorkOfAdhesion": lambda scan, data: setae.work_of_adhesion(scan, **SOLIDS),
    "FunctionOfScale": lambda scan, data: setae.autocorrelation(scan),
    "Diagnosis": lambda scan, data: setae.check(spiky()),
    "Processing": lambda scan, data: scan.level().processing,
    "Info": lambda scan, data: setae.info(data / "rougher"),
    "Formats": lambda scan, data: setae.formats(),
    "Synthesis": lambda scan, data: setae.synthesize(hurst_exponent=0.8, rolloff="1 um", short_cutoff="300 nm", rms_height="10 nm", size="5 um", pixels=32),
    "Tip": lambda scan, data: setae.tip(scan, points=5),
    "Contact": lambda scan, data: setae.contact(scan, **BODY),
    "ContactSweep": lambda scan, data: setae.contact_sweep(scan, **ATTRACTION, to_pressure="1 kPa", maps=True),
    "ContactFront": lambda scan, data: setae.contact_front(
        scan, radius="10 um", contact_modulus="100 kPa", W_int="50 mJ/m2", to_displacement="100 nm", steps=20, shortest_wavelength="4 um"
    ),
    "PerssonContact": lambda scan, data: setae.persson(scan, **BODY),
    "ContactComparison": lambda scan, data: setae.contact_comparison(scan, **BODY, pixels="64", realisations=2, cell="5 um", shortest_wavelength="1 um"),
    "LoopFit": lambda scan, data: setae.loop(data / "loops/rougher_soft.csv", radius="1.25 mm").fit(),
    "LoopEnergy": lambda scan, data: setae.loop(data / "loops/rougher_soft.csv", radius="1.25 mm").energy(),
    "MachineStiffness": lambda scan, data: setae.loop(DATA / "loop_on_glass.csv").machine_stiffness(),
    "ForceCurves": lambda scan, data: setae.force_curves(DATA / "map.jpk-force-map", radius="1 mm"),
    "Lens": lambda scan, data: setae.lens(DATA / "lens_profile.csv", x="x", z="z"),
    "Camera": lambda scan, data: setae.camera(DATA / "ruling_upright.png", "20 um"),
    "ContactRadii": lambda scan, data: setae.contact_radii(DATA / "frames", pixel_size="2 um", frame_rate=10),
    "ContactLine": lambda scan, data: setae.contact_line(DATA / "frames", pixel_size="2 um", frame_rate=10, angles=64),
    "Contour": lambda scan, data: setae.contour(DATA / "wave.png", pixel_size="0.1 nm"),
    "Replicates": lambda scan, data: setae.replicates(DATA / "fits.csv", branch="loading", group_by=["surface", "lens"]),
    "Fitted": lambda scan, data: setae.loop(data / "loops/rougher_soft.csv", radius="1.25 mm").fit().points(),
    "SharedFit": lambda scan, data: setae.fit_together([setae.loop(data / f"loops/{name}_soft.csv", radius="1.25 mm") for name in ("rougher", "smoother")]),
    "StudyDraft": lambda scan, data: setae.draft_study(data / "rougher"),
    "PatchSurvey": lambda scan, data: setae.patch_survey(energy_shares=[0.05], points=[64], points_per_wave=[8], realisations=1),
    "ContainerReport": lambda scan, data: setae.check_container(DATA / "container_v0.zip"),
}
#: Results without numbers to draw.
NOT_DRAWN = {
    "Parameters", "Texture", "Diagnosis", "Processing", "Info", "Formats", "LoopEnergy", "MachineStiffness", "SharedFit", "StudyDraft", "Lens",
    "Camera", "Contour", "Replicates", "PatchSurvey", "ContainerReport",
}  # fmt: skip


@pytest.fixture(scope="module")
def results(scan: setae.Scan, data: pathlib.Path, tmp_path_factory: pytest.TempPathFactory) -> dict[str, setae.Result]:
    container = tmp_path_factory.mktemp("container") / "wafer.zip"
    written = setae.write_container(container, [DATA / "line.csv"])
    makers = {**MAKERS, "Container": lambda scan, data: written, "ContainerReport": lambda scan, data: setae.check_container(container)}
    return {name: make(scan, data) for name, make in makers.items()}


def test_the_list_has_every_class(results):
    classes = [value for value in vars(setae).values() if isinstance(value, type) and issubclass(value, setae.Result)]
    assert {c.__name__ for c in classes} - {"Result", "Answer", "StudyResult"} == results.keys()
    assert all(type(result).__name__ == name for name, result in results.items())


def test_results_are_mappings(results):
    for result in results.values():
        assert isinstance(result, Mapping) and len(result) == len(list(result)) > 0
        for name in result:
            assert name in result and isinstance(name, str)
            result[name]
        assert isinstance(result.to_dict(), dict) and result.to_dict()
        assert isinstance(result.alerts, tuple) and isinstance(result.quantities, tuple)
        assert result == result and hash(result) == hash(result)


def test_entries_are_attributes_and_completions(results):
    for result in results.values():
        own = [*dir(type(result)), *vars(result)]
        names = [name for name in result if name.isidentifier() and name not in own]
        assert names or isinstance(result, (setae.Contour, setae.Diagnosis, setae.Processing, setae.ContactRadii)) or len(result) < 6
        for name in names:
            assert getattr(result, name) is result[name] or getattr(result, name) == result[name]
            assert name in dir(result)
        assert set(result) <= set(result._ipython_key_completions_())
        with pytest.raises(AttributeError, match="no 'no_such_entry'; expected one of"):
            result.no_such_entry
        with pytest.raises(KeyError, match="no_such_entry"):
            result["no_such_entry"]


def test_symbols_are_keys(results):
    parameters = results["Parameters"]
    assert parameters["Sq"] is parameters["rms_height"] and "Sdq" in parameters._ipython_key_completions_()
    assert results["Texture"]["Sq"].quantity == "root_mean_square_height"
    assert results["LoopFit"]["E*"] is results["LoopFit"].E_star and results["LoopFit"]["E_loss"] is results["LoopFit"].loss
    assert results["WorkOfAdhesion"]["W_app"] == results["WorkOfAdhesion"].estimate
    assert results["Surface"]["h_rms"] is results["Surface"].rms_height
    with pytest.raises(KeyError, match="expected one of .*Sq"):
        parameters["Sqq"]


def test_numbers_of_contacts_are_quantities(results):
    solved = results["Contact"]
    assert solved.mean_pressure.to("MPa").value == pytest.approx(10.0) and solved["area_fraction"] < 1.0
    assert solved["contact_modulus"].unit == "Pa" and solved["status"] == "converged"
    assert results["ContactSweep"]["loss"].unit == "J/m2" and results["ContactSweep"]["interaction_range"].to("nm") == setae.quantity("400 nm")
    assert results["ContactFront"]["energy_loss"].unit == "J"
    again = setae.contact(setae.scan(solved.gaps, size="5 um x 5 um", unit="m"), contact_modulus="1 GPa", pressure=solved["mean_pressure"])
    assert again["mean_pressure"].value == pytest.approx(float(solved["mean_pressure"]))


def test_a_part_is_one_object(results):
    fit = results["LoopFit"]
    assert fit["loading"] is fit["loading"] is fit.loading and fit.E_star is fit["loading"]["contact_modulus"]


def test_every_result_has_html_without_empty_tables(results):
    for name, result in results.items():
        shown = result._repr_html_()
        assert shown.startswith("<") and len(shown) > 20, name
        assert "<table></table>" not in shown and "<ul></ul>" not in shown and "<td></td></tr></table>" not in shown, name
        assert repr(result) and "Quantity(" not in repr(result), name
    assert "E_loss" in results["LoopFit"]._repr_html_() and "contact modulus" in results["LoopFit"]._repr_html_()
    assert "autocorrelation [m2]" in results["FunctionOfScale"]._repr_html_() and "area_fraction" in results["PerssonContact"]._repr_html_()
    assert setae.check(setae.scan(np.ones((8, 8)) + np.eye(8), size="8 um x 8 um", unit="nm"))._repr_html_()
    assert setae.Answer("{}")._repr_html_() == "<p>Answer: empty</p>"


def test_tables(results):
    pandas = pytest.importorskip("pandas")
    for name, result in results.items():
        table = result.to_pandas()
        assert isinstance(table, pandas.DataFrame) and (len(table) > 0 or name in ("Container", "StudyDraft")), name
    parameters = results["Parameters"].to_pandas()
    assert parameters.set_index("symbol").loc["Sq", "value"] == results["Parameters"]["Sq"].value
    curves = results["ForceCurves"].to_pandas()
    assert len(curves) == 4 and curves.attrs["units"]["contact_modulus"] == "Pa"
    frame = results["PowerSpectrum"].to_pandas()
    assert frame.attrs["units"]["C1D"] == "m3" and list(frame) == list(results["PowerSpectrum"].columns)


def test_maps_are_datasets(results):
    pytest.importorskip("xarray")
    solved = results["Contact"]
    maps = solved.to_xarray()
    assert maps.pressure.dims == ("x", "y") and maps.pressure.attrs["units"] == "Pa" and maps.x.attrs["units"] == "m"
    np.testing.assert_array_equal(maps.gap.values, solved.gaps)
    assert float(maps.x[1] - maps.x[0]) == pytest.approx(5e-6 / 32)
    assert results["ContactSweep"].map_dataset("turn").gap.shape == (32, 32)
    assert results["PerssonContact"].to_xarray().area_fraction.dims == ("wavevector",)


def test_plots_take_axes_and_style(results, scan, data):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("agg")
    import matplotlib.pyplot as plt

    drawn = {name: result for name, result in results.items() if hasattr(type(result), "plot")}
    assert results.keys() - drawn.keys() == NOT_DRAWN | {"Container"}
    loop = setae.loop(data / "loops/rougher_soft.csv", radius="1.25 mm")
    curve = setae.force_curves(DATA / "map.jpk-force-map", radius="1 mm", curve_number=1)
    for name, result in {**drawn, "Scan": scan, "Loop": loop, "ForceCurves": curve}.items():
        figure, ax = plt.subplots()
        style = {"alpha": 0.5} if name in ("Scan", "Contact", "Synthesis", "Tip") else {"color": "tab:red", "linewidth": 3}
        assert result.plot(ax=ax, **style) is ax, name
        assert isinstance(result.plot(), matplotlib.axes.Axes), name
        artist = ax.images[0] if ax.images else ax.lines[0]
        assert artist.get_alpha() == 0.5 if "alpha" in style else artist.get_color() == "tab:red", name
        plt.close("all")
    with pytest.raises(setae.InvalidArgument, match="expected pressure or gap"):
        results["Contact"].plot(of="force")


def test_maps_have_the_orientation_of_the_program():
    """The figures of the program draw x to the right and y upwards."""
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("agg")
    heights = np.zeros((4, 3))
    heights[3, 0] = 1e-9
    image = setae.scan(heights, size="4 um x 3 um", unit="m").plot().images[0]
    assert image.origin == "lower" and image.get_extent() == pytest.approx([0, 4, 0, 3])
    assert image.get_array()[0, 3] == pytest.approx(1.0)


def test_findings_are_kept_by_code(results):
    found = results["Diagnosis"]
    assert "SPIKES" in found and found["SPIKES"][0].alert.code == "SPIKES" and found["SPIKES"][0].effects
    assert found.to_dict()["SPIKES"][0]["code"] == "SPIKES"


def test_results_are_pickled_with_their_parts(results):
    for name, result in results.items():
        other = pickle.loads(pickle.dumps(result))
        assert other.json() == result.json() and list(other) == list(result), name
