# SPDX-License-Identifier: GPL-3.0-or-later
"""Docstrings as mkdocstrings reads them: examples as a Python prompt shows them are blocks of code."""

from __future__ import annotations

import re
from typing import Any

import griffe

EXAMPLE = re.compile(r"^>>> .*(?:\n.+)*", re.M)


class Examples(griffe.Extension):
    def on_object(self, *, obj: griffe.Object, **_: Any) -> None:
        if obj.docstring:
            obj.docstring.value = EXAMPLE.sub(lambda block: f"```pycon\n{without_options(block[0])}\n```", obj.docstring.value)


def without_options(example: str) -> str:
    """Without what is said to doctest alone."""
    return re.sub(r" *# doctest:.*", "", example)
