# SPDX-License-Identifier: GPL-3.0-or-later
"""The version, and the steps of pipelines."""

from __future__ import annotations

from . import _setae


def version() -> str:
    """Version of setae with its commit.

    Returns
    -------
    str
        such as "0.1.0+g1a2b3c4"

    Examples
    --------
    >>> version().split(".")[0].isdigit()
    True
    """
    return _setae.version()


def steps() -> list[str]:
    """Steps of pipelines for :meth:`Scan.process`; docs/reference/processing-steps.md describes them.

    Returns
    -------
    list of str
        names of the steps

    Examples
    --------
    >>> "level_plane" in steps()
    True
    """
    return list(_setae.steps())
