# SPDX-License-Identifier: GPL-3.0-or-later
"""Results with columns of numbers."""

from __future__ import annotations

import html
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, cast

from ._given import shown
from ._quantities import Quantity
from ._results import Result, alerts_html, quantities_html

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]


class Named(dict[str, "Array"]):
    """Columns by name, with their units in ``units``."""

    def __init__(self, columns: Mapping[str, Array], units: Mapping[str, str]) -> None:
        super().__init__(columns)
        self.units = dict(units)

    def _ipython_key_completions_(self) -> list[str]:
        return list(self)


def edge_of(columns: Mapping[str, Array]) -> Named:
    """Places along the edge of a contact: columns "time", "frame", "radius_1" … by name."""
    known = {"time": "s", "frame": "1", "force": "N", "displacement": "m"}
    return Named(columns, {name: known.get(name, "m") for name in columns})


@dataclass(frozen=True, eq=False, repr=False)
class Columns(Result):
    """Columns of numbers by name, each with its unit, and the other entries of the JSON. The arrays are memory of setae and read-only."""

    columns: dict[str, Array]
    units: dict[str, str]
    text: str | Callable[[], str] = field(repr=False)  #: text of ``json()``, or a function that makes the text at the first call

    def __post_init__(self) -> None:
        if isinstance(self.text, str):
            object.__setattr__(self, "text", shown(self.text))

    def json(self) -> str:
        """The bytes that the command prints with ``--json``."""
        if not isinstance(self.text, str):
            self.__dict__["text"] = shown(self.text())
        return cast("str", self.text)

    def __getstate__(self) -> dict[str, Any]:
        kept = {name: value for name, value in self.__dict__.items() if name in self.__dataclass_fields__}
        return {**kept, "text": self.json()}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state)

    @property
    def n(self) -> int:
        """Number of measurements that the result depends on."""
        return len(self._data["measurements"])

    def __getitem__(self, name: str) -> Any:
        return self.columns[name] if name in self.columns else super().__getitem__(name)

    def __iter__(self) -> Iterator[str]:
        """Names of the columns, then of the other entries."""
        return iter(dict.fromkeys([*self.columns, *self._data]))

    def to_pandas(self) -> Any:
        """As a DataFrame of pandas; units are in ``attrs``."""
        import pandas

        frame = pandas.DataFrame(dict(self.columns))
        frame.attrs["units"] = dict(self.units)
        return frame

    def to_xarray(self) -> Any:
        """As a Dataset of xarray along the first column."""
        import xarray

        along, *others = self.columns
        variables = {name: (along, self.columns[name], {"units": self.units[name]}) for name in others}
        return xarray.Dataset(variables, coords={along: (along, self.columns[along], {"units": self.units[along]})})

    def _repr_html_(self) -> str:
        return f"<b>{html.escape(repr(self))}</b>{quantities_html(self.quantities)}{self._table_html()}{alerts_html(self.alerts)}"

    def _table_html(self, ends: int = 3) -> str:
        """First and last rows."""
        n = len(next(iter(self.columns.values()), ()))
        shown = range(n) if n <= 2 * ends else [*range(ends), *range(n - ends, n)]
        heads = "".join(f"<th>{html.escape(f'{name} [{self.units[name]}]')}</th>" for name in self.columns)
        rows = ["<tr>" + "".join(f"<td>{values[i]:.5g}</td>" for values in self.columns.values()) + "</tr>" for i in shown]
        if n > 2 * ends:
            rows.insert(ends, f"<tr><td colspan='{len(self.columns)}'>… {n - 2 * ends} rows …</td></tr>")
        return f"<table><tr>{heads}</tr>{''.join(rows)}</table>" if rows else ""
