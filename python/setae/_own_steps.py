# SPDX-License-Identifier: GPL-3.0-or-later
"""Functions of Python as processing steps of a scan."""

from __future__ import annotations

import dataclasses
import functools
import inspect
import json
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from ._arrays import metres
from ._errors import Error, InvalidArgument
from ._tables import own_unit

if TYPE_CHECKING:
    from ._columns import Array
    from ._scan import Scan

#: A step: a function of the heights [m] as an array, which returns heights.
OwnStep = Callable[..., Any]


def with_own_step(scan: Scan, function: OwnStep, parameters: Mapping[str, Any]) -> Scan:
    """The scan whose heights are those that the function returns. The record of the step is its call, such as "median_filter(size=3)"."""
    earlier = history_of(scan)
    call = call_of(function, parameters)
    step = f"step {len(earlier['steps']) + 1} {call}"
    made = returned(function, scan, parameters, step)
    of = made if is_scan(made) else scan
    changed = replaced(of, of.heights if is_scan(made) else heights_of(made, scan.heights.shape, step), str(scan.file))
    earlier["pipeline"].append(call)
    earlier["steps"].append({"step": call, "numbers": [], "alerts": []})
    stated = {name: getattr(of, name) or getattr(scan, name) for name in ("instrument", "tip_radius", "resolution", "trend")}
    return dataclasses.replace(changed, earlier=json.dumps(earlier, ensure_ascii=False), **stated)


def history_of(scan: Scan) -> dict[str, list[Any]]:
    """The steps of a scan as typed, their records, and the warnings about reading."""
    data = scan.processing.data if scan.steps or scan.pipeline or scan.earlier else {"pipeline": [], "files": [{"steps": []}]}
    return {"pipeline": data["pipeline"], "steps": data["files"][0]["steps"], "alerts": [dataclasses.asdict(alert) for alert in scan.alerts]}


def returned(function: OwnStep, scan: Scan, parameters: Mapping[str, Any], step: str) -> Any:
    """The result of the function for a copy of the heights. An error of the function becomes one that names the step."""
    asked = {"scan": scan} if takes_scan(function) and "scan" not in parameters else {}
    try:
        return function(np.array(scan.heights), **asked, **parameters)
    except Exception as error:
        raise Error(f"{step}: {type(error).__name__}: {error}") from error


def takes_scan(function: OwnStep) -> bool:
    """Whether the function has a parameter "scan"."""
    try:
        return "scan" in inspect.signature(function).parameters
    except ValueError:  # functions in C without a signature
        return False


def call_of(function: OwnStep, parameters: Mapping[str, Any]) -> str:
    """A step as a call, without the values of arrays and other long parameters.

    >>> call_of(np.clip, {"a_min": 0.0, "a_max": None}), call_of(functools.partial(np.roll, shift=2), {})
    ('clip(a_min=0.0, a_max=None)', 'roll(shift=2)')
    """
    if isinstance(function, functools.partial):
        return call_of(function.func, {**function.keywords, **parameters})
    name = getattr(function, "__name__", type(function).__name__)
    return f"{name}({', '.join(f'{key}={short(value)}' for key, value in parameters.items())})"


def short(value: Any, most: int = 60) -> str:
    text = f"{type(value).__name__} of shape {value.shape}" if getattr(value, "ndim", 0) else repr(value)
    return text if len(text) <= most else text[: most - 1] + "…"


def is_scan(value: Any) -> bool:
    from ._scan import Scan

    return isinstance(value, Scan)


def heights_of(made: Any, shape: tuple[int, ...], step: str) -> Array:
    """The returned heights in metres. Raises an error for another shape, unit or kind of numbers."""
    if made is None:
        raise InvalidArgument(f"{step}: returned None; expected heights of shape {shape}, or a scan")
    is_labelled = hasattr(made, "dims") and hasattr(made, "coords")
    values = made.data if is_labelled else made
    try:
        heights = metres(values, own_unit(made) or "m" if is_labelled else "m")
    except (TypeError, ValueError) as error:
        raise InvalidArgument(f"{step}: {error}") from error
    if heights.shape != shape:
        raise InvalidArgument(f"{step}: returned heights of shape {heights.shape}; expected {shape}, or a scan, which states its size")
    if np.isinf(heights).any():
        raise InvalidArgument(f"{step}: returned infinite heights; expected numbers, or NaN where undefined")
    return heights


def replaced(scan: Scan, heights: Array, name: str) -> Scan:
    """Heights at the points of a scan as a scan of their own."""
    from . import _scan

    if scan.positions is not None:
        return _scan.scan(heights, x=scan.positions, unit="m", name=name)
    return _scan.Scan(name, source=(heights, list(map(float, scan.size)), scan.periodic))
