# SPDX-License-Identifier: GPL-3.0-or-later
"""Units of quantities, converted by the package pint, which is loaded at the first conversion."""

from __future__ import annotations

import re
from fractions import Fraction
from functools import cache
from typing import Any

from ._errors import InvalidArgument

#: Coherent units of SI that quantities have, by what they measure; the first of several with one dimension is preferred.
SI_UNITS = {
    "1": "a number without unit",
    "m": "a length",
    "m2": "an area",
    "m3": "a volume",
    "m4": "a spectral density",
    "1/m": "a wavevector or a curvature",
    "s": "a time",
    "1/s": "a rate",
    "m/s": "a speed",
    "kg": "a mass",
    "N": "a force",
    "Pa": "a pressure",
    "Pa/m": "a pressure per length",
    "J": "an energy",
    "J/m2": "an energy per area",
    "N/m": "a stiffness",
    "V": "a voltage",
    "m/V": "a length per voltage",
    "K": "a temperature",
}
_PREFIXES = "TGMkcdmuµμnpf"
_SUPERSCRIPTS = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")
_BASE = {"[length]": "m", "[mass]": "kg", "[time]": "s", "[temperature]": "K", "[substance]": "mol", "[current]": "A"}
_COHERENT = {
    "meter": "m", "kilogram": "kg", "second": "s", "kelvin": "K", "mole": "mol", "ampere": "A", "newton": "N", "pascal": "Pa",
    "joule": "J", "volt": "V", "watt": "W", "hertz": "Hz", "farad": "F", "gram": "kg",
}


def kind_of(unit: str) -> str:
    """What a unit measures; empty for a unit that no argument has.

    >>> kind_of("mJ/m2"), kind_of("um"), kind_of("furlong")
    ('an energy per area', 'a length', '')
    """
    plain = plain_unit(unit)
    without_prefix = plain[1:] if plain[:1] and plain[0] in _PREFIXES else ""
    return SI_UNITS.get(plain) or SI_UNITS.get(without_prefix, "")


def plain_unit(unit: str) -> str:
    """A unit as setae writes it in files and JSON.

    >>> plain_unit(" mJ/m² "), plain_unit("m**-1"), plain_unit("")
    ('mJ/m2', 'm-1', '1')
    """
    plain = unit.strip().translate(_SUPERSCRIPTS).replace("**", "").replace("^", "").replace("·", " ").replace("−", "-")
    return plain if plain not in ("", "-", "dimensionless") else "1"


def shown_unit(unit: str) -> str:
    """A unit as setae prints it.

    >>> shown_unit("mJ/m2"), shown_unit("1/m")
    ('mJ/m²', '1/m')
    """
    digits = str.maketrans("0123456789-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")
    return re.sub(r"(?<=[A-Za-zµμÅ])-?\d+(?![.\d])", lambda power: power[0].translate(digits), unit)


@cache
def registry() -> Any:
    """The registry of pint that the application uses."""
    import pint

    return pint.application_registry


@cache
def pint_unit(unit: str) -> Any:
    """The unit of pint."""
    spelled = re.sub(r"(?<=[A-Za-zµμÅ%])\^?(-?\d+)", r"**\1", plain_unit(unit))
    try:
        found = registry().parse_units("" if spelled == "1" else spelled)
        has_own_zero = registry().convert(0.0, found, registry().get_root_units(found)[1]) != 0.0
    except Exception as error:
        raise InvalidArgument(f"'{unit}' is not a known unit; expected one such as nm, um, mJ/m2, MPa, 1/m, m3") from error
    if has_own_zero:
        raise InvalidArgument(f"'{unit}' has a zero of its own; expected a unit of differences, such as K")
    return found


def unit_of_pint(unit: Any) -> str:
    """A unit of pint, of any registry, as setae spells it."""
    return plain_unit(f"{unit:~C}".replace("*", " ").replace("  ", "**"))


@cache
def factor(unit: str, to: str) -> float:
    """Factor from a unit to another.

    >>> factor("J/m2", "mJ/m2")
    1000.0
    """
    if unit == to:
        return 1.0
    source, target = pint_unit(unit), pint_unit(to)
    if source.dimensionality != target.dimensionality:
        raise InvalidArgument(f"{described(unit)} has no value in {described(to)}; expected units of one dimension")
    return float(registry().convert(1.0, source, target))


def described(unit: str) -> str:
    return "a number without unit" if unit == "1" else shown_unit(unit)


@cache
def have_one_dimension(unit: str, other: str) -> bool:
    return unit == other or bool(pint_unit(unit).dimensionality == pint_unit(other).dimensionality)


@cache
def si_unit(unit: str) -> str:
    """The SI unit of the dimension of a unit.

    >>> si_unit("mJ/m2"), si_unit("nm"), si_unit("Pa/m")
    ('J/m2', 'm', 'Pa/m')
    """
    return unit if unit in SI_UNITS else product(((unit, Fraction(1)),))[0]


@cache
def product(powers: tuple[tuple[str, Fraction], ...]) -> tuple[str, float]:
    """SI unit of a product of powers of units, and the factor to it. A named unit is used where it is shorter.

    >>> product((("J/m2", Fraction(1)), ("Pa", Fraction(-1)))), product((("N", Fraction(1)), ("mm", Fraction(-1))))
    (('m', 1.0), ('N/m', 1000.0))
    """
    made = registry().Unit("")
    for unit, power in powers:
        made = made * pint_unit(unit) ** (int(power) if power.denominator == 1 else float(power))
    composed = coherent(made)
    standard = next((unit for unit in SI_UNITS if pint_unit(unit).dimensionality == made.dimensionality), None)
    chosen = standard if standard is not None and symbols_of(standard) < len(composed) else spelled_product(composed)
    return chosen, float(registry().convert(1.0, made, pint_unit(chosen)))


def coherent(unit: Any) -> dict[str, Fraction]:
    """Powers of symbols of SI: those of the unit without prefixes, else those of the base units."""
    powers: dict[str, Fraction] = {}
    for name, power in unit._units.items():
        ((_, stem, _),) = registry().parse_unit_name(name)[:1]
        symbol = _COHERENT.get(name, _COHERENT.get(stem, ""))
        powers[symbol] = powers.get(symbol, Fraction(0)) + Fraction(power).limit_denominator(60)
    if "" in powers:
        powers = {_BASE[name]: Fraction(power).limit_denominator(60) for name, power in unit.dimensionality.items()}
    return {symbol: power for symbol, power in powers.items() if power != 0}


def symbols_of(unit: str) -> int:
    """Number of symbols in a unit.

    >>> symbols_of("1"), symbols_of("J/m2")
    (0, 2)
    """
    return len(re.findall(r"[A-Za-z]+", unit))


def spelled_product(powers: dict[str, Fraction]) -> str:
    """A product of powers of symbols as a text.

    >>> spelled_product({"J": Fraction(1), "m": Fraction(-2)}), spelled_product({"J": Fraction(1, 2), "m": Fraction(-1)})
    ('J/m2', 'J0.5/m')
    """

    def side(sign: int) -> list[str]:
        return [symbol + ("" if abs(p) == 1 else f"{float(abs(p)):g}") for symbol, p in powers.items() if p * sign > 0]

    above, below = " ".join(side(1)) or "1", side(-1)
    if not below:
        return above
    return f"{above}/{below[0]}" if len(below) == 1 else f"{above}/({' '.join(below)})"
