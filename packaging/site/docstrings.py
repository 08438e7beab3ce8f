# SPDX-License-Identifier: GPL-3.0-or-later
"""Docstrings as mkdocstrings reads them: examples at a Python prompt have a section of their own, names are links."""

from __future__ import annotations

import re
from typing import Any

import griffe

EXAMPLE = re.compile(r"^>>> .*(?:\n.+)*", re.M)
HEADING = "Examples\n--------\n"
ROLE = re.compile(r":(?:func|class):`(\w+)`")


class Markdown(griffe.Extension):
    def on_object(self, *, obj: griffe.Object, **_: Any) -> None:
        if obj.docstring:
            models = obj.path.startswith("setae.models")
            obj.docstring.value = as_markdown(obj.docstring.value, "setae.models" if models else "setae")


def as_markdown(docstring: str, module: str) -> str:
    docstring = ROLE.sub(rf"[`\1`][{module}.\1]", docstring)
    first = EXAMPLE.search(docstring)
    if first and HEADING not in docstring:
        docstring = docstring[: first.start()] + HEADING + docstring[first.start() :]
    return EXAMPLE.sub(lambda example: without_options(example[0]), docstring)


def without_options(example: str) -> str:
    """Without what is said to doctest alone."""
    return re.sub(r" *# doctest:.*", "", example)
