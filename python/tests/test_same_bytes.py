# SPDX-License-Identifier: GPL-3.0-or-later
"""JSON of the package is that of the program, to the byte; docs/reference/python.md lists verbs and functions."""

from __future__ import annotations

import os
import pathlib
import re

import pytest
import setae

from conftest import ROOT

SOLIDS = {"E": "0.7 ± 0.02 MPa", "W_int": "37 ± 2 mJ/m2", "gamma": "25 mJ/m2"}
SOLIDS_TYPED = ("--E", "0.7 ± 0.02 MPa", "--w", "37 ± 2 mJ/m2", "--gamma", "25 mJ/m2")

#: Function of each verb, and why a verb has none.
FUNCTIONS = {
    "info": "`setae.info`, `setae.read`, `setae.channels`",
    "level": "`Scan.level`, `Scan.process` …; `Scan.processing` is its JSON",
    "psd": "`setae.power_spectrum`",
    "check": "`setae.check`",
    "sdrp": "`setae.scale_dependent`",
    "acf": "`setae.autocorrelation`",
    "vbw": "`setae.variable_bandwidth`",
    "params": "`setae.parameters`; parameters of a standard (`--standard`) by the program alone",
    "adhesion": "`setae.work_of_adhesion`",
    "jkr fit": "`setae.loop(…).fit()`, a loop at a time; fits that loops share and force curves by the program alone",
    "jkr energy": "`setae.loop(…).energy()`",
    "study": "`setae.study(…).run()`; `--next` is `StudyResult.next_measurements`",
}
GAPS = {
    "formats": "a list of what is read and written; print it by `python -m setae formats`",
    "convert": "`Scan.heights` and `Scan.to_xarray()` give what a converted file would hold",
    "container check": "not bound yet",
    "container write": "not bound yet",
    "contour": "not bound yet",
    "profile": "slices of `Scan.heights`",
    "tip": "not bound yet",
    "synthesize": "not bound yet",
    "contact solve": "not bound yet",
    "contact persson": "not bound yet",
    "jkr import": "`setae.loop(…, mapping=…)` reads what it would write",
    "jkr radius": "`setae.loop(…, camera=…)` measures radii; the table of a recording by the program alone",
    "jkr stiffness": "not bound yet",
    "jkr lens": "not bound yet",
    "jkr camera": "not bound yet",
    "jkr summary": "a study's JSON has \"replicates\"",
    "lab make": "writes files; `subprocess` with `python -m setae lab make`",
    "lab loops": "as lab make",
    "lab closure": "hours of studies; by the program",
    "lab contours": "as lab closure",
    "lab area": "as lab closure",
    "lab foil": "as lab closure",
    "lab causes": "as lab closure",
    "lab next": "as lab closure",
    "study init": "writes a draft for an editor",
    "plot": "`StudyResult.figures[…].save()`, `.plot()`",
    "cache": "the program looks after what is kept; both use the same",
    "man": "`help()`",
    "completion": "the shell's",
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
    assert setae.parameters("rougher/afm_1.txt").json() == printed("params", "rougher/afm_1.txt")


def test_functions_of_scale(printed):
    map_of, two = "rougher/afm_1.txt", ["rougher/afm_1.txt", "rougher/afm_2.txt"]
    assert setae.scale_dependent(map_of).json() == printed("sdrp", map_of)
    curvature = setae.scale_dependent(two, order=2, distance=["100 nm", "200 nm"], statistic="variance", along="both", tip_radius="10 nm")
    options = ("--order", 2, "--distance", "100 nm,200 nm", "--statistic", "variance", "--along", "both", "--tip-radius", "10 nm")
    assert curvature.json() == printed("sdrp", *two, *options)
    assert setae.autocorrelation(map_of, area=True, all=True).json() == printed("acf", map_of, "--area", "--all")
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


def test_study(printed, tmp_path):
    mine, theirs = setae.study("study.toml").run(output="results"), printed("study", "study.toml", "--output", "results", "--no-figures")
    assert mine.json() == theirs
    assert "study.json" in mine.write() and pathlib.Path("results/study.json").read_text() == theirs
    assert mine.next_measurements().json() == printed("study", "study.toml", "--output", "results", "--next")


def test_surface_has_the_numbers_of_params():
    measured = [f"rougher/afm_{i}.txt" for i in (1, 2)]
    surface, parameters = setae.surface(measured, spectrum="average"), setae.parameters(measured)
    assert surface.method == "average" and surface.n == 2
    for name in ("rms_height", "rms_slope", "elastic_energy_per_modulus"):
        assert float(surface[name]) == float(parameters[f"{name}_from_spectrum"])


def verbs() -> list[str]:
    """Of the program, by its own page on them."""
    page = (ROOT / "docs/reference/verbs.md").read_text()
    return re.findall(r"^## setae ([a-z ]+)$", page, re.M)


def table() -> str:
    rows = [f"| `setae {verb}` | {FUNCTIONS.get(verb) or '– ' + GAPS[verb]} |" for verb in verbs()]
    return "\n".join(["| verb | function |", "|---|---|", *rows]) + "\n"


def test_every_verb_has_a_function_or_a_reason():
    assert set(verbs()) == FUNCTIONS.keys() | GAPS.keys()
    assert table() in (ROOT / "docs/reference/python.md").read_text()


if __name__ == "__main__":
    print(table())
