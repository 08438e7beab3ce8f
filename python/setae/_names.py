# SPDX-License-Identifier: GPL-3.0-or-later
"""Names of arguments and functions: names of Python for options of the library, and former names, which are deprecated.

docs/development/adr/0012-python-names.md contains the rules.
"""

from __future__ import annotations

import functools
import re
import warnings
from collections.abc import Callable, Mapping
from typing import Any, TypeVar, cast

from ._errors import Error

Function = TypeVar("Function", bound="Callable[..., Any]")

#: The version since which former names are deprecated.
SINCE = "0.1"

#: Names of Python for options of the library, by the name of the option, which was the name of the argument before.
RENAMED = {
    "E": "youngs_modulus",
    "counter_E": "counter_youngs_modulus",
    "rough_E": "rough_youngs_modulus",
    "nu": "poisson_ratio",
    "counter_nu": "counter_poisson_ratio",
    "rough_nu": "rough_poisson_ratio",
    "gamma": "surface_energy",
    "hurst": "hurst_exponent",
    "range": "interaction_range",
    "layer": "layer_thickness",
    "longest": "longest_wavelength",
    "shortest": "shortest_wavelength",
    "all": "keep_unreliable",
    "pixel": "pixel_size",
    "detrend": "trend",
    "surfaces": "realisations",
    "seeds": "realisations",
    "largest_move": "max_move",
    "largest_mode": "max_mode",
    "smallest_mode": "min_mode",
    "smallest_radius": "min_radius",
    "smallest_void": "min_void_area",
    "least_length": "min_length",
}

#: Functions by their former names.
FORMER_FUNCTIONS = {
    "conform": "patch_survey",
    "contact_compare": "contact_comparison",
    "scale_dependent": "scale_dependent_roughness",
}


def option_of(request: Any, name: str) -> str:
    """The option of a request for an argument.

    >>> from types import SimpleNamespace
    >>> option_of(SimpleNamespace(layer="1 um"), "layer_thickness"), option_of(SimpleNamespace(seed=1), "seed")
    ('layer', 'seed')
    """
    if hasattr(request, name):
        return name
    return next((option for option, argument in RENAMED.items() if argument == name and hasattr(request, option)), name)


def renamed(*former: str, **own: str) -> Callable[[Function], Function]:
    """Makes a function accept former names of its arguments, with a DeprecationWarning. Messages of its errors contain the new names.

    Former names are those of ``RENAMED``, or are given with the new name as in ``longest="longest_distance"``.

    >>> @renamed("nu")
    ... def modulus(*, poisson_ratio): return 1.0 - poisson_ratio**2
    >>> with warnings.catch_warnings(record=True, action="always") as warned:
    ...     modulus(nu=0.5), str(warned[0].message)
    (0.75, "nu: deprecated since setae 0.1; use the argument 'poisson_ratio'")
    """
    names = {**{name: RENAMED[name] for name in former}, **own}

    def accepting(function: Function) -> Function:
        @functools.wraps(function)
        def call(*arguments: Any, **given: Any) -> Any:
            try:
                return function(*arguments, **(given if given.keys().isdisjoint(names) else with_new_names(given, names)))
            except (Error, TypeError) as error:
                error.args = tuple(in_new_names(text, names) for text in error.args)
                raise

        cast("Any", call).former_names = names
        return cast("Function", call)

    return accepting


def with_new_names(given: Mapping[str, Any], names: Mapping[str, str]) -> dict[str, Any]:
    """Arguments by their new names; a former name raises a warning at the call of the function."""
    found: dict[str, Any] = {}
    for name, value in given.items():
        new = names.get(name, name)
        if new in found or (new != name and new in given):
            raise TypeError(f"{new}: given twice, also by the former name '{name}'")
        if new != name:
            warnings.warn(f"{name}: deprecated since setae {SINCE}; use the argument '{new}'", DeprecationWarning, stacklevel=3)
        found[new] = value
    return found


def in_new_names(text: Any, names: Mapping[str, str]) -> Any:
    """A message with the new names of arguments.

    >>> in_new_names('nu: 0.7; expected `range`, or range="1 nm"', {"nu": "poisson_ratio", "range": "interaction_range"})
    'poisson_ratio: 0.7; expected `interaction_range`, or interaction_range="1 nm"'
    """
    if not isinstance(text, str):
        return text
    former = "|".join(names)
    return re.sub(rf"^({former})(?=: )|(?<=`)({former})(?=`)|(?<![\w.])({former})(?==\")", lambda found: names[found[0]], text)


def former_function(name: str, of: Mapping[str, Any]) -> Any:
    """The function for a former name in a namespace, with a DeprecationWarning.

    Raises
    ------
    AttributeError
        for a name that was never one of setae
    """
    if name not in FORMER_FUNCTIONS:
        raise AttributeError(f"module 'setae' has no attribute '{name}'")
    new = FORMER_FUNCTIONS[name]
    warnings.warn(f"setae.{name}: deprecated since setae {SINCE}; use setae.{new}", DeprecationWarning, stacklevel=3)
    return of[new]


def former_method(name: str, method: Function) -> Function:
    """A method by its former name, with a DeprecationWarning at its call."""

    @functools.wraps(method)
    def call(*arguments: Any, **given: Any) -> Any:
        warnings.warn(f"{name}: deprecated since setae {SINCE}; use {method.__name__}", DeprecationWarning, stacklevel=2)
        return method(*arguments, **given)

    cast("Any", call).is_former = True
    return cast("Function", call)
