#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""python_keywords.py [--check]: documentation of arguments, from the one description of options in the library.

Writes setae/_generated.py, a TypedDict for each request whose options a function takes by **name, and the section "Parameters" of
docstrings: every argument with its type, its default and its meaning. Meanings are those of the command line's help (fields::Option), names
are those of setae._names.RENAMED. OWN contains the meanings of other arguments.
--check: writes nothing and fails where a file would change. The package must be importable (PYTHONPATH=build/python).
"""

from __future__ import annotations

import argparse
import ast
import pathlib
import re
import sys
import textwrap
from typing import Any

import setae
from setae import _setae
from setae._names import RENAMED, option_of

PACKAGE = pathlib.Path(__file__).resolve().parent.parent / "python/setae"
WIDTH = 140

#: Requests whose options a function takes as arguments, in the order in which an argument is looked up.
FUNCTIONS: dict[tuple[str, str], tuple[str, ...]] = {
    ("_about.py", "steps"): (),
    ("_about.py", "version"): (),
    ("_adhesion.py", "work_of_adhesion"): ("Solids", "Analysis"),
    ("_contact.py", "contact"): ("HardWallRequest", "InteractionRequest", "MadeSurfaceRequest"),
    ("_contact.py", "contact_sweep"): ("SweepRequest", "MadeSurfaceRequest"),
    ("_contact.py", "contact_front"): ("FrontRequest", "MadeSurfaceRequest"),
    ("_contact.py", "persson"): ("PerssonRequest", "Analysis"),
    ("_contact.py", "contact_comparison"): ("ComparisonRequest", "PerssonRequest", "Analysis"),
    ("_containers.py", "check_container"): (),
    ("_containers.py", "formats"): (),
    ("_containers.py", "write_container"): ("ContainerRequest",),
    ("_diagnosis.py", "check"): (),
    ("_laboratory.py", "camera"): (),
    ("_laboratory.py", "contour"): (),
    ("_laboratory.py", "lens"): ("LensRequest",),
    ("_laboratory.py", "contact_radii"): ("RadiusRequest",),
    ("_laboratory.py", "contact_line"): ("LineRequest",),
    ("_laboratory.py", "force_curves"): ("CurveRequest", "LoopFiles", "LoopBodies"),
    ("_laboratory.py", "replicates"): ("ReplicateRequest",),
    ("_loops.py", "loop"): ("LoopFiles", "LoopBodies"),
    ("_loops.py", "fit"): ("LoopModels", "LoopSettings"),
    ("_quantities.py", "quantity"): (),
    ("_scales.py", "scale_dependent_roughness"): ("ScaleRequest", "Analysis"),
    ("_scales.py", "autocorrelation"): ("ScaleRequest", "Analysis"),
    ("_scales.py", "variable_bandwidth"): ("ScaleRequest", "Analysis"),
    ("_scan.py", "channels"): (),
    ("_scan.py", "info"): (),
    ("_scan.py", "lengths"): (),
    ("_scan.py", "read"): (),
    ("_scan.py", "scan"): (),
    ("_schema.py", "schema"): (),
    ("_spectra.py", "parameters"): ("Analysis",),
    ("_spectra.py", "power_spectrum"): ("Analysis",),
    ("_spectra.py", "surface"): ("Analysis",),
    ("_study.py", "patch_survey"): ("PatchSurveyRequest",),
    ("_study_building.py", "study"): (),
    ("_study_draft.py", "draft_study"): (),
    ("_synthesis.py", "synthesize"): ("SynthesisRequest",),
    ("_synthesis.py", "tip"): ("BlindTipRequest",),
    ("_texture.py", "texture"): ("TextureRequest",),
    ("_threads.py", "limit_threads"): (),
    ("_together.py", "fit_together"): ("LoopModels", "LoopSettings"),
    ("_together.py", "force_curve_series"): (),
}


def options_of(request: str) -> dict[str, str]:
    """Meaning of each option of a request, by its attribute."""
    members = vars(getattr(_setae, request))
    documented = {name: member.__doc__ for name, member in members.items() if isinstance(member, property) and member.__doc__}
    return {name: text for name, text in documented.items() if not text.startswith("(self")}  # these are signatures


def keywords_of(request: str) -> dict[str, str]:
    """Meaning of each argument: an option that is called otherwise in Python has its argument only."""
    options = options_of(request)
    by_meaning = {meaning: name for name, meaning in options.items()}
    own = {name: meaning for name, meaning in options.items() if by_meaning[meaning] == name and name not in ("from", "as")}
    return {RENAMED.get(name, name): meaning for name, meaning in own.items()}


def accepts(request: str, name: str, value: Any) -> bool:
    try:
        setattr(getattr(_setae, request)(), name, value)
    except TypeError:
        return False
    except setae.InvalidArgument:
        return True  # a text that is no quantity
    return True


def type_of(request: str, name: str) -> str:
    """Type of an argument, by what the library takes for it."""
    name = option_of(getattr(_setae, request), name)
    default = getattr(getattr(_setae, request)(), name)
    if isinstance(default, bool):
        return "bool"
    if isinstance(default, list):
        return "Sequence[str] | str" if accepts(request, name, ["a"]) else "Sequence[float]"
    if accepts(request, name, "a"):
        return "Text"
    return "float" if accepts(request, name, 0.5) else "int"


def keywords_file() -> str:
    text = textwrap.dedent('''\
        # SPDX-License-Identifier: GPL-3.0-or-later
        # Written by tools/python_keywords.py from the library's description of options: change that.
        """Keywords of requests, for type checkers and editors."""

        from __future__ import annotations

        from collections.abc import Sequence
        from typing import TypedDict

        from ._options import Text
        ''')
    for request in sorted(set(EXPANDED.values())):
        text += f"\n\nclass {request}(TypedDict, total=False):\n"
        for name, meaning in keywords_of(request).items():
            text += f"    {name}: {type_of(request, name)}\n"
            text += textwrap.indent(textwrap.fill(f'"""{meaning}."""', WIDTH - 4), "    ") + "\n"
    return text


def default_of(node: ast.expr | None) -> str:
    """The default of an argument; None stands for the default of the library, which the meaning states."""
    if node is None:
        return ""
    return ", optional" if isinstance(node, ast.Constant) and node.value is None else f", default {ast.unparse(node)}"


#: Types as readers call them, by their names in annotations.
READABLE = {
    "Text": "str or Quantity", "PintQuantity": "quantity of pint", "UncertainNumber": "number of uncertainties", "Path": "str or path",
    "Paths": "str or path or Sequence[str or path]", "Size": "str or Quantity or tuple", "Source": "str or path or table",
    "Sources": "str or path or table or a list of them", "Stated": "str or int or Mapping",
    "Measured": "scan, str, path, array, table or a list of them", "Any": "object", "Anchors": "sequence of (x, y), Contour or path",
}


def readable(annotation: ast.expr | None) -> str:
    """A type as a reader calls it: "str or Quantity" for Text."""
    text = "Any" if annotation is None else ast.unparse(annotation)
    return re.sub(r"\b\w+\b", lambda found: READABLE.get(found[0], found[0]), text.replace(" | None", "")).replace(" | ", " or ")


def entry(name: str, kind: str, meaning: str, indent: str) -> list[str]:
    """An argument in a section: its name with its type, then its meaning."""
    return [f"{name} : {kind}", *textwrap.wrap(meaning, WIDTH - len(indent) - 4, initial_indent="    ", subsequent_indent="    ")]


def meaning_of(function: str, argument: str, known: dict[str, str]) -> str:
    options = [argument, *(option for option, name in RENAMED.items() if name == argument)]
    of_option = next((known[option] for option in options if option in known), None)
    found = OWN.get(f"{function}.{argument}") or of_option or OWN.get(argument)
    if found is None:
        raise SystemExit(f"{function}: '{argument}' is no option of its requests and not in OWN")
    return found


def parameters(function: ast.FunctionDef, requests: tuple[str, ...], indent: str) -> str:
    """The section of a docstring; empty without arguments."""
    known: dict[str, str] = {}
    for request in reversed(requests):
        known.update(options_of(request))
    given = function.args
    positional = [*given.posonlyargs, *given.args]
    defaults = [*[None] * (len(positional) - len(given.defaults)), *given.defaults, *given.kw_defaults]
    lines = []
    for argument, default in zip([*positional, *given.kwonlyargs], defaults):
        if argument.arg != "self":
            meaning = meaning_of(function.name, argument.arg, known)
            lines += entry(argument.arg, readable(argument.annotation) + default_of(default), meaning, indent)
    if given.vararg:
        name = f"*{given.vararg.arg}"
        lines = entry(name, readable(given.vararg.annotation), meaning_of(function.name, name, known), indent) + lines
    if given.kwarg and (request := EXPANDED.get((function.name, given.kwarg.arg))):
        for name, meaning in keywords_of(request).items():
            default = getattr(getattr(_setae, request)(), option_of(getattr(_setae, request), name))
            stated = ", optional" if default is None or default == "" or default == [] else f", default {default!r}"
            lines += entry(name, readable(ast.parse(type_of(request, name), mode="eval").body) + stated, meaning, indent)
    return "\n".join(indent + line for line in ["Parameters", "----------", *lines]) if lines else ""


SECTION = re.compile(r"\n *Parameters\n *-{10}\n(?:(?!\n *\n).)*", re.DOTALL)
LATER = re.compile(r"\n *(?:Returns|Raises|Examples)\n *-{6,}\n")


def documented(source: str, name: str) -> str:
    """A module with the sections that its functions have."""
    for function in [node for node in ast.walk(ast.parse(source)) if isinstance(node, ast.FunctionDef)]:
        documentation = ast.get_docstring(function, clean=False)
        if (name, function.name) not in FUNCTIONS or not documentation or is_method_of_same_name(function):
            continue
        indent = " " * (function.col_offset + 4)
        section = parameters(function, FUNCTIONS[name, function.name], indent)
        plain = re.sub(r"\n{3,}", "\n\n", SECTION.sub("\n", documentation)).rstrip()
        later = LATER.search(plain)
        place = later.start() if later else len(plain)
        parts = [part for part in (plain[:place].rstrip(), section, plain[place:].strip("\n")) if part]
        source = source.replace(documentation, "\n\n".join(parts) + f"\n{indent}")
    return source


def is_method_of_same_name(function: ast.FunctionDef) -> bool:
    """True for a method that passes its arguments to the function of the same name."""
    return function.col_offset > 0 and function.name != "fit"


#: Requests whose options a function takes by **name, listed as its own.
EXPANDED = {
    ("fit", "settings"): "LoopSettings",
    ("contact_line", "recording"): "RadiusRequest",
    ("patch_survey", "patches"): "PatchSurveyRequest",
}

#: Arguments that are Python's alone, and those of measurements that many functions share; "function.argument" for one function.
OWN = {
    "*files": "containers: folders or ZIP archives",
    "*paths": "files or folders",
    "abel": "C_iso by the inverse Abel transform, too",
    "anchors": "points (x, y) in pixels that the trace passes, or a file of them; or an earlier trace, or its JSON file, which is repeated with "
               "its own options",
    "binned": "a spectrum of one measurement in the bins of combined measurements",
    "calibration": "file of a calibration that was saved from another picture",
    "channel": "channel by its number, counted from 0, or by its name; default: the preferred channel of heights",
    "write_container.channel": "channel by its number, counted from 0, or by its name, of all files or by file; default: the preferred "
                               "channel",
    "loop.columns": "columns of the file by their role (force, displacement, contact_radius, time), such as {'force': 'Load'}, with a "
                    "missing unit as in "
               "{'force': 'Kraft[uN]'}, or an expression over columns; default: guessed from names and units",
    "command": "name of the command, such as 'psd' or 'contact solve'; 'study' for study.json",
    "contour.denoise": "standard deviation in pixels of a Gaussian that smooths the picture first",
    "count": "number of threads; 0: one per core",
    "edges": "edges of a map: automatic repeats the map, with a warning where heights do not match; one of automatic, periodic, windowed",
    "write_container.files": "measured files, scans and arrays, which become one surface",
    "file": "path of a file, or a table in memory",
    "channels.file": "path of a file or a container",
    "read.file": "path of a file, of any format in `setae.formats()`",
    "study.file": "path of a study file, or a dictionary with the keys of a study file",
    "replicates.files": "tables with one row per fit",
    "contour.foil_thickness": "thickness of the sample along the beam, such as '20 nm'",
    "folders": "folders, or files; the files of one folder are measurements of one surface",
    "draft_study.file": "study file; paths in the draft are relative to its folder",
    "loops": "two loops or more",
    "curves": "paths of files, loops, or tables in memory",
    "fit_together.model": "contact model, such as 'dmt'; default: jkr",
    "frames": "TIFF stack, AVI, folder of pictures, or pictures",
    "contact_line.frames": "recording as for `contact_radii`, a table of the edge, or a result with an edge",
    "fit": "fit of a self-affine spectrum",
    "fit_range": "wavevectors of the self-affine fit in 1/m, such as '1e5:1e8'; default: all",
    "fit_rolloff": "the fit has a roll-off; False: a power law without roll-off",
    "fit_short_cutoff": "the fit also finds where the spectrum ends",
    "scan.heights": "array with the first index x, array of pint, DataArray of xarray, topography of SurfaceTopography, table of "
                    "positions and heights with "
                    "units, or a result of setae: a scan, a simulated surface, a contour",
    "info.heights": "heights are read (True), not read (False), or read from files up to 64 MB (None)",
    "contour.hidden": "parts of the picture without sample, as 'x,y,width,height' in pixels",
    "contour.image": "number, counted from 0, or title of an image in a file of several; default: the first that is no spectrum and no "
                     "Fourier "
                     "transform",
    "contour.ignore_stated_pixel_size": "pixel size or scale bar given hold even where the file contradicts them",
    "instrument": "kind of the instrument; default: that of the file; one of stylus, afm, tem, optical",
    "isotropic": "C_iso by the transform of maps, too",
    "keep_values": "heights are taken as they are: no value counts as a mark of missing data",
    "layout": "layout of a text file: a narrow map, points x y z, or the table of a spectrum; one of matrix, columns, spectrum",
    "longest_distance": "longest distance over an area, needed for maps that are read in bands, such as '5 um'",
    "maps": "states are kept point by point: at first load, at the turn, at zero load on retraction, at the greatest tension",
    "measurement": "one measurement, or the table of a spectrum",
    "tip.measurement": "a map",
    "measurements": "one measurement, or all measurements of one surface: scans, files, arrays with a size",
    "persson.measurements": "one measurement, all measurements of one surface, or the table of a spectrum",
    "contact_comparison.measurements": "one measurement, all measurements of one surface, or the table of a spectrum",
    "contour.min_length": "shortest length in pixels of a segment that is kept; default: 50, of masks 0",
    "name": "name in results and messages; default: 'array'",
    "of": "result of a study, whose pairs give the spectra and energies of the patches",
    "parameters.only": "names or symbols of the parameters that are wanted, such as 'Sq, rms_slope_from_spectrum'; default: all",
    "output": "file for the surface, whose ending gives the format; nothing is written without it",
    "write_container.output": "container that is written, a ZIP archive",
    "periodic": "the heights repeat themselves beyond their edges",
    "picture": "picture of the side of a sample: DM3, DM4, TIFF, PNG, JPEG, SER, EMD or MRC",
    "pictures": "pictures of a ruling",
    "pitch": "distance of the lines of the ruling, such as '10 um' or '10 ± 0.02 um'",
    "contour.pixel_size": "size of a pixel, or width and height as '1 nm x 0.2 nm', such as '0.055 nm'; default: that of the file",
    "contact_front.realisations": "number of surfaces made, with seeds from `seed` on; results are means with their standard errors",
    "resolution": "shortest wavelength that the instrument resolves, such as '500 nm'; default: that of the file",
    "contour.scale_bar": "length that the scale bar in the picture stands for, such as '500 nm'",
    "contour.shape": "profile where the contour turns back: the highest point over each x, a cut, or the curve itself; one of envelope, "
                     "cut, parametric",
    "size": "extent of the heights, where the file does not state it, such as '5 um x 5 um'",
    "scan.size": "extent of an array, such as '5 um x 5 um' or `other.size`; needed for arrays without x",
    "lengths.size": "one length, or extents separated by x, such as '2 um x 1 mm'",
    "skip_failed": "measurements that cannot be analysed are left out with a warning",
    "contour.smoothing": "length of the smoothing spline in pixels; default: that of the smallest expected error",
    "surface.spectrum": "combination of the spectra; one of likelihood, average; default: likelihood for several measurements, average "
                        "for one",
    "synthesize.spectrum": "table of q and C_iso [m4] or C1D [m3] instead of a self-affine spectrum",
    "work_of_adhesion.surface": "result of `surface`, or measurements, which are averaged",
    "tip_radius": "radius of the tip, with its standard error, such as '10 ± 2 nm'; default: that of the file",
    "trend": "trend that is removed before the analysis; default: none after steps that level, else by instrument; one of none, mean, "
             "tilt, parabola",
    "write_container.trend": "trend that is to be removed, of all files or by file; default: mean; one of mean, tilt, parabola",
    "unit": "unit of the heights, where the file does not state it, such as 'nm'",
    "scan.unit": "unit of an array, such as 'nm'; with x also 'mm, um' of positions and heights",
    "quantity.input_name": "name of the input; quantities with one name have one error, as under [inputs] of a study",
    "quantity.name": "name of the quantity, such as 'radius'",
    "quantity.standard_error": "standard error of a number, in its unit",
    "quantity.symbol": "symbol, such as 'R'",
    "quantity.unit": "unit of a number, such as 'mm'",
    "quantity.value": "text such as '1.25 ± 0.01 mm' or 'lens = 1.25 ± 0.01 mm', a number, a quantity of pint, a number of uncertainties",
    "units": "units of columns of a table in memory, where neither names nor attributes state them, such as {'force': 'mN'}",
    "contour.vacuum": "side of the picture that is vacuum, by grey level; one of automatic, bright, dark",
    "contour.whole_picture": "scale bars and text that are found are not hidden",
    "x": "positions of the heights along a line",
}


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true")
    check = parser.parse_args().check
    files = {PACKAGE / "_generated.py": keywords_file()}
    for module in sorted({module for module, _ in FUNCTIONS}):
        files[PACKAGE / module] = documented((PACKAGE / module).read_text(encoding="utf-8"), module)
    stale = [path for path, text in files.items() if not path.exists() or path.read_text(encoding="utf-8") != text]
    for path in stale:
        if not check:
            path.write_text(files[path], encoding="utf-8")
        print(f"{path.relative_to(PACKAGE.parent)}: {'differs from what python_keywords.py makes' if check else 'written'}")
    return 1 if check and stale else 0


if __name__ == "__main__":
    assert setae  # the package is there, with its module
    sys.exit(main())
