# SPDX-License-Identifier: GPL-3.0-or-later
"""Options of the program beside keywords of Python: every difference is listed with its reason, and every reason is a difference."""

from __future__ import annotations

import inspect
import re
from collections.abc import Callable, Iterator
from typing import Any

import setae
from setae import _generated, _names

from conftest import ROOT
from test_same_bytes import FUNCTIONS, GAPS, commands

PAGES = ROOT / "docs/reference/commands"
#: Functions whose keywords are the options of a command.
CALLS: dict[str, tuple[Callable[..., Any], ...]] = {
    "acf": (setae.autocorrelation, setae.power_spectrum),
    "adhesion": (setae.work_of_adhesion, setae.parameters),
    "check": (setae.check,),
    "contact compare": (setae.contact_comparison,),
    "contact front": (setae.contact_front,),
    "contact persson": (setae.persson,),
    "contact solve": (setae.contact,),
    "contact sweep": (setae.contact_sweep,),
    "container check": (setae.check_container,),
    "container write": (setae.write_container,),
    "contour": (setae.contour,),
    "convert": (setae.read, setae.Scan.save),
    "formats": (setae.formats,),
    "info": (setae.info,),
    "jkr camera": (setae.camera,),
    "jkr energy": (setae.loop, setae.Loop.fit, setae.Loop.energy),
    "jkr fit": (setae.loop, setae.Loop.fit, setae.force_curves, setae.fit_together),
    "jkr import": (setae.loop, setae.Loop.save),
    "jkr lens": (setae.lens,),
    "jkr line": (setae.contact_line, setae.contact_radii),
    "jkr radius": (setae.contact_radii,),
    "jkr stiffness": (setae.loop, setae.Loop.machine_stiffness),
    "jkr summary": (setae.replicates,),
    "lab conform": (setae.patch_survey,),
    "level": (setae.read, setae.Scan.process),
    "params": (setae.parameters, setae.texture),
    "predict": (setae.StudyResult.predict,),
    "psd": (setae.power_spectrum, setae.parameters),
    "schema": (setae.schema,),
    "sdrp": (setae.scale_dependent_roughness, setae.power_spectrum),
    "study": (setae.study, setae.Study.run),
    "study init": (setae.draft_study, setae.StudyDraft.save),
    "synthesize": (setae.synthesize,),
    "tip": (setae.tip,),
    "vbw": (setae.variable_bandwidth, setae.power_spectrum),
}
#: Keywords of `**name` of functions.
EXPANDED = {"settings": "LoopSettings", "recording": "RadiusRequest"}
#: Keywords of options with other names; one of several.
RENAMED: dict[str, tuple[str, ...]] = {
    "as": ("layout",),
    "camera_map": ("camera_mapping",),
    "column": ("columns",),
    "curve_contact_point": ("contact_point",),
    "curve_model": ("model",),
    "energy_share": ("energy_shares",),
    "fps": ("frame_rate",),
    "from": ("start", "taken_over"),
    "hide": ("hidden",),
    "hurst_exponent": ("hurst_exponent",),
    "iso": ("isotropic",),
    "longest_wavelength": ("longest",),
    "map": ("mapping",),
    "model": ("models",),
    "no_heights": ("heights",),
    "no_rolloff": ("fit_rolloff",),
    "output": ("file",),
    "segment": ("segments",),
    "set": ("metadata",),
    "short_cutoff": ("fit_short_cutoff",),
    "shortest_wave": ("points_per_wave",),
    "squared_ratio": ("squared_ratios",),
    "step": ("step", "parameters"),
    "to": ("stop",),
    "w": ("W_int",),
    "waves": ("waves_per_side",),
}
#: Options that Python has in another form, of every command.
EVERYWHERE: dict[str, str] = {
    "all": "results contain every warning and column",
    "channel": "setae.read(file, channel=…)",
    "documentation": "pages of the reference, written for developers",
    "explain": "docstrings, and the pages of docs/concepts",
    "help": "help(function)",
    "json": "result.json()",
    "layout": "setae.read(file, layout=…)",
    "as": "setae.read(file, layout=…)",
    "pipeline": "Scan.process(…)",
    "progress": "a call runs to its end, or to Ctrl-C",
    "step": "Scan.process(…)",
    "threads": "setae.limit_threads(…)",
    "width": "result.plot(), with a figure of matplotlib of any size",
}
#: Why an output of a command is no keyword.
WRITTEN = "to_pandas(), to_xarray(), plot() or save() of the result"
#: Options that only the program has, or that Python has in another form, by command.
ONLY_PROGRAM: dict[str, dict[str, str]] = {
    **dict.fromkeys(("acf", "contact front", "contact solve", "params", "psd", "sdrp", "vbw", "jkr radius", "predict"), {"output": WRITTEN}),
    "check": {"strict": "an exit code; Python looks at the findings"},
    "contact compare": {
        "output": WRITTEN,
        **dict.fromkeys(("bootstrap_resamples", "conversion", "memory"), "arguments of setae.surface, whose result is accepted"),
    },
    "contact front": {"output": WRITTEN, "save_line": "ContactFront.save_edge"},
    "contact persson": {
        "output": WRITTEN,
        **dict.fromkeys(("bootstrap_resamples", "conversion", "memory"), "arguments of setae.surface, whose result is accepted"),
    },
    "contact sweep": {"output": WRITTEN},
    "contour": {
        "no_overlay": "nothing is written; Contour.overlay is the picture",
        "output": "Contour.save",
        "save_calibration": "the pixel size is in the result: contour(…, pixel_size=…)",
        "segment": "Contour.save(file, segment)",
    },
    "convert": {"all_channels": "setae.channels(file)", "to": "the ending of Scan.save(file)"},
    "info": {"long": "the result contains everything"},
    "jkr energy": {"course": "a table for plots by other programs", "figures": WRITTEN, "tidy": WRITTEN},
    "jkr fit": {
        "curve": "setae.force_curves takes every table as a force curve",
        "figures": "LoopFit.plot()",
        "long": "the result contains everything",
        "tidy": WRITTEN,
    },
    "jkr import": {
        **dict.fromkeys(("decimal", "encoding", "header_end", "separator", "sheet"), "pandas.read_csv and read_excel, whose tables are accepted"),
        "save_map": "a template for an editor; setae.loop(…, columns=…) names columns",
    },
    "jkr line": {
        "beside": "two results of contact_line can be compared column by column",
        "output": WRITTEN,
        "save_line": "ContactLine.save",
    },
    "jkr radius": {
        "output": "ContactRadii.save",
        "overlay": "pictures with the edge drawn in are for the eye",
        "overlay_frames": "pictures with the edge drawn in are for the eye",
        "um_per_px": "the same as pixel_size, in micrometres",
    },
    "jkr summary": {"figure": WRITTEN, "output": WRITTEN},
    "lab conform": {
        "cache": "argument of Study.run(cache=…)",
        "no_cache": "results are kept for the program only",
        "output": WRITTEN,
    },
    "level": {
        "output_folder": "Scan.save for each file",
        "to": "the ending of Scan.save(file)",
        "write_pipeline": "Scan.processing.data['pipeline'] lists the steps",
    },
    "params": {"format": "to_pandas().to_markdown(), to_latex() …", "output": WRITTEN},
    "predict": {"cache": "argument of Study.run(cache=…)", "no_cache": "Study.run(keep=False)", "output": WRITTEN},
    "schema": {"output": "the result is a dictionary"},
    "study": {
        "dry_run": "setae.study(file) reads the file and raises its errors",
        "next": "StudyResult.next_measurements()",
        "no_cache": "Study.run(keep=False)",
        "no_figures": "nothing is drawn before StudyResult.write() or .figures",
        "target": "StudyResult.next_measurements(target)",
    },
    "study init": {"force": "StudyDraft.save(replace=True)"},
    "tip": {"output": "Tip.scan.save(file)", "reconstruction": "Tip.surface.save(file)"},
}


def options_of(command: str) -> Iterator[tuple[str, ...]]:
    """The names of each option of a command, from pages that a test compares with the program."""
    page = f"{command.replace(' ', '-')}.md"
    shared = (PAGES / "input.md").read_text().split("\n## ")
    text = "\n".join([(PAGES / page).read_text(), *(section for section in shared if f"({page})" in section)])
    for names in re.findall(r"^\| (`-[^|]*?`)(?: (?:[^|`]|\\\|)*)? \|", text, re.M):
        yield tuple(name.lstrip("-").replace("-", "_") for name in re.findall(r"`(--?[\w-]+)`", names) if name.startswith("--"))


def keywords_of(command: str) -> set[str]:
    """Names of the parameters of the functions of a command."""
    found: set[str] = set()
    for function in CALLS[command]:
        for name, parameter in inspect.signature(function).parameters.items():
            if parameter.kind == parameter.VAR_KEYWORD:
                found |= set(getattr(_generated, EXPANDED[name]).__annotations__) if name in EXPANDED else set()
            found.add(name)
    return found


def missing(command: str) -> set[str]:
    """Options of a command that are no keyword."""
    known = keywords_of(command)
    named = [names for names in options_of(command) if not set(names) & EVERYWHERE.keys()]
    assert len(list(options_of(command))) >= 3, command
    spelled = {name: (name, *RENAMED.get(name, ()), _names.RENAMED.get(name, name)) for names in named for name in names}
    return {names[0] for names in named if not {word for name in names for word in spelled[name]} & known}


def test_every_option_is_a_keyword_or_has_a_reason():
    differences = {command: missing(command) for command in CALLS}
    without_reason = {c: sorted(names - ONLY_PROGRAM.get(c, {}).keys()) for c, names in differences.items()}
    assert not {c: names for c, names in without_reason.items() if names}, "new options: add the keyword, or the reason in ONLY_PROGRAM"
    settled = {c: sorted(reasons.keys() - differences[c]) for c, reasons in ONLY_PROGRAM.items()}
    assert not {c: names for c, names in settled.items() if names}, "these are keywords, or no options any more: remove the reasons"


def test_every_command_has_its_functions_or_its_gap():
    assert CALLS.keys() == FUNCTIONS.keys() and CALLS.keys() | GAPS.keys() == set(commands())


def test_reasons_are_sentences_of_some_length():
    for reason in [*EVERYWHERE.values(), *(reason for reasons in ONLY_PROGRAM.values() for reason in reasons.values())]:
        assert len(reason) > 8
