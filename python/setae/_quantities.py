# SPDX-License-Identifier: GPL-3.0-or-later
"""Results of setae: numbers with unit, uncertainty, band and source."""

from __future__ import annotations

import html
import json
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, fields
from functools import cached_property
from typing import Any

from . import _setae
from ._given import PREFIX, shown

Json = Any


def number(value: Json) -> float:
    """A number of JSON: null is NaN, infinity is a text."""
    if value is None:
        return math.nan
    return float(value)


@dataclass(frozen=True)
class Interval:
    """Ends of an interval at its confidence level, SI."""

    lower: float
    upper: float
    level: float = 0.95


@dataclass(frozen=True)
class Band:
    """Range of wavevectors that a number depends on [1/m]."""

    lower: float
    upper: float


@dataclass(frozen=True)
class Alert:
    """A warning about a number: code, subject, message and action."""

    code: str
    subject: str
    message: str
    action: str

    def __str__(self) -> str:
        return f"{self.code}: {self.subject}: {self.message}" + (f"; {self.action}" if self.action else "")


@dataclass(frozen=True)
class Quantity:
    """A number in SI with its uncertainty and source. ``float()`` gives its value.

    ``standard_error`` is NaN if it is unknown. ``interval`` has its own level, usually 95 %. ``method`` describes how both were found.
    ``band``: wavevectors that the number depends on; ``n``: measurements, points or pairs; ``source``: formula with reference.

    >>> import setae
    >>> E = setae.Quantity("youngs_modulus", "E", 0.7e6, "Pa", standard_error=0.02e6)
    >>> print(E, float(E))
    700 ± 20 kPa 700000.0
    """

    quantity: str
    symbol: str
    value: float
    unit: str
    standard_error: float = math.nan
    interval: Interval | None = None
    method: str = ""
    degrees_of_freedom: float | None = None
    seed: int | None = None
    band: Band | None = None
    n: int | None = None
    source: str = ""
    alerts: tuple[Alert, ...] = ()

    def __float__(self) -> float:
        return self.value

    def __str__(self) -> str:
        return _setae.format_uncertain(self.value, self.standard_error, self.unit)

    def to_html(self) -> str:
        """The number with ± and interval as in the report of a study."""
        between = (self.interval.lower, self.interval.upper, self.interval.level) if self.interval else None
        return _setae.quantity_html(self.value, self.standard_error, self.unit, between)

    def _repr_html_(self) -> str:
        return f"<i>{html.escape(self.symbol)}</i> = {self.to_html()}"

    def to_uncertainties(self) -> Any:
        """As ``ufloat`` of the package uncertainties, in SI."""
        from uncertainties import ufloat

        return ufloat(self.value, self.standard_error)

    def to_pint(self) -> Any:
        """As a measurement of the package pint, in SI."""
        import pint

        unit: Any = pint.application_registry(self.unit.replace("2", "**2").replace("3", "**3"))
        return (self.value * unit).plus_minus(self.standard_error)


def alerts_from(entries: Json) -> tuple[Alert, ...]:
    return tuple(Alert(entry["code"], entry["subject"], entry["message"], entry["action"]) for entry in entries)


def quantity_from(entry: Mapping[str, Json]) -> Quantity:
    """A quantity from the JSON of the program."""
    interval, band = entry.get("interval"), entry.get("band")
    return Quantity(
        quantity=entry["quantity"],
        symbol=entry["symbol"],
        value=number(entry["value"]),
        unit=entry["unit"],
        standard_error=number(entry.get("standard_error")),
        interval=Interval(number(interval["lower"]), number(interval["upper"]), interval["level"]) if interval else None,
        method=entry.get("method", ""),
        degrees_of_freedom=entry.get("degrees_of_freedom"),
        seed=entry.get("seed"),
        band=Band(number(band["lower"]), number(band["upper"])) if band else None,
        n=entry.get("n"),
        source=entry.get("source", ""),
        alerts=alerts_from(entry.get("alerts", ())),
    )


def is_quantity(entry: Json) -> bool:
    return isinstance(entry, dict) and {"quantity", "symbol", "value", "unit"} <= entry.keys()


def part(entry: Json) -> Any:
    """A read-only part of an answer: a quantity, another answer, a tuple or a value."""
    if is_quantity(entry):
        return quantity_from(entry)
    if isinstance(entry, dict):
        return Answer(json.dumps(entry))
    return tuple(map(part, entry)) if isinstance(entry, list) else entry


@dataclass(frozen=True, repr=False)
class Answer(Mapping[str, Any]):
    """Results by the names of the JSON: ``answer["loading"]["contact_modulus"]`` is a :class:`Quantity`.

    >>> answer = Answer('{"n": 3, "rms_slope": {"quantity": "rms_slope", "symbol": "s", "value": 0.5, "unit": "1"}}')
    >>> answer["n"], float(answer["rms_slope"]), list(answer)
    (3, 0.5, ['n', 'rms_slope'])
    """

    text: str

    def __post_init__(self) -> None:
        if PREFIX in self.text:
            object.__setattr__(self, "text", shown(self.text))

    def json(self) -> str:
        """The bytes that the program prints with ``--json``."""
        return self.text

    @cached_property
    def _data(self) -> Json:
        return json.loads(self.text)

    @property
    def data(self) -> Json:
        """The JSON as dictionaries and lists; every call makes new ones."""
        return json.loads(self.text)

    def __getstate__(self) -> dict[str, Any]:
        return {entry.name: getattr(self, entry.name) for entry in fields(self)}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state)

    def __getitem__(self, name: str) -> Any:
        return part(self._data[name])

    def __iter__(self) -> Iterator[str]:
        return iter(self._data)

    def __len__(self) -> int:
        return len(self._data)

    @property
    def quantities(self) -> tuple[Quantity, ...]:
        """The quantities at the top level, and those of the list "quantities"."""
        data = self._data
        entries: Sequence[Json] = data if isinstance(data, list) else [*data.values(), *data.get("quantities", ())]
        return tuple(quantity_from(entry) for entry in entries if is_quantity(entry))

    @property
    def alerts(self) -> tuple[Alert, ...]:
        data = self._data
        return alerts_from(data.get("alerts", ())) if isinstance(data, dict) else ()

    def __repr__(self) -> str:
        quantities = self.quantities
        parts = [f"{q.symbol or q.quantity} = {q}" for q in quantities[:6]] if quantities else list(self._data)
        return f"{type(self).__name__}({', '.join(map(str, parts))})"

    def _repr_html_(self) -> str:
        rows = "".join(
            f"<tr><td>{html.escape(q.quantity.replace('_', ' '))}</td><td><i>{html.escape(q.symbol)}</i></td>"
            f"<td>{q.to_html()}</td></tr>"
            for q in self.quantities
        )
        warnings = "".join(f"<li>{html.escape(str(alert))}</li>" for alert in self.alerts)
        return f"<table>{rows}</table>" + (f"<ul>{warnings}</ul>" if warnings else "")
