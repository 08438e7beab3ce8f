# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables in memory: columns with units, from pandas, xarray, pint, dictionaries, structured arrays or results of setae."""

from __future__ import annotations

import csv
import io
import math
import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from ._columns import Columns
from ._errors import InvalidArgument
from ._given import TableLike
from ._results import Answer

#: Units in SI of the columns that setae reads; arrays of pint are converted to the unit of their dimension.
SI_UNITS = ("m", "N", "s", "1/m", "m3", "m4", "Pa", "J/m2", "J", "N/m", "m/s", "V", "A", "K", "rad", "1")

_UNIT_IN_NAME = re.compile(r"[\[(][^\[\]()]*[\])]\s*$")


@dataclass(frozen=True, eq=False)
class Table:
    """Columns by name, with the units that their names do not contain, and entries of a header."""

    columns: dict[str, Any]
    units: dict[str, str] = field(default_factory=dict)
    metadata: dict[str, str] = field(default_factory=dict)

    def header(self, name: str) -> str:
        """A name with its unit as readers of tables expect it."""
        unit = self.units.get(name, "")
        return f"{name} [{unit}]" if unit and not _UNIT_IN_NAME.search(name) else name

    def text(self) -> bytes:
        """The table as text. Tabs and exponents leave no doubt about separators; 17 digits keep every number.

        >>> Table({"force": [0.1, float("nan")], "spot": ["a", "b"]}, {"force": "mN"}).text()
        b'force [mN]\\tspot\\n1.0000000000000001e-01\\ta\\n\\tb\\n'
        """
        lengths = {len(values) for values in self.columns.values()}
        if len(lengths) != 1:
            raise InvalidArgument(f"columns of {', '.join(map(str, sorted(lengths))) or 'no'} rows; expected columns of equal length")
        written = io.StringIO()
        rows = csv.writer(written, delimiter="\t", lineterminator="\n")
        rows.writerow([self.header(name) for name in self.columns])
        rows.writerows(zip(*(cells(values) for values in self.columns.values())))
        return written.getvalue().encode()

    def text_with_metadata(self) -> bytes:
        """The table below lines ``# key: value`` of its metadata."""
        return "".join(f"# {key}: {value}\n" for key, value in self.metadata.items()).encode() + self.text()


def cells(values: Any) -> list[str]:
    """Numbers with all their digits, missing values as empty cells, other values as texts."""
    array = np.asarray(values)
    if array.ndim != 1:
        raise InvalidArgument(f"a column of {array.ndim} dimensions; expected one dimension")
    return [cell(value) for value in array.tolist()]


def cell(value: Any) -> str:
    if isinstance(value, float):
        return "" if math.isnan(value) else format(value, ".16e")
    missing = value is None or type(value).__name__ in ("NAType", "NaTType")  # of pandas
    return "" if missing else str(value)


def without_unit(values: Any) -> tuple[Any, str]:
    """An array of pint, or of another package with units, as numbers and their SI unit; other arrays as they are.

    >>> without_unit([1, 2])
    ([1, 2], '')
    """
    if not (hasattr(values, "magnitude") and hasattr(values, "is_compatible_with")):
        return values, ""
    for unit in SI_UNITS:
        spelled = "dimensionless" if unit == "1" else re.sub(r"(?<=m)(\d)", r"**\1", unit)
        if values.is_compatible_with(spelled):
            return values.to(spelled).magnitude, unit
    raise InvalidArgument(f"an array in {values.units}; expected a unit of the dimension of one of {', '.join(SI_UNITS)}")


def own_unit(column: Any) -> str:
    """The unit in the attributes of a column, or of its type (pint-pandas); empty without one."""
    attributes = getattr(column, "attrs", {})
    found = attributes.get("units", attributes.get("unit", ""))
    return found if isinstance(found, str) else ""


def metadata_of(attributes: Mapping[Any, Any]) -> dict[str, str]:
    """Attributes that a header of a table can contain: one line of text under a key in lower case."""
    return {
        key: value
        for key, value in attributes.items()
        if isinstance(key, str) and re.fullmatch("[a-z][a-z0-9_]*", key) and isinstance(value, str) and value.isprintable()
    }


def of_frame(frame: Any) -> Table:
    """A DataFrame; a named index is its first column, units are in ``attrs["units"]``."""
    if any(name is not None for name in frame.index.names):
        attributes, frame = frame.attrs, frame.reset_index()
        frame.attrs.update(attributes)
    units = dict(frame.attrs.get("units", {}))
    columns = {}
    for name in frame.columns:
        column = frame[name]
        typed = getattr(column.dtype, "units", None)  # of pint-pandas
        if typed is not None:
            column, units[str(name)] = without_unit(column.array.quantity)
        columns[str(name)] = np.asarray(column, dtype=object if getattr(column.dtype, "kind", "") in "iu" else None)
    return Table(columns, {str(name): str(unit) for name, unit in units.items()}, metadata_of(frame.attrs))


def of_dataset(dataset: Any) -> Table:
    """A Dataset with one dimension; coordinates come first."""
    if len(dataset.dims) != 1:
        raise InvalidArgument(f"a dataset of {len(dataset.dims)} dimensions; expected one dimension, the rows of a table")
    columns = {**dict(dataset.coords), **dict(dataset.data_vars)}
    numbers = {str(name): without_unit(column.data) for name, column in columns.items()}
    units = {str(name): own_unit(column) or numbers[str(name)][1] for name, column in columns.items()}
    return Table({name: values for name, (values, _) in numbers.items()}, units, metadata_of(dataset.attrs))


def of_mapping(columns: Mapping[Any, Any]) -> Table:
    numbers = {str(name): without_unit(column) for name, column in columns.items()}
    units = {str(name): numbers[str(name)][1] or own_unit(column) for name, column in columns.items()}
    return Table({name: values for name, (values, _) in numbers.items()}, {**units, **getattr(columns, "units", {})})


def is_table(value: Any) -> bool:
    """True for a table in memory; False for paths, scans, arrays and answers."""
    if isinstance(value, (Table, Columns)):
        return True
    if isinstance(value, Mapping):
        return not isinstance(value, Answer)
    is_structured = isinstance(value, np.ndarray) and value.dtype.names is not None
    return is_structured or hasattr(value, "data_vars") or (hasattr(value, "columns") and hasattr(value, "attrs"))


def table_of(value: TableLike, units: Mapping[str, str] | None = None) -> Table:
    """The columns of a table in memory. ``units``: units of columns whose names and attributes do not state them."""
    if isinstance(value, Table):
        table = value
    elif isinstance(value, Columns):
        table = Table(dict(value.columns), dict(value.units))
    elif hasattr(value, "data_vars"):
        table = of_dataset(value)
    elif isinstance(value, Mapping):
        table = of_mapping(value)
    elif isinstance(value, np.ndarray):
        table = Table({name: value[name] for name in value.dtype.names or ()})
    else:
        table = of_frame(value)
    for name in units or {}:
        if name not in table.columns:
            raise InvalidArgument(f"units: '{name}' is no column; expected one of {', '.join(table.columns)}")
    stated = {name: unit for name, unit in table.units.items() if unit}
    return Table(table.columns, {**stated, **(units or {})}, table.metadata)
