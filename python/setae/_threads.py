# SPDX-License-Identifier: GPL-3.0-or-later
"""Threads of computations."""

from __future__ import annotations

from . import _setae
from ._options import require


def limit_threads(count: int) -> None:
    """Number of threads of later computations; 0: one per core.

    >>> limit_threads(0)
    """
    require("a whole number", count=count)
    _setae.limit_threads(int(count))
