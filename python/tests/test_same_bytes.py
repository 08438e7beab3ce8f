# SPDX-License-Identifier: GPL-3.0-or-later
"""The JSON of the package equals the JSON of the program byte for byte; docs/reference/python.md lists commands and functions."""

from __future__ import annotations

import json
import os
import pathlib
import re

import numpy
import PIL.Image
import pytest
import setae

from conftest import ROOT

SOLIDS = {"youngs_modulus": "0.7 ± 0.02 MPa", "W_int": "37 ± 2 mJ/m2", "surface_energy": "25 mJ/m2"}
SOLIDS_TYPED = ("--E", "0.7 ± 0.02 MPa", "--w", "37 ± 2 mJ/m2", "--gamma", "25 mJ/m2")

#: Data files of the tests of the program.
DATA = ROOT / "tests/cli/data"

#: Function of each command, and the alternative for a command without a function.
FUNCTIONS = {
    "info": "`setae.info`, `setae.read`, `setae.channels`",
    "formats": "`setae.formats`",
    "convert": "`Scan.save`; `Scan.heights` and `Scan.to_xarray()` without a file",
    "level": "`Scan.level`, `Scan.process` …; `Scan.processing` is its JSON",
    "container check": "`setae.check_container`; `setae.channels` reads a container",
    "container write": "`setae.write_container`",
    "contour": "`setae.contour`; `anchors=…` also repeats a trace",
    "check": "`setae.check`",
    "tip": "`setae.tip`",
    "psd": "`setae.power_spectrum`",
    "sdrp": "`setae.scale_dependent_roughness`",
    "acf": "`setae.autocorrelation`",
    "vbw": "`setae.variable_bandwidth`",
    "params": "`setae.parameters`; of a standard (`--standard`) `setae.texture`",
    "adhesion": "`setae.work_of_adhesion`",
    "contact solve": "`setae.contact`",
    "contact sweep": "`setae.contact_sweep`",
    "contact front": "`setae.contact_front`",
    "contact persson": "`setae.persson`",
    "contact compare": "`setae.contact_comparison`; figure only with the program",
    "jkr radius": "`setae.contact_radii`; pictures with the edge drawn in (`--overlay`) only with the program",
    "jkr line": "`setae.contact_line`; figure only with the program",
    "jkr lens": "`setae.lens`",
    "jkr camera": "`setae.camera`",
    "jkr stiffness": "`setae.loop(…).machine_stiffness()`",
    "jkr import": "`setae.loop(…).save()`; `setae.loop(…, mapping=…)` reads the same tables",
    "jkr fit": "`setae.loop(…).fit()` for one loop, `setae.fit_together` for several; `setae.force_curves`, `setae.force_curve_series`",
    "jkr energy": "`setae.loop(…).energy()`",
    "jkr summary": "`setae.replicates`; figure and tables only with the program",
    "synthesize": "`setae.synthesize`",
    "study init": "`setae.draft_study`",
    "study": "`setae.study(…).run()`; `--next` is `StudyResult.next_measurements`",
    "lab conform": "`setae.patch_survey`, `StudyResult.patch_survey`; table and figure only with the program",
    "predict": "`setae.study(…).run().predict()`; tables and figures only with the program",
    "schema": "`setae.schema`",
}
GAPS = {
    "profile": "slices of `Scan.heights`",
    "lab make": "writes files; call `python -m setae lab make` with `subprocess`",
    "lab loops": "as lab make",
    "lab records": "as lab closure",
    "lab closure": "takes hours; use the program",
    "lab contours": "as lab closure",
    "lab area": "as lab closure",
    "lab foil": "as lab closure",
    "lab recording": "as lab make",
    "lab causes": "as lab closure",
    "lab next": "as lab closure",
    "plot": "`StudyResult.figures[…].save()`, `.plot()`",
    "cache": "use the program; package and program share the cache",
    "man": "`help()`",
    "completion": "for shells",
}


@pytest.fixture(autouse=True)
def in_folder(data: pathlib.Path) -> None:
    os.chdir(data)


def files() -> list[str]:
    return ["rougher/stylus_1.csv", "rougher/afm_1.txt", "rougher/tem_1.csv"]


@pytest.mark.parametrize(
    ("arguments", "typed"),
    [
        ({}, ()),
        ({"tip_radius": "10 ± 2 nm", "instrument": "afm"}, ("--tip-radius", "10 ± 2 nm", "--instrument", "afm")),
        ({"isotropic": True}, ("--iso",)),
        ({"binned": True, "window": "blackman_harris", "trend": "mean"}, ("--binned", "--window", "blackman_harris", "--trend", "mean")),
    ],
)
def test_psd(arguments, typed, printed):
    assert setae.power_spectrum("rougher/afm_1.txt", **arguments).json() == printed("psd", "rougher/afm_1.txt", *typed)


def test_psd_of_several(printed):
    assert setae.power_spectrum(files(), abel=True, fit=True).json() == printed("psd", *files(), "--abel", "--fit")


def test_psd_of_a_table(printed):
    assert setae.power_spectrum("rougher/truth.csv").json() == printed("psd", "rougher/truth.csv")


def test_params(printed):
    assert setae.parameters(files()).json() == printed("params", *files())
    one = setae.parameters("rougher/afm_1.txt")
    assert one.json() == printed("params", "rougher/afm_1.txt")
    assert list(one.headline) == [f"{name}_from_spectrum" for name in ("rms_height", "rms_slope", "rms_curvature", "true_area_ratio")]


def test_single_parameters_are_those_of_all():
    maps = ["rougher/afm_1.txt", "rougher/afm_2.txt"]
    of_all = setae.parameters(maps).data
    for only in ("Sq", "rms_height, rms_slope", "rms_slope_from_spectrum, Sa"):
        names = only.split(", ")
        expected = [entry for entry in of_all if entry["quantity"].removeprefix("areal_") in names or entry["symbol"] in names]
        assert len(expected) > 1 and setae.parameters(maps, only=only).data == expected


def test_functions_of_scale(printed):
    map_of, two = "rougher/afm_1.txt", ["rougher/afm_1.txt", "rougher/afm_2.txt"]
    assert setae.scale_dependent_roughness(map_of).json() == printed("sdrp", map_of)
    curvature = setae.scale_dependent_roughness(two, order=2, distance=["100 nm", "200 nm"], statistic="variance", along="both", tip_radius="10 nm")
    options = ("--order", 2, "--distance", "100 nm,200 nm", "--statistic", "variance", "--along", "both", "--tip-radius", "10 nm")
    assert curvature.json() == printed("sdrp", *two, *options)
    assert setae.autocorrelation(map_of, area=True, keep_unreliable=True).json() == printed("acf", map_of, "--area", "--all")
    assert setae.autocorrelation(two, slope=True, weighting="by_count").json() == printed("acf", *two, "--slope", "--weighting", "by_count")
    assert setae.variable_bandwidth(map_of, binned=True).json() == printed("vbw", map_of, "--binned")


def test_check(printed):
    two = ["rougher/afm_1.txt", "smoother/afm_1.txt"]
    assert setae.check(two, tip_radius="10 nm").json() == printed("check", *two, "--tip-radius", "10 nm")
    assert setae.check("rougher/tem_1.csv").json() == printed("check", "rougher/tem_1.csv")


def test_adhesion(printed):
    assert setae.work_of_adhesion(files(), **SOLIDS).json() == printed("adhesion", *files(), *SOLIDS_TYPED)
    with_loop = setae.work_of_adhesion("rougher/afm_1.txt", **SOLIDS, radius="1.25 mm", preload="1 mN")
    assert with_loop.json() == printed("adhesion", "rougher/afm_1.txt", *SOLIDS_TYPED, "--radius", "1.25 mm", "--preload", "1 mN")


def test_level(printed):
    scan = setae.read("rougher/afm_1.txt").level().despike(threshold=5)
    steps = ("--step", "level_plane", "--step", "despike threshold=5")
    assert scan.processing.json() == printed("level", "rougher/afm_1.txt", *steps)
    assert setae.power_spectrum(scan).json() == printed("psd", "rougher/afm_1.txt", *steps)


def test_info(printed):
    assert setae.info("rougher", "loops").json() == printed("info", "rougher", "loops")
    assert setae.info("rougher", heights=False).json() == printed("info", "rougher", "--no-heights")


def test_jkr(printed):
    loop = setae.loop("loops/rougher_soft.csv", radius="1.25 ± 0.01 mm")
    typed = ("loops/rougher_soft.csv", "--radius", "1.25 ± 0.01 mm")
    assert loop.fit().json() == printed("jkr", "fit", *typed)
    assert loop.fit(models=["all"], no_drift=True).json() == printed("jkr", "fit", *typed, "--model", "all", "--no-drift")
    assert loop.energy().json() == printed("jkr", "energy", *typed)


def test_loops_fitted_together(printed):
    files = ["loops/rougher_soft.csv", "loops/smoother_soft.csv"]
    loops = [setae.loop(file, radius="1.25 ± 0.01 mm") for file in files]
    typed = (*files, "--radius", "1.25 ± 0.01 mm")
    together = setae.fit_together(loops)
    assert together.json() == printed("jkr", "fit", *typed, "--share", "modulus")
    assert [q.symbol for q in together.quantities] == ["E*"] and 0.0 <= together.p_value <= 1.0 and len(together.to_pandas()) == 2
    both = setae.fit_together(loops, share=["modulus", "work"], model="dmt", no_drift=True)
    assert both.json() == printed("jkr", "fit", *typed, "--share", "modulus", "--share", "work", "--model", "dmt", "--no-drift")
    with pytest.raises(setae.InvalidArgument, match="one loop; expected a list of two or more"):
        setae.fit_together(loops[:1])


def test_loop_files(printed):
    setae.loop("loops/rougher_soft.csv").save("mine.csv", surface="UNCD", sphere_radius="1.25 mm")
    printed("jkr", "import", "loops/rougher_soft.csv", "--set", "surface=UNCD", "--set", "sphere_radius=1.25 mm", "-o", "theirs.csv")
    mine, theirs = setae.loop("mine.csv"), setae.loop("theirs.csv")
    assert mine.metadata["surface"] == "UNCD" and {**mine.metadata, "file": ""} == {**theirs.metadata, "file": ""}
    assert mine.units == theirs.units and all(numpy.array_equal(mine[name], theirs[name], equal_nan=True) for name in theirs.columns)


def test_draft_of_a_study(printed):
    draft = setae.draft_study(["rougher", "loops"], file="mine.toml")
    theirs = json.loads(printed("study", "init", "rougher", "loops", "-o", "theirs.toml"))
    assert draft.toml == pathlib.Path("theirs.toml").read_text() and {**draft.data, "study": "theirs.toml"} == theirs
    assert draft.save() == "mine.toml" and pathlib.Path("mine.toml").read_text() == draft.toml
    with pytest.raises(setae.InvalidArgument, match="file exists"):
        draft.save()
    pathlib.Path("empty").mkdir(exist_ok=True)
    with pytest.raises(setae.InvalidArgument, match="no measurement, loop, spectrum or micrograph"):
        setae.draft_study("empty")


SELF_AFFINE = {"hurst_exponent": 0.8, "rolloff": "2 um", "short_cutoff": "100 nm", "rms_height": "20 nm", "size": "8 um x 4 um", "pixels": "128x64"}
SELF_AFFINE_TYPED = ("--hurst", 0.8, "--rolloff", "2 um", "--short-cutoff", "100 nm", "--rms-height", "20 nm", "--size", "8 um x 4 um", "--pixels", "128x64")


def test_synthesize(printed):
    made = setae.synthesize(**SELF_AFFINE, seed=3, output="made.npy")
    mine = pathlib.Path("made.npy").read_bytes()
    assert made.json() == printed("synthesize", *SELF_AFFINE_TYPED, "--seed", 3, "-o", "made.npy")
    assert pathlib.Path("made.npy").read_bytes() == mine
    assert (made.scan.heights == numpy.load("made.npy")).all() and made.scan.size == (8e-6, 4e-6) and made.scan.periodic
    line = {"spectrum": "rougher/truth.csv", "size": "20 um", "pixels": 256, "line": True}
    typed = ("--spectrum", "rougher/truth.csv", "--size", "20 um", "--pixels", 256, "--line", "-o", "line.csv")
    assert setae.synthesize(**line, output="line.csv").json() == printed("synthesize", *typed)
    assert setae.synthesize(**line)["output"] is None


def test_convert(printed):
    scan = setae.read("rougher/afm_1.txt")
    scan.save("mine.x3p")
    printed("convert", "rougher/afm_1.txt", "theirs.x3p")
    assert pathlib.Path("mine.x3p").read_bytes() == pathlib.Path("theirs.x3p").read_bytes()


def test_formats(printed):
    assert setae.formats().json() == printed("formats")


def test_tip(printed):
    bump = DATA / "map_bump.csv"
    scan = setae.read(bump, size="15 nm x 15 nm", unit="nm", layout="matrix")
    found = setae.tip(scan, points=7, threshold="0.01 nm")
    typed = ("--size", "15 nm x 15 nm", "--unit", "nm", "--as", "matrix", "--points", 7, "--threshold", "0.01 nm")
    assert found.json() == printed("tip", bump, *typed, "-o", "tip.npy", "--reconstruction", "surface.npy")
    assert numpy.array_equal(found.scan.heights, numpy.load("tip.npy"))
    assert numpy.array_equal(found.surface.heights, numpy.load("surface.npy"), equal_nan=True)
    assert found.radius.unit == "m"


def test_containers(printed):
    given = [DATA / "line.csv", DATA / "plain.txt"]
    mine = setae.write_container("wafer.zip", given, unit={"plain.txt": "um"}, trend="tilt", name="wafer")
    bytes_of_mine = pathlib.Path("wafer.zip").read_bytes()
    assert mine.json() == printed("container", "write", *given, "--unit", "plain.txt=um", "--detrend", "tilt", "--name", "wafer", "-o", "wafer.zip")
    assert pathlib.Path("wafer.zip").read_bytes() == bytes_of_mine
    assert setae.check_container("wafer.zip").json() == printed("container", "check", "wafer.zip")
    with pytest.raises(setae.FileError):
        setae.write_container("none.zip", [*given, "no/such.csv"], unit={"plain.txt": "um"})
    assert not pathlib.Path("none.zip").exists()


def test_contour(printed):
    picture = DATA / "wave.png"
    traced = setae.contour(picture, pixel_size="0.1 nm")
    assert traced.json() == printed("contour", picture, "--pixel", "0.1 nm", "-o", "traced.csv")
    traced.save("mine.csv")
    assert pathlib.Path("mine.csv").read_text() == pathlib.Path("traced.csv").read_text()
    assert traced.overlay == pathlib.Path("traced.png").read_bytes()
    assert setae.read("mine.csv").heights.size > 100


def test_contour_with_anchors(printed):
    picture, anchors = DATA / "wave.png", DATA / "anchors.json"
    mine = setae.contour(picture, pixel_size="1 nm", shape="parametric", anchors=anchors)
    assert mine.json() == printed("contour", picture, "--pixel", "1 nm", "--shape", "parametric", "--anchors", anchors, "-o", "curve.csv")
    points = json.loads(anchors.read_text())["anchors"]
    assert setae.contour(picture, pixel_size="1 nm", shape="parametric", anchors=points).profiles == mine.profiles
    again = setae.contour(picture, anchors=mine)
    assert again.profiles == mine.profiles and again.json() == printed("contour", picture, "--anchors", "curve.json", "-o", "again.csv")
    PIL.Image.open(picture).save("encoded_again.png", compress_level=1)
    with pytest.raises(setae.InvalidArgument, match="trace of another picture"):
        setae.contour("encoded_again.png", anchors=mine)
    with pytest.raises(setae.InvalidArgument, match="its own options"):
        setae.contour(picture, pixel_size="1 nm", anchors=mine)


def test_contact(printed):
    scan = setae.synthesize(**{**SELF_AFFINE, "pixels": "64x64"}).scan
    scan.save("rough.nc")
    body = {"contact_modulus": "1 GPa", "pressure": "10 MPa"}
    typed = ("--contact-modulus", "1 GPa", "--pressure", "10 MPa")
    solved = setae.contact("rough.nc", **body)
    assert solved.json() == printed("contact", "solve", "rough.nc", *typed, "-o", "contact.npy")
    assert numpy.array_equal(solved.pressures, numpy.load("contact_pressure.npy"))
    assert numpy.array_equal(solved.gaps, numpy.load("contact_gap.npy"))
    assert solved.converged and solved.quantities[0].quantity in solved
    layer = {"layer_thickness": "1 um", "bonded": True, "poisson_ratio": 0.4}
    assert setae.contact("rough.nc", **body, **layer).json() == printed(
        "contact", "solve", "rough.nc", *typed, "--layer", "1 um", "--bonded", "--nu", 0.4
    )
    attraction = {"W_int": "50 mJ/m2", "interaction_range": "200 nm"}
    attracted = setae.contact("rough.nc", contact_modulus="1 GPa", mean_gap="150 nm", **attraction, law="cubic")
    attracted_typed = ("--contact-modulus", "1 GPa", "--mean-gap", "150 nm", "--w", "50 mJ/m2", "--range", "200 nm", "--law", "cubic")
    assert attracted.json() == printed("contact", "solve", "rough.nc", *attracted_typed)
    assert attracted.pressures.min() < 0 and attracted["status"] == "converged"
    on_a_stage = setae.contact("rough.nc", contact_modulus="1 GPa", displacement="20 nm", stage_stiffness="1 kN/m", **attraction)
    staged = ("--contact-modulus", "1 GPa", "--displacement", "20 nm", "--stage-stiffness", "1 kN/m", "--w", "50 mJ/m2", "--range", "200 nm")
    assert on_a_stage.json() == printed("contact", "solve", "rough.nc", *staged)
    levelled = setae.read("rough.nc").level()
    assert setae.contact(levelled, **body).json() == printed("contact", "solve", "rough.nc", "--step", "level_plane", *typed)


def test_contact_of_a_spectrum(printed):
    made = {"pixels": 64, "cell": "2 um", "seed": 3}
    asked = ("--contact-modulus", "1 MPa", "--pressure", "1 kPa", "--pixels", 64, "--cell", "2 um", "--seed", 3)
    of_table = setae.contact("rougher/truth.csv", contact_modulus="1 MPa", pressure="1 kPa", **made)
    assert of_table.json() == printed("contact", "solve", "rougher/truth.csv", *asked)
    assert of_table["processing"][0]["step"] == "synthesize"


def test_contact_sweep(printed):
    setae.synthesize(**{**SELF_AFFINE, "pixels": "16x16"}).scan.save("coarse.nc")
    asked = {"contact_modulus": "1 MPa", "W_int": "50 mJ/m2", "interaction_range": "400 nm"}
    typed = ("--contact-modulus", "1 MPa", "--w", "50 mJ/m2", "--range", "400 nm")
    swept = setae.contact_sweep("coarse.nc", **asked)
    assert swept.json() == printed("contact", "sweep", "coarse.nc", *typed)
    assert swept.complete and swept.n == len(swept["tension"]) and {q.quantity for q in swept.quantities} >= {"loss", "separation_work"}
    on_a_stage = setae.contact_sweep("coarse.nc", **asked, stage_stiffness="0.1 N/m", to_pressure="1 kPa")
    assert on_a_stage.json() == printed("contact", "sweep", "coarse.nc", *typed, "--stage-stiffness", "0.1 N/m", "--to-pressure", "1 kPa")
    kept = setae.contact_sweep("coarse.nc", **asked, to_pressure="1 kPa", maps=True)
    assert kept.json() == printed("contact", "sweep", "coarse.nc", *typed, "--to-pressure", "1 kPa", "--maps", "states.npy")
    assert kept.maps and not swept.maps
    steps = {state["name"]: state["step"] for state in kept.data["maps"]}
    pressures, gaps = kept.maps["turn"]
    assert numpy.array_equal(gaps, numpy.load("states_turn_gap.npy")) and pressures.shape == (16, 16)
    assert list(steps) == list(kept.maps)
    assert pressures.mean() == pytest.approx(-kept["tension"][steps["turn"]])
    unfinished = pathlib.Path("sweep.restart")
    assert setae.contact_sweep("coarse.nc", **asked, restart=unfinished).json() == swept.json() and not unfinished.exists()
    unfinished.write_text("other content")
    with pytest.raises(setae.FormatError, match="checkpoint"):
        setae.contact_sweep("coarse.nc", **asked, restart=unfinished)
    with pytest.raises(TypeError, match="W_int"):
        setae.contact_sweep("coarse.nc", contact_modulus="1 MPa", interaction_range="400 nm")


def test_contact_front(printed):
    setae.synthesize(**{**SELF_AFFINE, "pixels": "64x64"}).scan.save("coarse.nc")
    asked = {"radius": "10 um", "contact_modulus": "100 kPa", "W_int": "50 mJ/m2", "to_displacement": "100 nm", "steps": 20}
    typed = ("--radius", "10 um", "--contact-modulus", "100 kPa", "--w", "50 mJ/m2", "--to-displacement", "100 nm", "--steps", 20)
    front = setae.contact_front("coarse.nc", **asked, shortest_wavelength="4 um")
    assert front.json() == printed("contact", "front", "coarse.nc", *typed, "--shortest-wavelength", "4 um")
    assert front.n == len(front["force"]) and {q.quantity for q in front.quantities} >= {"energy_loss", "jumps"}
    made = ("--pixels", 64, "--cell", "20 um", "--realisations", 2)
    several = setae.contact_front("rougher/truth.csv", **asked, pixels=64, cell="20 um", realisations=2)
    assert several.json() == printed("contact", "front", "rougher/truth.csv", *typed, *made)
    with pytest.raises(setae.InvalidArgument, match="to_force"):
        setae.contact_front("coarse.nc", radius="1 mm", contact_modulus="1 MPa", W_int="50 mJ/m2")
    with pytest.raises(setae.InvalidArgument, match="duration"):
        front.save_edge("edge.csv")
    kept = setae.contact_front("coarse.nc", **asked, shortest_wavelength="4 um", duration="10 s")
    kept.save_edge("edge.csv")
    sphere = {"radius": asked["radius"], "contact_modulus": asked["contact_modulus"]}
    line = setae.contact_line("edge.csv", **sphere)
    assert line.json() == printed("jkr", "line", "edge.csv", "--radius", "10 um", "--contact-modulus", "100 kPa")
    assert numpy.array_equal(line["time"], kept.edge["time"])
    assert line.data["release_rate"]["receding"]["mean"]["value"] == pytest.approx(0.05, rel=0.05)


def test_persson(printed):
    one = setae.persson("rougher/truth.csv", contact_modulus="1 MPa", pressure="10 kPa")
    assert one.json() == printed("contact", "persson", "rougher/truth.csv", "--contact-modulus", "1 MPa", "--pressure", "10 kPa")
    assert list(one.columns)[0] == "wavevector"
    several = setae.persson(files(), contact_modulus="1 MPa", pressure="1 kPa:100 kPa", W_int="50 mJ/m2", layer_thickness="50 um", bonded=True, poisson_ratio=0.4)
    typed = ("--contact-modulus", "1 MPa", "--pressure", "1 kPa:100 kPa", "--w", "50 mJ/m2", "--layer", "50 um", "--bonded", "--nu", 0.4)
    assert several.json() == printed("contact", "persson", *files(), *typed)
    assert several["pressure"].max() == 100e3 and several.units["mean_gap"] == "m" and isinstance(several.alerts, tuple)


def test_contact_compare(printed):
    asked = {"contact_modulus": "1 MPa", "pressure": "1 kPa,10 kPa", "pixels": "64", "realisations": 2, "seed": 5, "cell": "2 um"}
    found = setae.contact_comparison("rougher/truth.csv", **asked, longest_wavelength="2 um", shortest_wavelength="250 nm")
    typed = ("--contact-modulus", "1 MPa", "--pressure", "1 kPa,10 kPa", "--pixels", "64", "--surfaces", 2, "--seed", 5, "--cell", "2 um")
    waves = ("--longest-wavelength", "2 um", "--shortest-wavelength", "250 nm")
    assert found.json() == printed("contact", "compare", "rougher/truth.csv", *typed, *waves)
    assert found.n == 2 and found.units["mean_gap_persson"] == "m" and found["pressure"].max() == 10e3


def test_texture(printed):
    map_of = "rougher/afm_1.txt"
    areal = setae.texture(map_of, "iso25178", s_filter="20 nm", l_filter="2 um")
    assert areal.json() == printed("params", map_of, "--standard", "iso25178", "--s-filter", "20 nm", "--l-filter", "2 um")
    assert areal["Sq"].unit == "m"
    lines = setae.texture(map_of, "iso21920", profile="primary", averages="sections", section_length="1 um")
    typed = ("--standard", "iso21920", "--profile", "primary", "--averages", "sections", "--section-length", "1 um")
    assert lines.json() == printed("params", map_of, *typed)
    with pytest.raises(setae.InvalidArgument, match="iso25178, iso21920"):
        setae.texture(map_of, "iso4287")


def test_lens_and_camera(printed):
    profile = DATA / "lens_profile.csv"
    found = setae.lens(profile, x="x", z="z", start="-0.4 mm", stop="0.4 mm")
    assert found.json() == printed("jkr", "lens", profile, "--x", "x", "--z", "z", "--from", "-0.4 mm", "--to", "0.4 mm")
    assert abs(float(found.radius) - 1.25e-3) < 2e-6
    side = DATA / "lens_side.png"
    assert setae.lens(side, pixel_size="2 um").json() == printed("jkr", "lens", side, "--pixel", "2 um")
    pictures = [DATA / name for name in ("ruling_upright.png", "ruling_lying.png")]
    scale = setae.camera(pictures, "20 ± 0.02 um")
    assert scale.json() == printed("jkr", "camera", *pictures, "--pitch", "20 ± 0.02 um")
    assert scale.pixel_size.unit == "m"


def test_recordings(printed):
    frames = DATA / "frames"
    radii = setae.contact_radii(frames, pixel_size="2 um", frame_rate=10)
    assert radii.json() == printed("jkr", "radius", frames, "--pixel", "2 um", "--fps", 10, "-o", "theirs.csv")
    radii.save("mine.csv")
    assert pathlib.Path("mine.csv").read_text() == pathlib.Path("theirs.csv").read_text()
    assert len(radii["contact_radius"]) == len(radii["time"]) and radii.units["time"] == "s"


def test_contact_line(printed):
    frames = DATA / "frames"
    mine = setae.contact_line(frames, pixel_size="2 um", frame_rate=10, angles=64)
    typed = ("--pixel", "2 um", "--fps", 10, "--angles", 64, "--save-line", "edge.csv")
    assert mine.json() == printed("jkr", "line", frames, *typed)
    mine.save("my_edge.csv")
    assert pathlib.Path("my_edge.csv").read_bytes() == pathlib.Path("edge.csv").read_bytes()
    assert mine.edge["radius_64"].size == mine.n == len(mine["area"])
    again = setae.contact_line("my_edge.csv")
    assert again.json() == printed("jkr", "line", "edge.csv")
    assert (again["mean_radius"] == mine["mean_radius"]).all()
    with pytest.raises(TypeError, match="unknown argument 'pixels'"):
        setae.contact_line(frames, pixels="2 um")


def test_machine_stiffness(printed):
    rigid = DATA / "loop_on_glass.csv"
    found = setae.loop(rigid).machine_stiffness()
    assert found.json() == printed("jkr", "stiffness", rigid)
    assert abs(float(found.stiffness) - 30.0) < 0.15


def test_force_curves(printed):
    curves = DATA / "map.jpk-force-map"
    assert setae.force_curves(curves, radius="1 mm").json() == printed("jkr", "fit", curves, "--radius", "1 mm")
    one = setae.force_curves(curves, radius="1 mm", model="dmt", curve_number=1)
    assert one.json() == printed("jkr", "fit", curves, "--radius", "1 mm", "--curve-model", "dmt", "--curve-number", 1)


def test_several_force_curves(printed):
    curves = [setae.loop(DATA / "map.jpk-force-map", curve_number=number).to_pandas() for number in (0, 1)]
    series = setae.force_curve_series(curves, radius="1 mm")
    alone = [setae.force_curves(curve, radius="1 mm") for curve in curves]
    assert [fit.json() for fit in series] == [fit.json() for fit in alone]
    assert set(series.to_pandas()["quantity"]) >= {"contact_modulus", "energy_loss"} and len(series) == 2
    files = [DATA / "loop_on_glass.csv", DATA / "loop_on_glass.csv"]
    listed = setae.force_curve_series(files, radius="1 mm").json()
    assert listed == printed("jkr", "fit", *files, "--curve", "--radius", "1 mm")


def test_replicates(printed):
    fits = DATA / "fits.csv"
    mine = setae.replicates(fits, branch="loading", group_by=["surface", "lens"])
    assert mine.json() == printed("jkr", "summary", fits, "--branch", "loading", "--group-by", "surface,lens")


def test_several_measurements_are_refused_where_one_is_meant():
    with pytest.raises(TypeError, match="3 measurements; expected one"):
        setae.tip(files())
    with pytest.raises(setae.InvalidArgument, match="0 of `pressure`"):
        setae.contact("rougher/afm_1.txt", contact_modulus="1 GPa")


def test_study(printed, tmp_path):
    mine, theirs = setae.study("study.toml").run(output="results"), printed("study", "study.toml", "--output", "results", "--no-figures")
    assert mine.json() == theirs
    assert "study.json" in mine.write() and pathlib.Path("results/study.json").read_text() == theirs
    assert mine.next_measurements().json() == printed("study", "study.toml", "--output", "results", "--next")
    assert mine.predict().json() == printed("predict", "study.toml")


def test_conform(printed):
    asked = ("--energy-share", "0.05,0.4", "--points", 64, "--shortest-wave", 8, "--seeds", 2)
    found = setae.patch_survey(energy_shares=[0.05, 0.4], points=[64], points_per_wave=[8], realisations=2)
    assert found.json() == printed("lab", "conform", *asked)
    published = ROOT / "examples/nanodiamond/published.toml"
    small = {"points": [64], "points_per_wave": [8], "waves_per_side": 2, "squared_ratios": [1], "realisations": 1}
    of_pairs = setae.study(published).run(output="published").patch_survey(**small)
    typed = ("--points", 64, "--shortest-wave", 8, "--waves", 2, "--squared-ratio", 1, "--seeds", 1)
    assert of_pairs.json() == printed("lab", "conform", published, *typed)
    with pytest.raises(TypeError, match="energy_share"):
        setae.patch_survey(energy_share=[0.1])
    with pytest.raises(TypeError, match="energy_shares: float; expected a list of numbers"):
        setae.patch_survey(energy_shares=0.1)


def test_surface_has_the_numbers_of_params():
    measured = [f"rougher/afm_{i}.txt" for i in (1, 2)]
    surface, parameters = setae.surface(measured, spectrum="average"), setae.parameters(measured)
    assert surface.method == "average" and surface.n == 2
    for name in ("rms_height", "rms_slope", "elastic_energy_per_modulus"):
        assert float(surface[name]) == float(parameters[f"{name}_from_spectrum"])


def commands() -> list[str]:
    """Commands of the program, from the generated list of their pages."""
    page = (ROOT / "docs/reference/commands/README.md").read_text()
    return re.findall(r"^\| \[([a-z ]+)\]\(", page, re.M)


def table() -> str:
    rows = [f"| `setae {command}` | {FUNCTIONS.get(command) or '– ' + GAPS[command]} |" for command in commands()]
    return "\n".join(["| command | function |", "|---|---|", *rows]) + "\n"


def test_every_command_has_a_function_or_an_alternative():
    assert set(commands()) == FUNCTIONS.keys() | GAPS.keys()
    assert table() in (ROOT / "docs/reference/python.md").read_text()


if __name__ == "__main__":
    print(table())
