# SPDX-License-Identifier: GPL-3.0-or-later
"""Docstrings as mkdocstrings reads them: examples at a Python prompt are blocks of code, names are links."""

from __future__ import annotations

import re
from typing import Any

import griffe

EXAMPLE = re.compile(r"^>>> .*(?:\n.+)*", re.M)
ROLE = re.compile(r":(?:func|class):`(\w+)`")


class Markdown(griffe.Extension):
    def on_object(self, *, obj: griffe.Object, **_: Any) -> None:
        if obj.docstring:
            obj.docstring.value = as_markdown(obj.docstring.value)


def as_markdown(docstring: str) -> str:
    docstring = ROLE.sub(r"[`\1`][setae.\1]", docstring)
    return EXAMPLE.sub(lambda example: f"```pycon\n{without_options(example[0])}\n```", docstring)


def without_options(example: str) -> str:
    """Without what is said to doctest alone."""
    return re.sub(r" *# doctest:.*", "", example)
