# SPDX-License-Identifier: GPL-3.0-or-later
"""Arguments as texts with units for the parser of the library, and the messages for wrong ones."""

from __future__ import annotations

import difflib
import os
import pathlib
import re
from collections.abc import Sequence
from dataclasses import replace
from numbers import Integral, Real
from typing import Any, TypeVar, Union

import numpy as np

from ._errors import InvalidArgument
from ._names import RENAMED, option_of
from ._quantities import PintQuantity, Quantity, UncertainNumber, of_other_package
from ._units import have_one_dimension, kind_of


class Length(float):
    """A length in metres, such as the extents of a scan: a float that is accepted as an argument with a unit.

    >>> text(Length(5e-6))
    '5e-06 m'
    """

    @property
    def unit(self) -> str:
        return "m"


#: A value with a unit: a text such as "10 ± 2 nm", a quantity of setae or pint, a length of a scan, or, without a dimension, a number of
#: uncertainties.
Text = Union[str, Quantity, PintQuantity, UncertainNumber, Length]
#: Extents: "5 um x 5 um", or one value per direction, as ``scan.size`` gives them.
Size = Union[Text, "tuple[Text, ...]", "list[Text]"]
#: A file by its path.
Path = Union[str, "os.PathLike[str]"]
#: Folder of the mappings that are found by their names.
MAPPINGS = str(pathlib.Path(__file__).parent / "share" / "setae" / "mappings")

#: Examples of arguments that many functions have; those of requests are in their documentation.
EXAMPLES = {"tip_radius": "10 ± 2 nm", "resolution": "0.5 um", "size": "5 um x 5 um", "longest_wavelength": "10 um",
            "shortest_wavelength": "100 nm", "longest_distance": "10 um",
            "distance": "100 nm", "pressure": "1 MPa", "contact_point": "1.2 um", "pitch": "10 um",
            "pixel_size": "2.05 um", "scale_bar": "500 nm", "foil_thickness": "50 nm"}
_NUMBER = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?\s*([^\d\s]\S*(?: \S+)*|)")
_SIGNS = re.compile(r"±|\+-|\+/-|\bto\b|(?<=[\w.])\s*\bx\b\s*(?=[\d.])")
_EXAMPLE = re.compile(r'such as "([^"]*)"')
#: Options of requests that take a standard error. Other options take the value of a quantity without it.
UNCERTAIN = {
    "Analysis": ("longest_wavelength", "shortest_wavelength"),
    "LoopBodies": ("radius", "lens_height", "layer_thickness"),
    "LoopSettings": ("machine_stiffness",),
    "Solids": ("youngs_modulus", "W_int", "surface_energy", "radius"),
}
_KINDS = {"True or False": (bool, np.bool_), "a whole number": (Integral,), "a number": (Real,), "a text": (str,)}


def text(value: Text | float | None, argument: str = "", example: str = "") -> str:
    """The text for the parser of the library, which reports errors in it.

    >>> text("10 nm"), text(Quantity("", "", 12.5, "nm", 0.5)), text(0.3)
    ('10 nm', '12.5 ± 0.5 nm', '0.3')
    """
    if value is None:
        return ""
    if isinstance(value, str):
        require_unit(value, argument, example)
        return value
    if isinstance(value, Length):
        return f"{float(value)!r} {value.unit}"
    quantity = value if isinstance(value, Quantity) else of_other_package(value)
    if quantity is not None:
        error = quantity.standard_error
        number = f"{float(quantity.value)!r}{f' ± {float(error)!r}' if error > 0.0 else ''}"
        if quantity.unit != "1":
            return f"{number} {quantity.unit}"
        require_unit(number, argument, example)
        return number
    if isinstance(value, Real) and not isinstance(value, bool):
        require_unit(repr(plain_number(value)), argument, example)
        return repr(plain_number(value))
    raise TypeError(f"{named_argument(argument)}{type(value).__name__}; expected a text with its unit, such as '{example or '10 ± 2 nm'}'")


def plain_number(value: Any) -> int | float:
    return int(value) if isinstance(value, Integral) else float(value)


def refusal(argument: str, given: str, problem: str, expected: str) -> InvalidArgument:
    """The error for a value of an argument."""
    error = InvalidArgument(f"{named_argument(argument)}'{given}' {problem}; expected {expected}")
    error.got, error.expected = given, expected
    return error


def named_argument(argument: str) -> str:
    return f"{argument}: " if argument else ""


def require_unit(given: str, argument: str, example: str) -> None:
    """Raises an error for a number without unit, or with a unit of another dimension, where the argument has a dimension."""
    example = example or EXAMPLES.get(argument, "")
    kind = kind_of_text(example)
    numbers = [_NUMBER.fullmatch(number.strip()) for number in _SIGNS.split(given)]
    if not kind or numbers[0] is None or (len(numbers) == 1 and numbers[0][3] == "" and float(numbers[0][0]) == 0.0):
        return
    of_given = kind_of_text(given)
    if all(number is not None and number[3] == "" for number in numbers):
        raise refusal(argument, given, "has no unit", f'{kind} with its unit, such as "{example}"')
    if of_given and {of_given, kind} != {"a stiffness", "an energy per area"} and of_given != kind:
        raise refusal(argument, given, f"is {of_given}", f'{kind}, such as "{example}"')


def kind_of_text(given: str) -> str:
    """What a text measures, by its last unit; empty for a text that is no number with a known unit.

    >>> kind_of_text("0.7 ± 0.02 MPa"), kind_of_text("5 um x 5 um"), kind_of_text("auto")
    ('a pressure', 'a length', '')
    """
    parts = [_NUMBER.fullmatch(part.strip()) for part in _SIGNS.split(given)]
    last = parts[-1]
    return kind_of(last[3]) if last is not None and all(parts) and last[3] else ""


def size_text(size: Size | None) -> str:
    """Extents as one text.

    >>> size_text((Length(5e-6), "2 um")), size_text("1 mm")
    ('5e-06 m x 2 um', '1 mm')
    """
    if isinstance(size, (tuple, list)):
        return " x ".join(text(exact(length), "size") for length in size)
    if getattr(getattr(size, "magnitude", None), "ndim", 0) > 0:  # an array of pint
        extents: Any = size
        return size_text([f"{length!r} m" for length in extents.to("m").magnitude.tolist()])
    return text(exact(size), "size")


def texts(value: Sequence[str] | str) -> list[str]:
    """A list of texts from a list or a single text."""
    return [value] if isinstance(value, str) else list(value)


def require(kind: str, **given: Any) -> None:
    """Raises an error for an argument of another kind: "True or False", "a whole number", "a number", "a text"."""
    for argument, value in given.items():
        if value is None or (isinstance(value, _KINDS[kind]) and (isinstance(value, bool) <= (kind == "True or False"))):
            continue
        raise TypeError(f"{argument}: {type(value).__name__}; expected {kind}")


Request = TypeVar("Request")


def filled(request: Request, **given: Any) -> Request:
    """A request of the library with the given values; None keeps the default of the library."""
    for name, value in given.items():
        if value is not None:
            fill(request, name, value)
    return request


def fill(request: Any, name: str, value: Any) -> None:
    """Sets the option of an argument. A quantity becomes a text, or a number where the option is one."""
    option = option_of(request, name)
    if not hasattr(request, option):
        require_known(name, [RENAMED.get(known, known) for known in dir(request) if known[0] != "_"])
    now = getattr(request, option)
    if isinstance(now, list):
        setattr(request, option, texts(value) if isinstance(value, str) else list(value) if isinstance(value, tuple) else value)
        return
    value = text(value) if isinstance(value, Length) else value
    quantity = value if isinstance(value, Quantity) else of_other_package(value)
    value = plain_number(value) if isinstance(value, Real) and not isinstance(value, bool) else value
    is_text = isinstance(now, str) or (now is None and takes(request, option, "", now))
    if is_text and (quantity is not None or isinstance(value, (str, int, float))) and not isinstance(value, bool):
        value = option_text(type(request), name, value if quantity is None else quantity)
        require_word(value, name, getattr(type(request), option).__doc__ or "", now)
    elif quantity is not None:
        value = number_of(quantity, name)
    setattr(request, option, value)


def require_word(given: str, argument: str, documentation: str, default: Any) -> None:
    """Raises an error for a word that the documentation of an option does not list."""
    listed = re.search(r"; one of ([\w, ]+)$", documentation)
    words = listed[1].split(", ") if listed else []
    if not words or given in (*words, default, ""):
        return
    near = difflib.get_close_matches(given, words, 1)
    hint = f"; did you mean '{near[0]}'?" if near else ""
    raise refusal(argument, given, f"is unknown{hint}", f"one of {', '.join(words)}")


def example_of(request: type, name: str) -> str:
    """The example in the documentation of the option of an argument; empty without one."""
    found = _EXAMPLE.search(getattr(request, option_of(request, name)).__doc__ or "")
    return found[1] if found else ""


def texts_of(request: type, **given: Text | None) -> dict[str, str]:
    """Options of a request as texts."""
    return {name: option_text(request, name, value) for name, value in given.items()}


def option_text(request: type, name: str, value: Text | float | None) -> str:
    """An option as a text; of a quantity without its standard error where the option takes none."""
    takes_error = name in UNCERTAIN.get(request.__name__, ())
    return text(value if takes_error else exact(value), name, example_of(request, name))


def exact(value: Any) -> Any:
    """A quantity without its standard error; other values as they are."""
    quantity = value if isinstance(value, Quantity) else of_other_package(value)
    return value if quantity is None else replace(quantity, standard_error=0.0)


def takes(request: Any, name: str, value: Any, before: Any) -> bool:
    """Whether an option without a value takes one of this kind."""
    try:
        setattr(request, name, value)
    except TypeError:
        return False
    setattr(request, name, before)
    return True


def number_of(quantity: Quantity, argument: str) -> float:
    """The value of a quantity for an argument that is a number; its standard error does not count."""
    if not have_one_dimension(quantity.unit, "1"):
        raise InvalidArgument(f"{argument}: {quantity} has a unit; expected a number without unit")
    return float(quantity.to("1"))


def require_known(name: str, known: Sequence[str]) -> None:
    """Raises an error for an argument that a function does not have."""
    if name not in known:
        near = difflib.get_close_matches(name, known, 1)
        raise TypeError(f"unknown argument '{name}'; " + (f"did you mean '{near[0]}'?; " if near else "") + f"expected one of {', '.join(known)}")


def named(value: int | str | None) -> str | None:
    """A channel or image by its number, counted from 0, or its name, as a text for the library."""
    return None if value is None else str(value)


def path(value: Path) -> str:
    """A path as a text."""
    if not isinstance(value, (str, os.PathLike)):
        raise TypeError(f"{type(value).__name__}; expected the path of a file")
    return os.fspath(value)
