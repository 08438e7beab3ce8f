# SPDX-License-Identifier: GPL-3.0-or-later
"""Results with columns of numbers."""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, cast

from ._given import shown
from ._quantities import Alert, Json, alerts_from

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]


class Named(dict[str, "Array"]):
    """Columns by name, with their units in ``units``."""

    def __init__(self, columns: Mapping[str, Array], units: Mapping[str, str]) -> None:
        super().__init__(columns)
        self.units = dict(units)


def edge_of(columns: Mapping[str, Array]) -> Named:
    """Places along the edge of a contact: columns "time", "frame", "radius_1" … by name."""
    known = {"time": "s", "frame": "1", "force": "N", "displacement": "m"}
    return Named(columns, {name: known.get(name, "m") for name in columns})


@dataclass(frozen=True, eq=False, repr=False)
class Columns:
    """Columns of numbers by name, each with its unit. The arrays are memory of setae and read-only."""

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
        return {**self.__dict__, "text": self.json()}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state)

    @property
    def data(self) -> Json:
        """The JSON as dictionaries and lists; every call makes new ones."""
        return json.loads(self.json())

    @property
    def n(self) -> int:
        """Number of measurements that the result depends on."""
        return len(self.data["measurements"])

    @property
    def alerts(self) -> tuple[Alert, ...]:
        return alerts_from(self.data["alerts"])

    def __getitem__(self, name: str) -> Any:
        return self.columns[name]

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
