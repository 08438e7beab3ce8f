# SPDX-License-Identifier: GPL-3.0-or-later
"""Threads of computations."""

from __future__ import annotations

from . import _setae
from ._options import require


def limit_threads(count: int) -> None:
    """Number of threads of later computations; 0: one per core.

    Parameters
    ----------
    count : int
        number of threads; 0: one per core

    Raises
    ------
    TypeError
        for a value of another kind

    Examples
    --------
    >>> limit_threads(0)
    """
    require("a whole number", count=count)
    _setae.limit_threads(int(count))
