# SPDX-License-Identifier: GPL-3.0-or-later
"""What JSON holds: names, types, units and meanings."""

from __future__ import annotations

import json
from typing import Any

from . import _setae


def schema(verb: str) -> dict[str, Any]:
    """JSON Schema (draft 2020-12) of what ``setae VERB --json`` prints and ``.json()`` of the function's answer gives; "study": of study.json.

    >>> import setae
    >>> setae.schema("psd")["properties"]["wavevector"]["unit"]
    '1/m'
    """
    found: dict[str, Any] = json.loads(_setae.schema(verb))
    return found
