# SPDX-License-Identifier: GPL-3.0-or-later
"""Arguments as texts with units for the parser of the library."""

from __future__ import annotations

import math
import os
import pathlib
from collections.abc import Sequence
from typing import Any, TypeVar, Union

from ._quantities import Quantity


class Length(float):
    """A length in metres, such as the extents of a scan: a float that is accepted as an argument with a unit.

    >>> text(Length(5e-6))
    '5e-06 m'
    """

    @property
    def unit(self) -> str:
        return "m"


#: A value with a unit: a text such as "10 ± 2 nm", a quantity from setae, or a length of a scan. A number without unit is refused.
Text = Union[str, Quantity, Length]
#: Extents: "5 um x 5 um", or one value per direction, as ``scan.size`` gives them.
Size = Union[Text, "tuple[Text, ...]", "list[Text]"]
#: A file by its path.
Path = Union[str, "os.PathLike[str]"]
#: Folder of the mappings that are found by their names.
MAPPINGS = str(pathlib.Path(__file__).parent / "share" / "setae" / "mappings")


def text(value: Text | float | None) -> str:
    """The text for the parser of the library, which reports errors in it."""
    if value is None:
        return ""
    if isinstance(value, Quantity):
        error = value.standard_error
        return f"{value.value!r}{'' if math.isnan(error) else f' ± {error!r}'} {value.unit}"
    if isinstance(value, str):
        return value
    if isinstance(value, Length):
        return f"{float(value)!r} {value.unit}"
    if isinstance(value, (int, float)) and not isinstance(value, bool):
        return repr(value)
    raise TypeError(f"{type(value).__name__}; expected a text with its unit, such as '10 ± 2 nm'")


def size_text(size: Size | None) -> str:
    """Extents as one text.

    >>> size_text((Length(5e-6), "2 um")), size_text("1 mm")
    ('5e-06 m x 2 um', '1 mm')
    """
    if isinstance(size, (tuple, list)):
        return " x ".join(map(text, size))
    if getattr(getattr(size, "magnitude", None), "ndim", 0) > 0:  # an array of pint
        extents: Any = size
        return size_text([f"{length!r} m" for length in extents.to("m").magnitude.tolist()])
    return text(size)


def texts(value: Sequence[str] | str) -> list[str]:
    """A list of texts from a list or a single text."""
    return [value] if isinstance(value, str) else list(value)


Request = TypeVar("Request")


def filled(request: Request, **given: Any) -> Request:
    """A request of the library with the given values; None keeps the default of the library."""
    for name, value in given.items():
        if value is None:
            continue
        if not hasattr(request, name):
            raise TypeError(f"unknown argument '{name}'; expected one of {', '.join(n for n in dir(request) if n[0] != '_')}")
        if isinstance(getattr(request, name), list):
            value = texts(value) if isinstance(value, str) else value
        setattr(request, name, text(value) if isinstance(value, (Quantity, Length)) else value)
    return request


def named(value: int | str | None) -> str | None:
    """A channel or image by its number, counted from 0, or its name, as a text for the library."""
    return None if value is None else str(value)


def path(value: Path) -> str:
    return os.fspath(value)
