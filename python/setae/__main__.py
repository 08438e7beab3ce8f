# SPDX-License-Identifier: GPL-3.0-or-later
"""``python -m setae`` is the program ``setae``."""

from __future__ import annotations

import os
import pathlib
import sys
from typing import NoReturn


def program() -> pathlib.Path:
    """The program that is installed with this package."""
    return pathlib.Path(__file__).parent / "bin" / "setae"


def main() -> NoReturn:
    os.execv(program(), ["setae", *sys.argv[1:]])


if __name__ == "__main__":
    main()
