# SPDX-License-Identifier: GPL-3.0-or-later
"""Messages name the argument of Python, what was given and what was expected; no text of the binding, no unit that was not given."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
import setae

from conftest import ROOT

DATA = ROOT / "tests/cli/data"
SOLIDS = {"youngs_modulus": "0.7 MPa", "W_int": "37 mJ/m2", "surface_energy": "25 mJ/m2"}
BODY = {"contact_modulus": "1 MPa", "pressure": "1 kPa"}
SPHERE = {"radius": "1 mm", "contact_modulus": "1 MPa", "W_int": "50 mJ/m2", "to_displacement": "1 um"}
MADE = {"hurst_exponent": 0.8, "rolloff": "1 um", "short_cutoff": "80 nm", "rms_height": "20 nm", "size": "5 um", "pixels": 64}
SCAN = setae.scan(1e-9 * np.random.default_rng(1).standard_normal((32, 32)), size="1 um x 1 um", unit="m")

#: Calls by the name of the function; keywords of a case replace those of the call.
CALLS: dict[str, Callable[..., Any]] = {
    "work_of_adhesion": lambda **given: setae.work_of_adhesion(SCAN, **{**SOLIDS, **given}),
    "power_spectrum": lambda **given: setae.power_spectrum(SCAN, **given),
    "parameters": lambda **given: setae.parameters(SCAN, **given),
    "surface": lambda **given: setae.surface(SCAN, **given),
    "texture": lambda **given: setae.texture(SCAN, **{"standard": "iso25178", **given}),
    "scale_dependent_roughness": lambda **given: setae.scale_dependent_roughness(SCAN, **given),
    "contact": lambda **given: setae.contact(SCAN, **{**BODY, **given}),
    "contact_sweep": lambda **given: setae.contact_sweep(SCAN, **{"contact_modulus": "1 MPa", "W_int": "50 mJ/m2", "interaction_range": "10 nm", **given}),
    "contact_front": lambda **given: setae.contact_front(SCAN, **{**SPHERE, **given}),
    "persson": lambda **given: setae.persson(SCAN, **{**BODY, **given}),
    "synthesize": lambda **given: setae.synthesize(**{**MADE, **given}),
    "tip": lambda **given: setae.tip(SCAN, **{"points": 5, **given}),
    "check": lambda **given: setae.check(SCAN, **given),
    "assign_metadata": lambda **given: SCAN.assign_metadata(**given),
    "scan": lambda **given: setae.scan(np.ones((4, 4)), **{"size": "1 um x 1 um", "unit": "m", **given}),
    "loop": lambda **given: setae.loop(DATA / "loop_on_glass.csv", **given),
    "lens": lambda **given: setae.lens(DATA / "lens_profile.csv", **given),
    "camera": lambda **given: setae.camera(DATA / "ruling_upright.png", **given),
    "contact_radii": lambda **given: setae.contact_radii(DATA / "frames", **{"pixel_size": "2 um", "frame_rate": 10, **given}),
    "contour": lambda **given: setae.contour(DATA / "wave.png", **{"pixel_size": "0.1 nm", **given}),
    "force_curves": lambda **given: setae.force_curves(DATA / "map.jpk-force-map", **{"radius": "1 mm", **given}),
    "write_container": lambda **given: setae.write_container("none.zip", [DATA / "line.csv"], **given),
    "patch_survey": lambda **given: setae.patch_survey(**{"energy_shares": [0.05], "points": [64], "points_per_wave": [8], **given}),
    "limit_threads": lambda **given: setae.limit_threads(**given),
    "schema": lambda **given: setae.schema(**given),
    "info": lambda **given: setae.info(DATA / "line.csv", **given),
}

PRESSURE, LENGTH, WORK, STIFFNESS = "a pressure", "a length", "an energy per area", "a stiffness"
WITHOUT_UNIT = [
    ("work_of_adhesion", "youngs_modulus", PRESSURE),
    ("work_of_adhesion", "rough_youngs_modulus", PRESSURE),
    ("work_of_adhesion", "W_int", WORK),
    ("work_of_adhesion", "surface_energy", WORK),
    ("work_of_adhesion", "radius", LENGTH),
    ("work_of_adhesion", "preload", "a force"),
    ("power_spectrum", "tip_radius", LENGTH),
    ("power_spectrum", "resolution", LENGTH),
    ("power_spectrum", "longest_wavelength", LENGTH),
    ("parameters", "shortest_wavelength", LENGTH),
    ("texture", "s_filter", LENGTH),
    ("scale_dependent_roughness", "distance", LENGTH),
    ("contact", "contact_modulus", PRESSURE),
    ("contact", "pressure", PRESSURE),
    ("contact", "mean_gap", LENGTH),
    ("contact", "stage_stiffness", STIFFNESS),
    ("contact_sweep", "W_int", WORK),
    ("contact_sweep", "interaction_range", LENGTH),
    ("contact_front", "to_force", "a force"),
    ("contact_front", "duration", "a time"),
    ("persson", "pressure", PRESSURE),
    ("synthesize", "size", LENGTH),
    ("synthesize", "plateau", "a spectral density"),
    ("tip", "threshold", LENGTH),
    ("check", "tip_radius", LENGTH),
    ("assign_metadata", "tip_radius", LENGTH),
    ("scan", "size", LENGTH),
    ("scan", "tip_radius", LENGTH),
    ("loop", "radius", LENGTH),
    ("loop", "lens_height", LENGTH),
    ("loop", "spring_constant", STIFFNESS),
    ("loop", "sensitivity", "a length per voltage"),
    ("loop", "clock_offset", "a time"),
    ("lens", "start", LENGTH),
    ("camera", "pitch", LENGTH),
    ("contact_radii", "pixel_size", LENGTH),
    ("contour", "pixel_size", LENGTH),
    ("contour", "scale_bar", LENGTH),
    ("force_curves", "radius", LENGTH),
    ("force_curves", "contact_point", LENGTH),
    ("write_container", "size", LENGTH),
]


@pytest.mark.parametrize("value", [1.5e6, 7654, "1.5e6", np.float64(15.75), "15.75 ± 0.25"], ids=repr)
@pytest.mark.parametrize(("function", "argument", "kind"), WITHOUT_UNIT)
def test_a_number_without_unit_names_argument_and_dimension(function, argument, kind, value):
    with pytest.raises(setae.InvalidArgument) as caught:
        CALLS[function](**{argument: value})
    given = value if isinstance(value, str) else repr(float(value) if isinstance(value, float) else value)
    begin = f"{argument}: '{given}' has no unit; expected {kind} with its unit, such as \""
    assert str(caught.value).startswith(begin), str(caught.value)
    assert given not in str(caught.value)[len(begin) :], "the number with a unit that was not given"


def test_numbers_of_uncertainties_have_no_unit():
    uncertainties = pytest.importorskip("uncertainties")
    with pytest.raises(setae.InvalidArgument, match=re.escape("youngs_modulus: '0.7 ± 0.02' has no unit; expected a pressure")):
        CALLS["work_of_adhesion"](youngs_modulus=uncertainties.ufloat(0.7, 0.02))


def test_settings_of_a_loop_name_their_arguments(data):
    loop = setae.loop(data / "loops/rougher_soft.csv", radius="1.25 mm")
    for argument, value, words in (
        ("machine_stiffness", 30, "has no unit; expected a stiffness"),
        ("displacement_drift", 1e-10, "has no unit; expected a speed"),
        ("model_contact_point", 1e-6, "has no unit; expected a length"),
        ("cohesive_stress", "5 um", "is a length; expected a pressure"),
        ("branch", "up", "is unknown; expected one of loading, unloading"),
        ("errors", "orthogonal", "did you mean 'orthogonal_distance'?"),
    ):
        with pytest.raises(setae.InvalidArgument, match=f"^{argument}: '.*' ?{re.escape(words)}|^{argument}: '.*{re.escape(words)}"):
            loop.fit(**{argument: value})


@pytest.mark.parametrize(
    ("function", "argument", "value", "words"),
    [
        ("work_of_adhesion", "youngs_modulus", "1 kg", "'1 kg' is a mass; expected a pressure"),
        ("work_of_adhesion", "W_int", "37 ± 1 nm", "'37 ± 1 nm' is a length; expected an energy per area"),
        ("power_spectrum", "tip_radius", "10 kPa", "'10 kPa' is a pressure; expected a length"),
        ("scan", "size", "5 um x 5 kg", "'5 um x 5 kg' is a mass; expected a length"),
        ("loop", "radius", "1 mN", "'1 mN' is a force; expected a length"),
    ],
)
def test_a_unit_of_another_dimension(function, argument, value, words):
    with pytest.raises(setae.InvalidArgument, match=re.escape(f"{argument}: {words}")):
        CALLS[function](**{argument: value})


@pytest.mark.parametrize(
    ("function", "argument", "value"),
    [("work_of_adhesion", "W_int", "37 mN/m"), ("contact", "stage_stiffness", "10 J/m2"), ("contact", "pressure", "1 kN/m2")],
)
def test_units_of_one_dimension_are_accepted(function, argument, value):
    try:
        CALLS[function](**{argument: value})
    except setae.InvalidArgument as error:
        assert "expected a" not in str(error)


@pytest.mark.parametrize(
    ("function", "argument"),
    [
        ("contact", "law"), ("contact", "edges"), ("contact_front", "model"), ("contact_front", "method"), ("patch_survey", "law"),
        ("surface", "spectrum"), ("parameters", "conversion"), ("parameters", "window"), ("parameters", "contours"),
        ("power_spectrum", "instrument"), ("power_spectrum", "trend"), ("texture", "standard"), ("texture", "only"), ("parameters", "only"),
        ("scale_dependent_roughness", "statistic"), ("scale_dependent_roughness", "along"), ("synthesize", "amplitudes"), ("contact_radii", "polarity"),
        ("contour", "vacuum"), ("contour", "shape"), ("force_curves", "model"), ("force_curves", "tip"), ("write_container", "trend"),
        ("scale_dependent_roughness", "weighting"),
    ],
)  # fmt: skip
def test_unknown_models_and_words_are_refused(function, argument):
    given = {"W_int": "50 mJ/m2", "interaction_range": "10 nm"} if (function, argument) == ("contact", "law") else {}
    with pytest.raises(setae.InvalidArgument, match="'?\"?bogus.*(expected|did you mean)|no parameter") as caught:
        CALLS[function](**given, **{argument: "bogus"})
    assert "bogus" in str(caught.value)


@pytest.mark.parametrize(
    ("function", "argument", "value", "expected"),
    [
        ("power_spectrum", "isotropic", "yes", "str; expected True or False"),
        ("power_spectrum", "fit", 1, "int; expected True or False"),
        ("power_spectrum", "keep_values", "no", "str; expected True or False"),
        ("power_spectrum", "memory", "2", "str; expected a number"),
        ("parameters", "bootstrap_resamples", 1.5, "float; expected a whole number"),
        ("contact", "tolerance", "x", "str; expected a number"),
        ("contact", "bonded", "yes", "str; expected True or False"),
        ("contact", "edges", 5, "int; expected a text"),
        ("contact", "contact_modulus", [1], "list; expected a text"),
        ("contact_sweep", "maps", "yes", "str; expected True or False"),
        ("contact_front", "realisations", "2", "str; expected a whole number"),
        ("work_of_adhesion", "poisson_ratio", "0.5", "str; expected a number"),
        ("work_of_adhesion", "youngs_modulus", True, "bool; expected a text"),
        ("tip", "points", "many", "str; expected a whole number"),
        ("scan", "periodic", "no", "str; expected True or False"),
        ("limit_threads", "count", "a", "str; expected a whole number"),
        ("schema", "command", 5, "int; expected a text"),
        ("info", "heights", "x", "str; expected True or False"),
    ],
)
def test_a_value_of_another_kind(function, argument, value, expected):
    with pytest.raises(TypeError, match=f"^{argument}: {re.escape(expected)}") as caught:
        CALLS[function](**{argument: value})
    assert "incompatible function arguments" not in str(caught.value)


def test_a_quantity_with_a_unit_for_a_number():
    with pytest.raises(setae.InvalidArgument, match="poisson_ratio: 1.000 nm has a unit; expected a number without unit"):
        CALLS["work_of_adhesion"](poisson_ratio=setae.quantity("1 nm"))


def test_an_unknown_argument_names_near_ones():
    with pytest.raises(TypeError, match="unknown argument 'min_radiu'; did you mean 'min_radius'"):
        setae.contact_line(DATA / "frames", pixel_size="2 um", frame_rate=10, min_radiu=4)


@pytest.mark.parametrize(
    ("function", "argument", "value", "words"),
    [
        ("work_of_adhesion", "youngs_modulus", "-1 MPa", "'-1 MPa', expected above 0"),
        ("work_of_adhesion", "poisson_ratio", 0.7, "'0.7', expected from 0 to 0.5"),
        ("work_of_adhesion", "surface_energy", "1 blubb", "'blubb' is not a known unit"),
        ("loop", "poisson_ratio", 0.7, "'0.7', expected from 0 to 0.5"),
        ("power_spectrum", "longest_wavelength", "-1 um", "'-1 um', expected above 0"),
        ("contact", "contact_modulus", "0 MPa", "'0 MPa', expected above 0"),
    ],
)
def test_values_outside_the_domain_name_the_argument(function, argument, value, words):
    with pytest.raises(setae.InvalidArgument, match=f"^{argument}: {re.escape(words)}"):
        CALLS[function](**{argument: value})


ACCEPTED = [
    ("work_of_adhesion", "youngs_modulus", "0.7 ± 0.02 MPa"),
    ("power_spectrum", "tip_radius", "10 ± 2 nm"),
    ("contact", "pressure", "1 kPa"),
    ("contact_sweep", "interaction_range", "400 nm"),
    ("persson", "pressure", "1 kPa"),
    ("synthesize", "rms_height", "20 nm"),
    ("synthesize", "size", "5 um"),
    ("texture", "s_filter", "100 nm"),
    ("scale_dependent_roughness", "distance", "100 nm"),
    ("tip", "threshold", "0.2 nm"),
    ("check", "tip_radius", "10 ± 2 nm"),
    ("lens", "start", "-0.4 mm"),
    ("contact_radii", "pixel_size", "2 um"),
    ("contour", "pixel_size", "0.1 nm"),
    ("force_curves", "radius", "1 mm"),
]


@pytest.mark.parametrize(("function", "argument", "value"), ACCEPTED)
def test_quantities_of_every_package_are_accepted(function, argument, value):
    pint, uncertainties = pytest.importorskip("pint"), pytest.importorskip("uncertainties")
    ureg = pint.UnitRegistry()
    own = setae.quantity(value)
    magnitude = uncertainties.ufloat(own.value, own.standard_error) if own.standard_error else own.value
    of_pint = ureg.Quantity(magnitude, own.unit.replace("m2", "m**2"))
    given = {"instrument": "afm"} if function == "power_spectrum" else {}
    by_text = CALLS[function](**given, **{argument: value})
    for same in (own, of_pint, own.to_pint()):
        assert CALLS[function](**given, **{argument: same}).json() == by_text.json()


def test_quantities_are_accepted_for_numbers():
    pint = pytest.importorskip("pint")
    by_number = CALLS["work_of_adhesion"](poisson_ratio=0.4).json()
    for nu in (setae.quantity("0.4"), pint.UnitRegistry()("40 percent"), np.float64(0.4)):
        assert CALLS["work_of_adhesion"](poisson_ratio=nu).json() == by_number
    share = CALLS["contact"]()["area_fraction"]
    assert setae.loop(DATA / "loop_on_glass.csv", radius="1 mm", poisson_ratio=0.5 * share / share).bodies
