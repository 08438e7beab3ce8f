#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""formulas.py FILE.md...: converts every block ```math of the pages to MathML, and lists those that cannot be converted. pages.py shows them
on the site: browsers draw MathML themselves, with the font STIX Two Math of the site (SIL Open Font License 1.1)."""

from __future__ import annotations

import html
import importlib.util
import pathlib
import re
import sys
from typing import Any
from xml.etree import ElementTree

from latex2mathml.converter import convert

FONT = pathlib.Path(importlib.util.find_spec("ziamath").origin).parent / "fonts/STIXTwoMath-Regular.ttf"
BAR = '<mo stretchy="true">&#x000AF;</mo>'  # over a letter
FUNCTION = re.compile(r"(<m[io]>(?:ln|exp|cos|sin|cosh|sinh|arctan)</m[io]>)(?=<m(?:i|n|frac|sup|sub)>)")  # a name touches no argument
BLOCK = re.compile(r"^```math\n(.*?)^```$", re.M | re.S)


def mathml(latex: str) -> str:
    """A formula as MathML, with its source as text for those who do not see it. Words are one token, not a product of letters."""
    words = re.sub(r"\\mathrm\{([\w .,-]+)\}", r"\\text{\1}", " ".join(latex.split()))
    made = convert(words, display="block").replace(BAR, BAR.replace("true", "false"))
    made = FUNCTION.sub(r'\1<mspace width="0.167em" />', made)
    rest = [text for text in ElementTree.fromstring(made).itertext() if "\\" in text or "&" in text]
    if rest:
        raise ValueError(f"not converted: {', '.join(rest)}")
    return made.replace("<math ", f'<math alttext="{html.escape(" ".join(latex.split()))}" ', 1)


def fence(source: str, *_: Any, **__: Any) -> str:
    """A block ```math of a page, for pymdownx.superfences."""
    return f'<div class="formula">{mathml(source)}</div>'


def main(pages: list[str]) -> int:
    failed = 0
    for page in pages:
        for block in BLOCK.finditer(pathlib.Path(page).read_text(encoding="utf-8")):
            try:
                mathml(block[1])
            except Exception as problem:
                failed += 1
                print(f"{page}: {problem}: {block[1].strip()}", file=sys.stderr)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
