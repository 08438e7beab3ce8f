# SPDX-License-Identifier: GPL-3.0-or-later
"""Results of setae: mappings by the names of the JSON, with the same entries as attributes."""

from __future__ import annotations

import difflib
import html
import json
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, fields
from functools import cached_property
from typing import TYPE_CHECKING, Any, ClassVar

from ._given import shown
from ._quantities import Alert, Json, Quantity, alerts_from, is_quantity, number, quantity_from, uncertain

if TYPE_CHECKING:
    from typing_extensions import Self

#: Parameters of fits whose JSON does not name the rows of the covariance.
ROWS = (("contact_modulus", "work_of_adhesion", "contact_point"), ("threshold", "reference_speed", "exponent", "contact_modulus"))


class Errors:
    """Errors of the quantities of one result. Equal numbers are one number, and parameters of one fit are correlated."""

    def __init__(self, data: Json) -> None:
        self._data = data

    @cached_property
    def _known(self) -> dict[tuple[str, float, float], Any]:
        known: dict[tuple[str, float, float], Any] = {}
        for fit in dictionaries(self._data):
            for quantity, error in correlated(fit):
                known.setdefault((quantity.quantity, quantity.value, quantity.standard_error), error)
        return known

    def of(self, quantity: Quantity) -> Any:
        key = quantity.quantity, quantity.value, quantity.standard_error
        if key not in self._known:
            self._known[key] = uncertain(quantity.value, quantity.standard_error)
        return self._known[key]


def dictionaries(data: Json) -> Iterator[dict[str, Json]]:
    """All dictionaries in JSON."""
    if isinstance(data, dict):
        yield data
    for entry in data.values() if isinstance(data, dict) else data if isinstance(data, list) else ():
        yield from dictionaries(entry)


def correlated(fit: dict[str, Json]) -> list[tuple[Quantity, Any]]:
    """The parameters of a fit with a covariance, with their numbers of uncertainties."""
    names, rows = covariance_of(fit)
    listed = [entry for entry in fit.get("parameters", ()) if is_quantity(entry)]
    entries = {key: entry for entry in listed for key in (entry["quantity"], entry["symbol"])} or fit
    found = [quantity_from(entries[name]) if is_quantity(entries.get(name)) else None for name in names]
    chosen = [i for i, q in enumerate(found) if q is not None and 0.0 < q.standard_error < math.inf and rows[i][i] > 0.0]
    if len(chosen) < 2:
        return []
    from uncertainties import correlated_values_norm

    matrix = [[rows[i][j] / math.sqrt(rows[i][i] * rows[j][j]) for j in chosen] for i in chosen]
    quantities = [q for q in (found[i] for i in chosen) if q is not None]
    made = list(zip(quantities, correlated_values_norm([(q.value, q.standard_error) for q in quantities], matrix)))
    return [*made, *proportional(fit, made)]


def covariance_of(fit: dict[str, Json]) -> tuple[Sequence[str], list[list[float]]]:
    """Names and rows of the covariance of a fit; no names without one."""
    matrix, names = fit.get("covariance"), fit.get("parameters")
    if isinstance(matrix, dict):
        names, matrix = [name.removeprefix("ln ") for name in matrix["of"]], matrix["rows"]
    else:
        names = names or next((list(rows) for rows in ROWS if rows[0] in fit), [])
    if not matrix or not all(isinstance(value, (int, float)) for row in matrix for value in row):
        return [], []
    return names[: len(matrix)], matrix


def proportional(fit: dict[str, Json], made: list[tuple[Quantity, Any]]) -> list[tuple[Quantity, Any]]:
    """E of a fit from its E*, where the relative errors are equal."""
    if not is_quantity(fit.get("youngs_modulus")):
        return []
    youngs_modulus = quantity_from(fit["youngs_modulus"])
    moduli = [(modulus, error) for modulus, error in made if modulus.quantity == "contact_modulus" and modulus.value != 0.0]
    ratios = [(youngs_modulus.value / modulus.value, modulus, error) for modulus, error in moduli]
    return [
        (youngs_modulus, ratio * error)
        for ratio, modulus, error in ratios
        if math.isclose(youngs_modulus.standard_error, ratio * modulus.standard_error, rel_tol=1e-9)
    ]


class Result(Mapping[str, Any]):
    """A result: a mapping by the names of the JSON and by symbols of quantities, with the same entries as attributes.

    Numbers with a unit are quantities, objects are results, lists are tuples. ``json()`` gives the bytes of the program, ``to_dict()`` the
    dictionaries in it.
    """

    #: Entries of the JSON that are lists of objects: ``to_pandas()`` gives the first that exists, else the quantities.
    tables: ClassVar[tuple[str, ...]] = ()

    def json(self) -> str:
        """The bytes that the program prints with ``--json``."""
        raise NotImplementedError

    @cached_property
    def _data(self) -> Json:
        return json.loads(self.json())

    @property
    def data(self) -> Json:
        """The JSON as dictionaries and lists; every call makes new ones."""
        return json.loads(self.json())

    def to_dict(self) -> dict[str, Any]:
        """The JSON as dictionaries, lists and numbers."""
        found: dict[str, Any] = self.data
        return found

    @cached_property
    def _shared(self) -> Errors:
        return Errors(self._data)

    @cached_property
    def _parts(self) -> dict[str, Any]:
        return {}

    def _entry(self, name: str) -> Any:
        """An entry of the JSON; the same object at every call."""
        if name not in self._parts:
            self._parts[name] = part(self._data[name], self._shared)
        return self._parts[name]

    def _numbers(self) -> dict[str, Json]:
        """Entries of the JSON that are numbers with a unit, by name."""
        units = self._data.get("units")
        return {
            name: {"quantity": name, "symbol": "", "value": value, "unit": units[name]}
            for name, value in self._data.items()
            if isinstance(units, dict) and name in units and isinstance(value, (int, float))
        }

    @property
    def quantities(self) -> tuple[Quantity, ...]:
        """The quantities at the top level, and those of the list "quantities"."""
        data = self._data
        listed = data if isinstance(data, list) else data.get("quantities", ())
        own = () if isinstance(data, list) else [self._entry(name) for name, entry in data.items() if is_quantity(entry)]
        return (*own, *(quantity_from(entry, self._shared) for entry in listed if is_quantity(entry)))

    @cached_property
    def _kept(self) -> tuple[Quantity, ...]:
        return self.quantities

    @cached_property
    def _by_name(self) -> dict[str, Quantity]:
        named: dict[str, Quantity] = {}
        for quantity in self._kept:
            named.setdefault(quantity.quantity, quantity)
        if isinstance(self._data, dict):
            for name, entry in self._numbers().items():
                if name not in named:
                    named[name] = quantity_from(entry, self._shared)
        return named

    @cached_property
    def _by_symbol(self) -> dict[str, Quantity]:
        named: dict[str, Quantity] = {}
        for quantity in self._kept:
            named.setdefault(quantity.symbol, quantity)
        return named

    @property
    def alerts(self) -> tuple[Alert, ...]:
        data = self._data
        return alerts_from(data.get("alerts", ())) if isinstance(data, dict) else ()

    def __getitem__(self, name: str) -> Any:
        entries = self._data if isinstance(self._data, dict) else {}
        if isinstance(entries.get(name), (dict, list, str)):
            return self._entry(name)
        if name in self._by_name:
            return self._by_name[name]
        if name in entries:
            return self._entry(name)
        if name in self._by_symbol:
            return self._by_symbol[name]
        raise KeyError(unknown(name, self._completions()))

    def __copy__(self) -> Self:
        """A copy in the same process shares arrays and objects of the library."""
        copied = object.__new__(type(self))
        copied.__dict__.update(self.__dict__)
        return copied

    def __dask_tokenize__(self) -> tuple[str, Any]:
        """Dask identifies a result by the content of its pickle."""
        return type(self).__name__, self.__getstate__()

    def __iter__(self) -> Iterator[str]:
        return iter(self._data)

    def __len__(self) -> int:
        return sum(1 for _ in self)

    def __eq__(self, other: object) -> bool:
        return self is other

    __hash__ = object.__hash__

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        try:
            return self[name]
        except KeyError as error:
            raise AttributeError(f"{type(self).__name__}: {error.args[0]}") from None

    def _completions(self) -> list[str]:
        return list(dict.fromkeys([*self, *self._by_symbol]))

    def _ipython_key_completions_(self) -> list[str]:
        return self._completions()

    def __dir__(self) -> list[str]:
        return sorted({*super().__dir__(), *(name for name in self if name.isidentifier())})

    def _listed(self) -> list[dict[str, Json]] | None:
        return next((self._data[name] for name in self.tables if name in self._data), None)

    def to_pandas(self) -> Any:
        """As a DataFrame of pandas: one row per quantity, or per entry of the list that the result consists of. Units are in ``attrs``."""
        import pandas

        listed = self._listed()
        if listed is None:
            return pandas.DataFrame([row_of(quantity) for quantity in self.quantities])
        table = pandas.json_normalize([plain_row(entry) for entry in listed])
        table.attrs["units"] = {name: entry["unit"] for row in listed for name, entry in row.items() if is_quantity(entry)}
        return table

    def __repr__(self) -> str:
        quantities = self.quantities
        parts = [f"{q.symbol or q.quantity} = {q}" for q in quantities[:6]] if quantities else list(self)
        return f"{type(self).__name__}({', '.join(map(str, parts))}{', …' if len(quantities) > 6 else ''})"

    def _repr_html_(self) -> str:
        shown = quantities_html(self.quantities) + rows_html(self._listed() or ())
        return (shown or entries_html(self)) + alerts_html(self.alerts)


@dataclass(frozen=True, repr=False)
class Answer(Result):
    """A result that is the JSON of a command: ``answer["loading"]["contact_modulus"]`` or ``answer.loading.contact_modulus``.

    >>> answer = Answer('{"n": 3, "rms_slope": {"quantity": "rms_slope", "symbol": "s", "value": 0.5, "unit": "1"}}')
    >>> answer["n"], float(answer["rms_slope"]), answer["s"], answer.rms_slope, list(answer)
    (3, 0.5, 0.5000, 0.5000, ['n', 'rms_slope'])
    """

    text: str

    def __post_init__(self) -> None:
        object.__setattr__(self, "text", shown(self.text))

    def json(self) -> str:
        """The bytes that the program prints with ``--json``."""
        return self.text

    def __getstate__(self) -> dict[str, Any]:
        return {entry.name: getattr(self, entry.name) for entry in fields(self)}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state)


def part(entry: Json, shared: Errors | None = None) -> Any:
    """A read-only part of an answer: a quantity, another answer, a tuple or a value."""
    if is_quantity(entry):
        return quantity_from(entry, shared)
    if isinstance(entry, dict):
        found = Answer(json.dumps(entry))
        found.__dict__.update(_data=entry)
        if shared is not None:
            found.__dict__.update(_shared=shared)
        return found
    return tuple(part(value, shared) for value in entry) if isinstance(entry, list) else entry


def unknown(name: str, known: list[str]) -> str:
    """The message for a name that does not exist."""
    near = difflib.get_close_matches(str(name), known, 3) or known
    return f"no '{name}'; expected one of {', '.join(near[:12])}{', …' if len(near) > 12 else ''}"


def row_of(quantity: Quantity) -> dict[str, Any]:
    """A quantity as a row of a table."""
    between = quantity.interval
    return {
        "quantity": quantity.quantity,
        "symbol": quantity.symbol,
        "value": quantity.value,
        "standard_error": quantity.standard_error,
        "lower": between.lower if between else math.nan,
        "upper": between.upper if between else math.nan,
        "unit": quantity.unit,
    }


def plain_row(entry: dict[str, Json]) -> dict[str, Any]:
    """An object as a row of a table: quantities are columns of their values and of their standard errors."""
    row: dict[str, Any] = {}
    for name, value in entry.items():
        if is_quantity(value):
            row[name], row[f"{name}_standard_error"] = number(value["value"]), number(value.get("standard_error"))
        else:
            row[name] = value
    return row


def quantities_html(quantities: Sequence[Quantity]) -> str:
    """Quantities as a table; empty without quantities."""
    rows = "".join(
        f"<tr><td>{html.escape(q.quantity.replace('_', ' '))}</td><td><i>{html.escape(q.symbol)}</i></td><td>{q.to_html()}</td></tr>"
        for q in quantities
    )
    return f"<table>{rows}</table>" if rows else ""


def rows_html(listed: Sequence[dict[str, Json]], most: int = 20) -> str:
    """The first of a list of objects as a table; empty without objects."""
    names = list(dict.fromkeys(name for entry in listed[:most] for name in entry))
    heads = "".join(f"<th>{html.escape(name.replace('_', ' '))}</th>" for name in names)
    rows = ["<tr>" + "".join(f"<td>{short_html(part(entry[name])) if name in entry else ''}</td>" for name in names) + "</tr>" for entry in listed[:most]]
    more = f"<tr><td colspan='{len(names)}'>… {len(listed) - most} more …</td></tr>" if len(listed) > most else ""
    return f"<table><tr>{heads}</tr>{''.join(rows)}{more}</table>" if rows else ""


def entries_html(result: Mapping[str, Any]) -> str:
    """Entries of a result in short; the name of the result if it is empty."""
    rows = "".join(
        f"<tr><td>{html.escape(str(name).replace('_', ' '))}</td><td>{short_html(result[name])}</td></tr>" for name in result if name != "alerts"
    )
    return f"<table>{rows}</table>" if rows else f"<p>{html.escape(type(result).__name__)}: empty</p>"


def short_html(value: Any) -> str:
    if isinstance(value, Quantity):
        return value.to_html()
    if isinstance(value, Result) and value.quantities:
        return ", ".join(f"<i>{html.escape(q.symbol)}</i> = {q.to_html()}" for q in value.quantities[:2])
    if isinstance(value, Mapping):
        return html.escape(", ".join(list(value)[:8]) + (" …" if len(value) > 8 else ""))
    if isinstance(value, tuple):
        is_long = len(value) > 4 or any(isinstance(entry, Mapping) for entry in value)
        return f"{len(value)} {'entry' if len(value) == 1 else 'entries'}" if is_long else ", ".join(map(short_html, value)) or "none"
    text = "–" if value is None else f"{value:.6g}" if isinstance(value, float) else str(value)
    return html.escape(text if len(text) <= 80 else text[:79] + "…")


def alerts_html(alerts: Sequence[Alert]) -> str:
    entries = "".join(f"<li>{html.escape(str(alert))}</li>" for alert in alerts)
    return f"<ul>{entries}</ul>" if entries else ""
