# SPDX-License-Identifier: GPL-3.0-or-later
"""Everything that the package returns is accepted by everything that takes its kind: one test for each pair of producer and consumer."""

from __future__ import annotations

import pathlib
from collections.abc import Callable
from functools import cache
from typing import Any

import numpy as np
import pytest
import setae

from conftest import ROOT

pytest.importorskip("pandas"), pytest.importorskip("xarray")

CLI_DATA = ROOT / "tests/cli/data"
SOLIDS = {"youngs_modulus": "1 MPa", "W_int": "50 mJ/m2", "surface_energy": "25 mJ/m2"}
PRESSED = {"contact_modulus": "1 MPa", "pressure": "10 kPa"}
MADE = {"pixels": 32, "cell": "2 um"}
MOMENTS = {"rms_height": "4 nm", "rms_slope": 0.4, "rms_curvature": "1 1/nm", "short_wavevector": "1e10 1/m"}

Folder = pathlib.Path


@cache
def synthesis() -> setae.Synthesis:
    return setae.synthesize(hurst_exponent=0.8, rolloff="1 um", short_cutoff="126 nm", rms_height="10 nm", size="2 um", pixels=32, amplitudes="exact")


def rough_map() -> setae.Scan:
    return synthesis().scan


def rough_line() -> setae.Scan:
    return setae.scan(rough_map().heights[:, 0].copy(), size=rough_map().size[0], unit="m")


def curve() -> setae.Scan:
    x = np.sort(np.random.default_rng(1).uniform(0.0, 20.0, 200))
    return setae.scan(10.0 * np.sin(x), x=x, unit="um, nm")


def saved(scan: setae.Scan, file: Folder) -> Folder:
    scan.save(file)
    return file


def container(folder: Folder) -> Folder:
    setae.write_container(folder / "container.zip", [rough_map()])
    return folder / "container.zip"


def psd_file(folder: Folder) -> Folder:
    psd = setae.power_spectrum(rough_map())
    psd.to_pandas().rename(columns=lambda name: f"{name} [{psd.units[name]}]").to_csv(folder / "psd.csv", index=False)
    return folder / "psd.csv"


def contact() -> setae.Contact:
    return setae.contact(rough_map(), **PRESSED)


@cache
def loop(folder: Folder) -> setae.Loop:
    return setae.loop(folder / "loops/rougher_soft.csv", radius="1.25 ± 0.01 mm")


@cache
def fit(folder: Folder) -> setae.LoopFit:
    return loop(folder).fit()


@cache
def work() -> setae.WorkOfAdhesion:
    return setae.work_of_adhesion(rough_map(), **SOLIDS)


@cache
def line_of_contact() -> setae.ContactLine:
    return setae.contact_line(CLI_DATA / "frames", pixel_size="2 um", frame_rate=10, angles=32)


@cache
def front() -> setae.ContactFront:
    x = np.arange(32) / 32
    wave = setae.scan(2e-9 * np.sin(8 * np.pi * x)[:, None] * np.ones(32), size="64 um x 64 um", unit="m", periodic=True)
    return setae.contact_front(wave, radius="1 mm", contact_modulus="1 MPa", W_int="50 mJ/m2", to_displacement="0.2 um", steps=20, duration="10 s")


@cache
def study() -> setae.Study:
    made = setae.Study(title="published").rough_solid(youngs_modulus="70 GPa", poisson_ratio=0.2).surface("A", moments=MOMENTS)
    for name, modulus, approach in (("soft", "0.7 MPa", "40 ± 2 mJ/m2"), ("stiff", "2 MPa", "38 ± 2 mJ/m2")):
        made = made.elastomer(name, youngs_modulus=modulus, surface_energy="25 mJ/m2").pair("A", name, approach=approach)
    return made


Producer = Callable[[Folder, Folder], Any]  #: of the folder of the tutorial and an empty folder

#: What the package returns, by kind.
PRODUCERS: dict[str, dict[str, Producer]] = {
    "map": {
        "synthesize": lambda data, folder: synthesis(),
        "Synthesis.scan": lambda data, folder: rough_map(),
        "Scan.level": lambda data, folder: rough_map().level(),
        "Scan.to_xarray": lambda data, folder: rough_map().to_xarray(),
        "Scan.heights and size": lambda data, folder: setae.scan(rough_map().heights, size=rough_map().size, unit="m"),
        "Scan.save": lambda data, folder: saved(rough_map(), folder / "map.nc"),
        "channels of a container": lambda data, folder: setae.channels(container(folder))[0],
        "Contact.gaps": lambda data, folder: setae.scan(contact().gaps, size=rough_map().size, unit="m", periodic=True),
        "Contact.to_xarray": lambda data, folder: contact().to_xarray()["gap"],
    },
    "line": {
        "line": lambda data, folder: rough_line(),
        "curve": lambda data, folder: curve(),
        "curve.to_xarray": lambda data, folder: curve().to_xarray(),
        "curve.save": lambda data, folder: saved(curve(), folder / "curve.csv"),
        "Contour": lambda data, folder: setae.contour(CLI_DATA / "mushroom.png", pixel_size="1 nm"),
    },
    "spectrum": {
        "power_spectrum": lambda data, folder: setae.power_spectrum(rough_map(), isotropic=True),
        "power_spectrum of two": lambda data, folder: setae.power_spectrum([rough_map(), rough_line()]),
        "PowerSpectrum.to_pandas": lambda data, folder: setae.power_spectrum(rough_map()).to_pandas(),
        "PowerSpectrum.to_xarray": lambda data, folder: setae.power_spectrum(rough_map()).to_xarray(),
        "surface": lambda data, folder: setae.surface([rough_map(), rough_line()], spectrum="average"),
        "fitted surface": lambda data, folder: setae.surface([rough_map(), rough_line()], tip_radius="10 nm"),
        "table": lambda data, folder: psd_file(folder),
    },
    "loop": {
        "loop": lambda data, folder: loop(data),
        "Loop.columns": lambda data, folder: loop(data).columns,
        "Loop.to_pandas": lambda data, folder: loop(data).to_pandas(),
        "Loop.to_xarray": lambda data, folder: loop(data).to_xarray(),
        "loop of a table": lambda data, folder: setae.loop(loop(data).to_pandas()),
    },
    "edge": {
        "contact_line": lambda data, folder: line_of_contact(),
        "ContactLine.edge": lambda data, folder: line_of_contact().edge,
        "contact_front": lambda data, folder: front(),
        "ContactFront.edge": lambda data, folder: front().edge,
    },
    "length": {
        "Scan.size": lambda data, folder: rough_map().size[0],
        "Scan.pixel_size": lambda data, folder: rough_map().pixel_size[0],
        "Tip.radius": lambda data, folder: setae.tip(rough_map()).radius,
        "Lens.radius": lambda data, folder: setae.lens(CLI_DATA / "lens_profile.csv").radius,
        "Camera.pixel_size": lambda data, folder: setae.camera(CLI_DATA / "ruling_upright.png", "20 um").pixel_size,
    },
    "pressure": {
        "contact": lambda data, folder: contact()["mean_pressure"],
        "LoopFit.E_star": lambda data, folder: fit(data).E_star,
    },
    "energy": {
        "LoopFit.W": lambda data, folder: fit(data).W,
        "WorkOfAdhesion.estimate": lambda data, folder: work().estimate,
        "StudyResult.work_of_adhesion": lambda data, folder: study().run(output=folder).work_of_adhesion,
    },
    "study": {
        "Study": lambda data, folder: study(),
        "Study.to_toml": lambda data, folder: study().to_toml(folder / "written/study.toml"),
        "study of a file": lambda data, folder: setae.study(study().to_toml(folder / "written/study.toml").file or ""),
    },
}

Consumer = Callable[[Any, Folder], Any]  #: of a value and an empty folder

MEASUREMENT: dict[str, Consumer] = {
    "power_spectrum": lambda value, folder: setae.power_spectrum(value).C1D,
    "parameters": lambda value, folder: setae.parameters(value)["rms_height_from_spectrum"],
    "surface": lambda value, folder: setae.surface(value)["rms_height"],
    "work_of_adhesion": lambda value, folder: setae.work_of_adhesion(value, **SOLIDS),
    "persson": lambda value, folder: setae.persson(value, **PRESSED)["area_fraction"],
    "contact_comparison": lambda value, folder: setae.contact_comparison(
        value, **PRESSED, pixels="64", cell="2 um", realisations=1, shortest_wavelength="250 nm", longest_wavelength="2 um"
    )["area_fraction"],
    "Study.surface": lambda value, folder: setae.Study().surface("A", value).run(output=folder / "study")["surfaces"]["A"]["rms_height"],
}
HEIGHTS: dict[str, Consumer] = {
    "scan": lambda value, folder: setae.scan(setae.read(value) if isinstance(value, pathlib.Path) else value).heights,
    "several": lambda value, folder: setae.surface([value, value], spectrum="average")["rms_height"],
    "scale_dependent_roughness": lambda value, folder: setae.scale_dependent_roughness(value).value,
    "autocorrelation": lambda value, folder: setae.autocorrelation(value).value,
    "variable_bandwidth": lambda value, folder: setae.variable_bandwidth(value).value,
    "check": lambda value, folder: setae.check(value),
    "write_container": lambda value, folder: setae.write_container(folder / "out.zip", [value])["measurements"],
}

#: What takes a kind.
CONSUMERS: dict[str, dict[str, Consumer]] = {
    "map": {
        **MEASUREMENT,
        **HEIGHTS,
        "texture": lambda value, folder: setae.texture(value, "iso25178", only="Sq")["Sq"],
        "tip": lambda value, folder: setae.tip(value, points=5).radius,
        "contact": lambda value, folder: setae.contact(value, **PRESSED)["area_fraction"],
        "contact_sweep": lambda value, folder: setae.contact_sweep(
            value, contact_modulus="1 MPa", W_int="50 mJ/m2", interaction_range="100 nm", to_gap="30 nm", max_move=2.0
        )["mean_gap"],
    },
    "line": {**{name: MEASUREMENT[name] for name in MEASUREMENT if name != "contact_comparison"}, **HEIGHTS},
    "spectrum": {
        **{name: MEASUREMENT[name] for name in MEASUREMENT if name != "Study.surface"},
        "contact": lambda value, folder: setae.contact(value, **PRESSED, **MADE)["area_fraction"],
        "synthesize": lambda value, folder: setae.synthesize(spectrum=value, size="2 um", pixels=32).scan.heights,
        "Study.surface(power_spectrum=)": lambda value, folder: setae.Study()
        .surface("A", power_spectrum=value)
        .run(output=folder / "study")["surfaces"]["A"]["rms_height"],
    },
    "loop": {
        "loop": lambda value, folder: setae.loop(value, radius="1.25 mm").fit().W,
        "force_curves": lambda value, folder: setae.force_curves(value, radius="1.25 mm", model="jkr")["segments"],
        "Study.pair": lambda value, folder: setae.Study()
        .rough_solid(youngs_modulus="70 GPa", poisson_ratio=0.2)
        .surface("A", moments=MOMENTS)
        .elastomer("soft", surface_energy="25 mJ/m2", sphere_radius="1.25 mm")
        .pair("A", "soft", value)
        .run(output=folder / "study")["experiments"][0]["analysis"],
    },
    "edge": {"contact_line": lambda value, folder: setae.contact_line(value)["mean_radius"]},
    "length": {
        "scan(size=)": lambda value, folder: setae.scan(rough_line().heights, size=value, unit="m").size[0],
        "scan(tip_radius=)": lambda value, folder: setae.scan(rough_line().heights, size="2 um", unit="m", tip_radius=value).tip_radius,
        "loop(radius=)": lambda value, folder: setae.loop(CLI_DATA / "loop_on_glass.csv", radius=value).bodies,
        "contact(displacement=)": lambda value, folder: setae.persson(rough_map(), **PRESSED, layer_thickness=value, poisson_ratio=0.4, bonded=True)["mean_gap"],
        "Study.elastomer": lambda value, folder: setae.Study().elastomer("soft", surface_energy="25 mJ/m2", sphere_radius=value),
    },
    "pressure": {
        "contact(pressure=)": lambda value, folder: setae.contact(rough_map(), contact_modulus="1 MPa", pressure=value)["area_fraction"],
        "persson(contact_modulus=)": lambda value, folder: setae.persson(rough_map(), contact_modulus=value, pressure="1 kPa")["area_fraction"],
        "work_of_adhesion(youngs_modulus=)": lambda value, folder: setae.work_of_adhesion(rough_map(), youngs_modulus=value, W_int="50 mJ/m2", surface_energy="25 mJ/m2"),
    },
    "energy": {
        "work_of_adhesion(W_int=)": lambda value, folder: setae.work_of_adhesion(rough_map(), youngs_modulus="1 MPa", W_int=value, surface_energy="25 mJ/m2"),
        "persson(W_int=)": lambda value, folder: setae.persson(rough_map(), **PRESSED, W_int=value)["area_fraction"],
        "Study(work_of_adhesion=)": lambda value, folder: setae.Study(work_of_adhesion=value).surface("A", moments=MOMENTS).run(output=folder / "study"),
    },
    "study": {
        "Study.run": lambda value, folder: value.run(output=folder / "results").work_of_adhesion,
        "patch_survey": lambda value, folder: setae.patch_survey(
            value.run(output=folder / "results"), points=[64], points_per_wave=[8], waves_per_side=2, squared_ratios=[1], realisations=1
        ),
        "contact of the study's file": lambda value, folder: setae.contact(
            value.run(output=folder / "results").file, **PRESSED, surface="A", pixels=32, cell="100 nm"
        )["area_fraction"],
    },
}

PAIRS = [
    pytest.param(produce, consume, id=f"{produced} -> {consumed}")
    for kind, producers in PRODUCERS.items()
    for produced, produce in producers.items()
    for consumed, consume in CONSUMERS[kind].items()
]


@pytest.mark.parametrize(("produce", "consume"), PAIRS)
def test_what_is_returned_is_taken(produce: Producer, consume: Consumer, data: Folder, tmp_path: Folder):
    found = consume(produce(data, tmp_path), tmp_path)
    if isinstance(found, np.ndarray):
        assert found.size and np.isfinite(found).any()
    elif isinstance(found, (float, setae.Quantity)):
        assert np.isfinite(float(found))


def test_every_kind_has_producers_and_consumers():
    assert PRODUCERS.keys() == CONSUMERS.keys()


def same(first: Any, second: Any) -> None:
    np.testing.assert_allclose(first, second, rtol=1e-12, atol=1e-12 * float(np.max(np.abs(second))))


def test_the_numbers_survive(tmp_path):
    """One path through each kind gives the numbers of the direct way."""
    scan = rough_map()
    same(setae.scan(scan.to_xarray()).heights, scan.heights)
    assert setae.scan(scan.to_xarray()).periodic and not setae.scan(scan.to_xarray()[4:]).periodic
    psd = setae.power_spectrum(scan)
    assert setae.persson(psd, **PRESSED).json() == setae.persson(psd_file(tmp_path), **PRESSED).json().replace(f"{tmp_path}/psd.csv", "table")
    pressed = contact()
    again = setae.contact(scan, contact_modulus="1 MPa", pressure=pressed["mean_pressure"])
    same(again.gaps, pressed.gaps)
    surface = setae.surface([scan, rough_line()], spectrum="average")
    assert float(setae.surface(surface)["rms_slope"]) == pytest.approx(float(surface["rms_slope"]), rel=0.01)  # of the table, by trapezoids


def test_maps_of_the_program_have_coordinates(tmp_path, printed):
    """OUT.nc of a contact command: pressure and gap on the grid of the heights, read by xarray."""
    xarray = pytest.importorskip("xarray")
    pytest.importorskip("scipy")
    heights, maps = saved(rough_map(), tmp_path / "map.nc"), tmp_path / "contact.nc"
    printed("contact", "solve", heights, "--contact-modulus", "1 MPa", "--pressure", "10 kPa", "-o", maps)
    with xarray.open_dataset(maps, engine="scipy") as dataset:
        dataset.load()
    solved = setae.contact(heights, **PRESSED)
    np.testing.assert_array_equal(dataset.gap, solved.gaps)
    np.testing.assert_array_equal(dataset.pressure, solved.pressures)
    assert dataset.pressure.attrs["units"] == "Pa" and dataset.gap.dims == ("x", "y")
    gap = setae.scan(dataset.gap)
    same(gap.heights, solved.gaps)
    same(gap.size, rough_map().size)
