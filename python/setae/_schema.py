# SPDX-License-Identifier: GPL-3.0-or-later
"""JSON Schemas: names, types, units and meanings."""

from __future__ import annotations

import json
from typing import Any

from . import _setae
from ._options import require


def schema(command: str) -> dict[str, Any]:
    """JSON Schema (draft 2020-12) of the output of ``setae COMMAND --json`` and of ``.json()`` of results; "study": of study.json.

    Parameters
    ----------
    command : str
        name of the command, such as 'psd' or 'contact solve'; 'study' for study.json

    Returns
    -------
    dict
        the schema, with units and meanings

    Raises
    ------
    InvalidArgument
        for a command without JSON

    Examples
    --------
    >>> import setae
    >>> setae.schema("psd")["properties"]["wavevector"]["unit"]
    '1/m'
    """
    require("a text", command=command)
    found: dict[str, Any] = json.loads(_setae.schema(command))
    return found
