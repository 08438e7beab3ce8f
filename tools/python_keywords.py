#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""python_keywords.py [--check]: what the package says of options, from the one description that the library has of them.

Writes setae/_generated.py, a TypedDict of keywords for each request, and the section "Parameters" of docstrings: every keyword with its type,
its default and its meaning. Meanings are those of the command line's help (fields::Option); keywords that are Python's alone are in OWN.
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

PACKAGE = pathlib.Path(__file__).resolve().parent.parent / "python/setae"
WIDTH = 140

#: Requests whose options a function takes as keywords, in the order in which a keyword is looked up.
FUNCTIONS: dict[tuple[str, str], tuple[str, ...]] = {
    ("_adhesion.py", "work_of_adhesion"): ("Solids",),
    ("_contact.py", "contact"): ("HardWallRequest", "InteractionRequest", "MadeSurfaceRequest"),
    ("_contact.py", "contact_sweep"): ("SweepRequest", "MadeSurfaceRequest"),
    ("_contact.py", "contact_front"): ("FrontRequest", "MadeSurfaceRequest"),
    ("_contact.py", "persson"): ("PerssonRequest",),
    ("_contact.py", "contact_compare"): ("ComparisonRequest", "PerssonRequest"),
    ("_containers.py", "write_container"): ("ContainerRequest",),
    ("_laboratory.py", "lens"): ("LensRequest",),
    ("_laboratory.py", "contact_radii"): ("RadiusRequest",),
    ("_laboratory.py", "contact_line"): ("LineRequest",),
    ("_laboratory.py", "force_curves"): ("CurveRequest", "LoopFiles", "LoopBodies"),
    ("_laboratory.py", "replicates"): ("ReplicateRequest",),
    ("_loops.py", "loop"): ("LoopFiles", "LoopBodies"),
    ("_loops.py", "fit"): ("LoopModels", "LoopSettings"),
    ("_scales.py", "scale_dependent"): ("ScaleRequest",),
    ("_scales.py", "autocorrelation"): ("ScaleRequest",),
    ("_scales.py", "variable_bandwidth"): ("ScaleRequest",),
    ("_study.py", "conform"): ("PatchSurveyRequest",),
    ("_synthesis.py", "synthesize"): ("SynthesisRequest",),
    ("_synthesis.py", "tip"): ("BlindTipRequest",),
    ("_texture.py", "texture"): ("TextureRequest",),
}


def options_of(request: str) -> dict[str, str]:
    """Meaning of each option of a request, by its attribute."""
    members = vars(getattr(_setae, request))
    documented = {name: member.__doc__ for name, member in members.items() if isinstance(member, property) and member.__doc__}
    return {name: text for name, text in documented.items() if not text.startswith("(self")}  # these are signatures


def keywords_of(request: str) -> dict[str, str]:
    """Meaning of each keyword: an option that is called otherwise in Python has its keyword only."""
    options = options_of(request)
    by_meaning = {meaning: name for name, meaning in options.items()}
    return {name: meaning for name, meaning in options.items() if by_meaning[meaning] == name and name not in ("from", "as")}


def accepts(request: str, name: str, value: Any) -> bool:
    try:
        setattr(getattr(_setae, request)(), name, value)
    except TypeError:
        return False
    except setae.InvalidArgument:
        return True  # a text that is no quantity
    return True


def type_of(request: str, name: str) -> str:
    """Type of a keyword, by what the library takes for it."""
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
    for request in sorted({request for requests in FUNCTIONS.values() for request in requests}):
        text += f"\n\nclass {request}(TypedDict, total=False):\n"
        for name, meaning in keywords_of(request).items():
            text += f"    {name}: {type_of(request, name)}\n"
            text += textwrap.indent(textwrap.fill(f'"""{meaning}."""', WIDTH - 4), "    ") + "\n"
    return text


def default_of(node: ast.expr | None) -> str:
    return "" if node is None or (isinstance(node, ast.Constant) and node.value is None) else f", default {ast.unparse(node)}"


def readable(annotation: ast.expr | None) -> str:
    """A type as a reader calls it: "str or Quantity" for Text."""
    text = "Any" if annotation is None else ast.unparse(annotation)
    text = text.replace(" | None", "").replace("Text", "str or Quantity").replace("Path", "str or path")
    text = text.replace("Size", "str or Quantity or tuple").replace("Source", "str or path or table")
    return text.replace(" | ", " or ")


def parameters(function: ast.FunctionDef, requests: tuple[str, ...], indent: str) -> str:
    """The section of a docstring."""
    known: dict[str, str] = {}
    for request in reversed(requests):
        known.update(options_of(request))
    lines = ["Parameters", "----------"]
    for argument, default in zip(function.args.kwonlyargs, function.args.kw_defaults):
        meaning = known.get(argument.arg) or OWN.get(argument.arg)
        if meaning is None:
            raise SystemExit(f"{function.name}: '{argument.arg}' is no option of {', '.join(requests)} and not in OWN")
        lines.append(f"{argument.arg} : {readable(argument.annotation)}{default_of(default)}")
        lines += textwrap.wrap(meaning, WIDTH - len(indent) - 4, initial_indent="    ", subsequent_indent="    ")
    if function.args.kwarg and (request := EXPANDED.get((function.name, function.args.kwarg.arg))):
        for name, meaning in keywords_of(request).items():
            default = getattr(getattr(_setae, request)(), name)
            stated = "" if default is None or default == "" or default == [] else f", default {default!r}"
            lines.append(f"{name} : {readable(ast.parse(type_of(request, name), mode='eval').body)}{stated}")
            lines += textwrap.wrap(meaning, WIDTH - len(indent) - 4, initial_indent="    ", subsequent_indent="    ")
    elif function.args.kwarg:
        lines.append(f"**{function.args.kwarg.arg}")
        lines += textwrap.wrap(OWN["**" + function.args.kwarg.arg], WIDTH - len(indent) - 4, initial_indent="    ", subsequent_indent="    ")
    return "\n".join(indent + line for line in lines)


SECTION = re.compile(r"\n *Parameters\n *-{10}\n(?:(?!\n *\n).)*", re.DOTALL)


def documented(source: str, name: str) -> str:
    """A module with the sections that its functions have."""
    for function in [node for node in ast.walk(ast.parse(source)) if isinstance(node, ast.FunctionDef)]:
        requests = FUNCTIONS.get((name, function.name))
        documentation = ast.get_docstring(function, clean=False)
        if not requests or not documentation or not function.args.kwonlyargs:
            continue
        indent = " " * (function.col_offset + 4)
        section = "\n" + parameters(function, requests, indent)
        plain = re.sub(r"\n{3,}", "\n\n", SECTION.sub("\n", documentation)).rstrip()
        before, arrow, examples = plain.partition(f"\n\n{indent}>>> ")
        if before.endswith(":"):  # a sentence that introduces the examples stays with them
            before, blank, sentence = before.rpartition("\n\n")
            arrow = blank + sentence + arrow
        new = before.rstrip() + "\n" + section + (f"{arrow}{examples}" if arrow else "") + f"\n{indent}"
        source = source.replace(documentation, new)
    return source


#: Requests whose options a function takes by **name, listed as its own.
EXPANDED = {("fit", "settings"): "LoopSettings"}

#: Keywords that are Python's alone, and those of measurements that many functions share.
OWN = {
    "area": "of a map over all directions, instead of along one",
    "camera": "file of the camera's table of times and contact radii, or of its pictures",
    "columns": "columns of the file by their role, such as {'force': 'Load'}, with a missing unit as in {'force': 'Kraft[uN]'}, or an expression over columns",
    "contours": "treatment of traced contours: 'unique' or 'full'",
    "edges": "edges of a map: 'automatic' (repeated, with a warning where heights do not match), 'periodic' or 'windowed'",
    "instrument": "kind of the instrument: 'stylus', 'afm', 'tem' or 'optical'",
    "keep_values": "heights are taken as they are: no value counts as a mark of missing data",
    "longest": "longest wavelength that counts",
    "maps": "states are kept point by point: at first load, at the turn, at zero load on retraction, at the greatest tension",
    "output": "file for the surface, whose ending gives the format; nothing is written without it",
    "realisations": "number of surfaces made, with seeds from `seed` on; results are means with their standard errors",
    "resolution": "distance below which the instrument does not resolve heights",
    "shortest": "shortest wavelength that counts",
    "size": "extent of the heights, where the file does not state it",
    "skip_failed": "measurements that cannot be analysed are left out with a warning",
    "tip_radius": "radius of the tip, with its standard error, such as '10 ± 2 nm'",
    "trend": "trend that is removed from the heights: 'none', 'mean', 'tilt' or 'parabola'",
    "unit": "unit of the heights, where the file does not state it",
    "units": "units of columns of a table in memory, where neither names nor attributes state them, such as {'force': 'mN'}",
    "window": "window of the spectrum: 'hann' or 'none'; None chooses by the heights",
    "**measurement": "keywords of measurements, as those of `parameters`",
    "**options": "keywords of measurements, as those of `power_spectrum`, and of ScaleRequest",
    "**recording": "keywords of recordings, as those of `contact_radii`",
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
