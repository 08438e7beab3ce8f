# SPDX-License-Identifier: GPL-3.0-or-later
"""Names of public functions and arguments follow docs/development/adr/0012-python-names.md, and docstrings are complete."""

from __future__ import annotations

import builtins
import doctest
import inspect
import re
import warnings
from collections import defaultdict

import numpy as np
import pytest
import setae
from setae import _names, models

from conftest import ROOT

DATA = ROOT / "tests/cli/data"

FUNCTIONS = {name: getattr(setae, name) for name in setae.__all__ if inspect.isroutine(getattr(setae, name))}
MODELS = {f"models.{name}": getattr(models, name) for name in models.__all__}
CLASSES = {name: getattr(setae, name) for name in setae.__all__ if inspect.isclass(getattr(setae, name))}
METHODS = {
    f"{name}.{method}": function
    for name, of in CLASSES.items()
    for method, function in inspect.getmembers(of, inspect.isroutine)
    if (method[0] != "_" or method == "__init__") and getattr(function, "__qualname__", "").startswith(f"{name}.")
}
CALLABLES = {**FUNCTIONS, **MODELS, **METHODS}

#: Arguments by **name that are not those of the function: of steps, matplotlib or another function, and keys of a study file.
OPEN = {"arguments", "metadata", "style", "parameters", "keys", "shared", "values", "durations"}


def arguments(function) -> list[inspect.Parameter]:
    return [p for p in inspect.signature(function).parameters.values() if p.name not in ("self", "cls")]


@pytest.mark.parametrize("name", CALLABLES)
def test_no_argument_has_the_name_of_a_builtin(name):
    assert not [p.name for p in arguments(CALLABLES[name]) if p.name in dir(builtins)]


@pytest.mark.parametrize("name", CALLABLES)
def test_keywords_are_explicit(name):
    """Arguments by **name have a type with their names, so that editors and type checkers know them."""
    several = [p for p in arguments(CALLABLES[name]) if p.kind is p.VAR_KEYWORD]
    assert all(p.name in OPEN or str(p.annotation).startswith("Unpack[") for p in several)


def test_no_argument_has_a_former_name():
    former = defaultdict(set)
    for name, function in CALLABLES.items():
        for argument in arguments(function):
            if argument.name in _names.RENAMED:
                former[argument.name].add(name)
    assert not former


#: Further spellings of arguments of other names, and prefixes that no argument has.
OTHER_SPELLINGS = ["E_star", "poisson", "young", "modulus", "sphere_radius", "pixelsize", "detrending", "n_surfaces", "filename", "path"]
PREFIXES = ("smallest_", "largest_", "least_", "most_", "num_", "is_")


def test_a_concept_has_one_name():
    """Keywords of Study are keys of study files: "sphere_radius" is the radius of a lens there."""
    names = {p.name for name, function in CALLABLES.items() if not name.startswith("Study.") for p in arguments(function)}
    assert not names & set(OTHER_SPELLINGS) and not [name for name in names if name.startswith(PREFIXES)]


@pytest.mark.parametrize(("argument", "kind"), [("unit", "str"), ("units", "Mapping")])
def test_unit_is_a_text_and_units_are_by_column(argument, kind):
    of_functions = [p for name, function in FUNCTIONS.items() for p in arguments(function) if p.name == argument]
    assert of_functions and all(kind in str(p.annotation) or str(p.annotation) == "Stated" for p in of_functions)


def sections(function) -> dict[str, str]:
    """Sections of a docstring by title; the text before is ""."""
    parts = re.split(r"^(\w+)\n-{4,}\n", inspect.getdoc(function) or "", flags=re.M)
    return {"": parts[0], **dict(zip(parts[1::2], parts[2::2]))}


@pytest.mark.parametrize("name", [*FUNCTIONS, *MODELS, "Loop.fit"])
def test_docstrings_have_the_sections_of_numpydoc(name):
    function, found = CALLABLES[name], sections(CALLABLES[name])
    titles = [title for title in ("", "Parameters", "Returns", "Raises", "Examples") if title in found]
    assert list(found) == titles, "order of sections"
    as_for_another = "as for :func:" in found[""]
    assert "Examples" in found and ("Parameters" in found or not arguments(function) or as_for_another)
    assert "Returns" in found or inspect.signature(function).return_annotation == "None"
    assert "Raises" in found or not arguments(function)
    assert ">>> " in found["Examples"] and "+SKIP" not in found["Examples"]


@pytest.mark.parametrize("name", [*FUNCTIONS, "Loop.fit"])
def test_every_argument_is_documented_with_its_default(name):
    text = sections(CALLABLES[name]).get("Parameters", "")
    for argument in arguments(CALLABLES[name]):
        if argument.kind is argument.VAR_KEYWORD:
            continue
        spelled = ("*" if argument.kind is argument.VAR_POSITIONAL else "") + argument.name
        line = re.search(rf"^{re.escape(spelled)} : (.*)\n    \S", text, re.M)
        assert line, f"{argument.name} has no line with its type and meaning"
        has_default = argument.default not in (argument.empty, None)
        stated = f", default {argument.default!r}" if has_default else ", optional" if argument.default is None else ""
        assert line[1].endswith(stated) and (", default " in line[1]) == has_default, line[0]


WITH_WORDS = ["instrument", "trend", "edges", "law", "window", "polarity", "spectrum", "standard", "amplitudes", "branch"]


@pytest.mark.parametrize("name", WITH_WORDS)
def test_words_of_an_argument_are_listed(name):
    """Arguments that take one of a few words state all of them."""
    for function in [f for f in FUNCTIONS.values() if any(p.name == name and p.annotation in ("str", "str | None") for p in arguments(f))]:
        entry = re.search(rf"^{name} : .*\n((?:    .*\n)+)", sections(function)["Parameters"], re.M)
        assert re.search(r"one of \w+, \w+|: \w+, \w+.* or \w+|such as", " ".join(entry[1].split())), f"{function.__name__}: {entry[0]}"


@pytest.mark.parametrize("name", [name for name in METHODS if not name.endswith("__init__")])
def test_methods_have_a_docstring(name):
    assert (inspect.getdoc(CALLABLES[name]) or "").strip()


@pytest.mark.parametrize("name", FUNCTIONS)
def test_examples_of_functions_give_the_printed_output(name, monkeypatch):
    """doctest.testmod leaves out functions with a decorator."""
    monkeypatch.chdir(DATA)
    function = inspect.unwrap(FUNCTIONS[name])
    runner = doctest.DocTestRunner(optionflags=doctest.NORMALIZE_WHITESPACE)
    (example,) = doctest.DocTestFinder(recurse=False).find(function, name, globs=dict(inspect.getmodule(function).__dict__))
    result = runner.run(example)
    assert result.attempted > 0 and result.failed == 0


FORMER = [(name, old, new) for name, f in CALLABLES.items() for old, new in getattr(f, "former_names", {}).items()]
ROUGH = setae.synthesize(hurst_exponent=0.8, rolloff="2 um", short_cutoff="500 nm", rms_height="20 nm", size="4 um", pixels=32).scan
LINE = setae.scan(1e-9 * np.random.default_rng(1).standard_normal(256), size="2 um", unit="m")
DEPTH = np.linspace(-1e-6, 0.5e-6, 120)
CURVE = {"force [N]": models.hertz(DEPTH, 5e-6, 10e3, zero_outside=True), "displacement [m]": DEPTH}
EDGE = {"time [s]": np.arange(4.0), "displacement [m]": np.zeros(4)}
EDGE |= {f"radius_{i + 1} [m]": (1e-4 + 1e-6 * np.arange(4)) * (1 + 0.01 * np.sin(0.5 * i)) for i in range(64)}
LAYER = {"contact_modulus": "1 GPa", "pressure": "1 MPa", "bonded": True, "layer_thickness": "1 um", "poisson_ratio": 0.4}
ATTRACTED = {"contact_modulus": "1 MPa", "W_int": "50 mJ/m2"}

#: A call of each function with former names: arguments by position and by name.
CALLS = {
    "work_of_adhesion": ([ROUGH], {"youngs_modulus": "0.7 MPa", "W_int": "37 mJ/m2", "surface_energy": "25 mJ/m2"}),
    "power_spectrum": ([LINE], {"fit": True}),
    "parameters": ([ROUGH], {}),
    "surface": ([ROUGH], {}),
    "scale_dependent_roughness": ([LINE], {}),
    "autocorrelation": ([ROUGH], {"area": True}),
    "variable_bandwidth": ([LINE], {}),
    "contact": ([ROUGH], LAYER),
    "contact.interaction_range": ([ROUGH], {**ATTRACTED, "mean_gap": "150 nm"}),
    "contact_sweep": ([ROUGH], {**ATTRACTED, "interaction_range": "400 nm", "to_pressure": "1 kPa", **dict(list(LAYER.items())[2:])}),
    "persson": ([ROUGH], LAYER),
    "contact_comparison": ([ROUGH], {**LAYER, "pixels": "64", "realisations": 2, "shortest_wavelength": "500 nm"}),
    "synthesize": ([], {"rolloff": "2 um", "short_cutoff": "500 nm", "rms_height": "20 nm", "size": "4 um", "pixels": 32}),
    "patch_survey": ([], {"energy_shares": [0.05], "points": [64], "points_per_wave": [8]}),
    "write_container": (["named.zip", [LINE]], {}),
    "loop": ([CURVE], {"radius": "5 um"}),
    "force_curves": ([CURVE], {"radius": "5 um"}),
    "lens": ([DATA / "lens_profile.csv"], {}),
    "contact_radii": ([DATA / "frames"], {"pixel_size": "2 um", "frame_rate": 10}),
    "contact_line": ([EDGE], {}),
    "contour": ([DATA / "wave.png"], {"pixel_size": "0.1 nm"}),
    "quantity": (["1.25 ± 0.01 mm"], {}),
    "Quantity.__init__": (["radius", "R", 1.0, "m", 0.1], {}),
}
VALUES = {
    "youngs_modulus": "0.7 MPa", "counter_youngs_modulus": "70 GPa", "rough_youngs_modulus": "70 GPa", "poisson_ratio": 0.4,
    "counter_poisson_ratio": 0.2, "rough_poisson_ratio": 0.2, "surface_energy": "20 mJ/m2", "hurst_exponent": 0.7,
    "interaction_range": "200 nm",
    "layer_thickness": "2 um", "longest_wavelength": "3 um", "shortest_wavelength": "600 nm", "longest_distance": "1 um",
    "keep_unreliable": True,
    "pixel_size": "0.2 um", "trend": "mean", "realisations": 1, "max_move": 2.0, "max_mode": 8, "min_mode": 2, "min_radius": 4.0,
    "min_void_area": 20.0, "min_length": 60.0, "fit_rolloff": False, "fit_short_cutoff": True, "input_name": "lens",
}  # fmt: skip


def test_every_function_with_former_names_is_called():
    assert {name for name, _, _ in FORMER} == {name for name in CALLS if name.count(".") == 0 or name == "Quantity.__init__"}
    assert {new for _, _, new in FORMER} == set(VALUES)


def shown(result) -> str:
    """All that a call gives: the bytes of a result, or the text of a value."""
    return result.json() if hasattr(result, "json") else repr((result, vars(result)))


@pytest.mark.parametrize(("name", "old", "new"), FORMER)
def test_a_former_argument_warns_and_gives_the_same_bytes(name, old, new, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    function = setae.Quantity if name == "Quantity.__init__" else CALLABLES[name]
    by_position, by_name = CALLS.get(f"{name}.{new}", CALLS[name])
    others = {key: value for key, value in by_name.items() if key != new}
    with warnings.catch_warnings():
        warnings.simplefilter("error", DeprecationWarning)
        expected = shown(function(*by_position, **others, **{new: VALUES[new]}))
    with pytest.warns(DeprecationWarning, match=f"^{old}: deprecated since setae 0.1; use the argument '{new}'$") as caught:
        found = function(*by_position, **others, **{old: VALUES[new]})
    assert shown(found) == expected
    assert caught[0].filename == __file__, "the warning points at the call"


@pytest.mark.parametrize("old", _names.FORMER_FUNCTIONS)
def test_a_former_function_warns(old):
    new = _names.FORMER_FUNCTIONS[old]
    with pytest.warns(DeprecationWarning, match=f"^setae.{old}: deprecated since setae 0.1; use setae.{new}$"):
        assert getattr(setae, old) is getattr(setae, new)


def test_former_methods_and_attributes_warn():
    with pytest.warns(DeprecationWarning, match="^stated: deprecated since setae 0.1; use assign_metadata$"):
        assert vars(LINE.stated(instrument="afm"))["instrument"] == vars(LINE.assign_metadata(instrument="afm"))["instrument"] == "afm"
    with pytest.warns(DeprecationWarning, match="^input: deprecated since setae 0.1; use input_name$"):
        assert setae.quantity("1 mm", input_name="lens").input == "lens"


def test_unknown_names_are_no_former_names():
    with pytest.raises(AttributeError, match="has no attribute 'contact_compares'"):
        setae.contact_compares
    with pytest.raises(TypeError, match="unexpected keyword argument 'seeds'"):
        setae.contact_comparison(ROUGH, contact_modulus="1 GPa", pressure="1 MPa", seeds=2)


def test_one_argument_by_two_names_is_refused():
    with pytest.raises(TypeError, match="^layer_thickness: given twice, also by the former name 'layer'$"):
        setae.contact(ROUGH, **LAYER, layer="1 um")


@pytest.mark.parametrize(
    ("name", "given", "words"),
    [
        ("contact", {"layer_thickness": "0 um"}, "^layer_thickness: '0 um', expected above 0"),
        ("contact", {"poisson_ratio": 0.7}, "^poisson_ratio: '0.7', expected from 0 to 0.5"),
        ("contact", {"nu": 0.7}, "^poisson_ratio: '0.7', expected from 0 to 0.5"),
        ("contact", {"layer_thickness": "1 MPa"}, "^layer_thickness: '1 MPa' is a pressure; expected a length"),
        ("contact", {"layer_thickness": [1]}, "^layer_thickness: list; expected a text"),
        ("contact_sweep", {"interaction_range": 4e-7}, "^interaction_range: '4e-07' has no unit; expected a length"),
        ("contact_comparison", {"realisations": "two"}, "^realisations: str; expected a whole number"),
        ("variable_bandwidth", {"keep_unreliable": "yes"}, "^keep_unreliable: str; expected True or False"),
        ("synthesize", {"hurst_exponent": 1.5}, "^hurst_exponent: '1.5', expected"),
        ("synthesize", {}, "`hurst_exponent`"),
        ("contact_line", {"radius_of_pixel": 1}, "unknown argument 'radius_of_pixel'; expected one of .*min_radius"),
    ],
)
def test_messages_have_the_names_of_python(name, given, words):
    by_position, by_name = CALLS[name]
    kept = {key: value for key, value in by_name.items() if key not in given and not (key == "poisson_ratio" and "nu" in given)}
    with pytest.raises((setae.InvalidArgument, TypeError), match=words), warnings.catch_warnings():
        warnings.simplefilter("ignore", DeprecationWarning)
        CALLABLES[name](*by_position, **kept, **given)


def test_keys_of_mappings_are_completed(data):
    def completed(mapping):
        return set(mapping._ipython_key_completions_())

    spectrum, loop = setae.power_spectrum(LINE), setae.loop(CURVE)
    assert {"wavevector", "C1D", "band"} <= completed(spectrum)
    assert {"rms_height", "Sq"} <= completed(setae.parameters(ROUGH))
    assert completed(loop) == completed(loop.columns) == {"force", "displacement"}
    figures = setae.study(data / "study.toml").run(keep=False, output=data / "named").figures
    assert completed(figures) == set(figures) != set()
    assert {"C1D", "plot", "to_pandas", "wavevector"} <= set(dir(spectrum))
