# SPDX-License-Identifier: GPL-3.0-or-later
"""A use of every public function and of every class of results, for ``mypy --strict`` (test_documents.py); it also runs on data of the tutorial."""

from __future__ import annotations

import pathlib
from collections.abc import Sequence

import numpy as np
import setae
from setae import models


def surfaces(folder: pathlib.Path, files: Sequence[pathlib.Path]) -> setae.Surface:
    scan: setae.Scan = setae.read(files[0]).assign_metadata(instrument="afm", tip_radius="10 nm").level().despike()
    several: tuple[setae.Scan, ...] = setae.channels(files[0])
    found: setae.Info = setae.info(*map(str, files))
    diagnosis: setae.Diagnosis = setae.check([str(file) for file in files])
    findings: tuple[setae.Finding, ...] = diagnosis.findings
    container: setae.Container = setae.write_container(folder / "surfaces.zip", [scan, *several[:1]])
    report: setae.ContainerReport = setae.check_container(folder / "surfaces.zip")
    spectrum: setae.PowerSpectrum = setae.power_spectrum(scan, fit=True)
    functions: list[setae.FunctionOfScale] = [
        setae.scale_dependent_roughness(scan), setae.autocorrelation(scan), setae.variable_bandwidth(scan)]
    parameters: setae.Parameters = setae.parameters(scan)
    height: setae.Quantity = parameters["Sq"]
    texture: setae.Texture = setae.texture(scan, standard="iso_25178")
    shape: setae.Tip = setae.tip(scan, size="50 nm")
    lines: setae.Scan = setae.scan(np.asarray(scan.heights), scan.size, "m")
    sides: list[float] = setae.lengths(lines.size)
    assert len(sides) == 2 and height.value > 0.0 and findings is not None
    for result in (found, container, report, spectrum, *functions, texture, shape):
        assert isinstance(result, setae.Result) and result.json()
    return setae.surface([lines, setae.scan(2.0 * lines.heights, lines.size, "m")], spectrum="average")


def contacts(surface: setae.Surface) -> setae.WorkOfAdhesion:
    made: setae.Synthesis = setae.synthesize(hurst_exponent=0.8, rolloff="2 um", short_cutoff="1 um", rms_height="20 nm", size="4 um", pixels=16)
    rough: setae.Scan = made.scan
    pressed: setae.Contact = setae.contact(rough, contact_modulus="1 GPa", pressure="1 MPa")
    persson: setae.PerssonContact = setae.persson(rough, contact_modulus="1 GPa", pressure="1 MPa")
    compared: setae.ContactComparison = setae.contact_comparison(rough, contact_modulus="1 GPa", pressure="1 MPa", pixels="16", realisations=1)
    survey: setae.PatchSurvey = setae.patch_survey(energy_shares=[0.05], points=[16], points_per_wave=[8], realisations=1)
    for result in (made, pressed, persson, compared, survey):
        assert isinstance(result, setae.Result) and result.json()
    return setae.work_of_adhesion(surface, youngs_modulus="0.7 MPa", W_int="37 mJ/m2", surface_energy="25 mJ/m2")


def simulated(scan: setae.Scan) -> tuple[setae.ContactSweep, setae.ContactFront]:
    sweep = setae.contact_sweep(scan, contact_modulus="1 MPa", W_int="50 mJ/m2", interaction_range="400 nm")
    return sweep, setae.contact_front(scan, radius="1 mm", contact_modulus="1 MPa", W_int="50 mJ/m2")


def loops(files: Sequence[pathlib.Path]) -> setae.SharedFit:
    loop: setae.Loop = setae.loop(files[0], radius="1.25 mm")
    fit: setae.LoopFit = loop.fit()
    fitted: setae.Fitted = fit.points()
    energy: setae.LoopEnergy = loop.energy()
    depth = np.linspace(-1e-6, 0.5e-6, 120)
    curve = {"force [N]": models.hertz(depth, 5e-6, 10e3, zero_outside=True), "displacement [m]": depth}
    curves: setae.ForceCurves = setae.force_curves(curve, radius="5 um")
    series: setae.ForceCurveSeries = setae.force_curve_series([curve, curve], radius="5 um")
    pull_off: float = models.jkr_pull_off(1e-3, setae.quantity("50 mJ/m2"))
    assert len(series) == 2 and pull_off < 0.0 and fitted.n > 0 and curves.json() and energy.json()
    return setae.fit_together([setae.loop(file, radius="1.25 mm") for file in files])


def recordings(frames: pathlib.Path, ruling: pathlib.Path, profile: pathlib.Path, picture: pathlib.Path, fits: pathlib.Path) -> None:
    camera: setae.Camera = setae.camera(ruling, "20 um")
    lens: setae.Lens = setae.lens(profile, x="x", z="z")
    radii: setae.ContactRadii = setae.contact_radii(frames, pixel_size="2 um", frame_rate=10)
    line: setae.ContactLine = setae.contact_line(frames, pixel_size="2 um", frame_rate=10, angles=64)
    contour: setae.Contour = setae.contour(picture, pixel_size="0.1 nm")
    replicates: setae.Replicates = setae.replicates(fits, branch="loading", group_by=["surface", "lens"])
    for result in (camera, lens, radii, line, contour, replicates):
        assert isinstance(result, setae.Result) and result.json()


def studies(folder: pathlib.Path) -> setae.StudyResult:
    draft: setae.StudyDraft = setae.draft_study(folder, file=folder / "draft.toml")
    study: setae.Study = setae.study(folder / "study.toml")
    result: setae.StudyResult = study.run(keep=False, output=folder / "results")
    figures: list[setae.Figure] = list(result.figures.values())
    assert draft.toml and figures and result.summary()
    return result


def program() -> tuple[setae.Formats, list[str]]:
    setae.limit_threads(0)
    assert setae.version() and setae.schema("psd")
    try:
        setae.read("no/such/file")
    except setae.FileError as error:
        assert isinstance(error, setae.Error) and str(error)
    return setae.formats(), setae.steps()
