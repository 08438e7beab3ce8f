# SPDX-License-Identifier: GPL-3.0-or-later
"""Answers that are columns of numbers."""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from ._quantities import Alert, Json, alerts_from

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False, repr=False)
class Columns:
    """Columns of numbers by name, each with its unit, on setae's memory: they cannot be written to."""

    columns: dict[str, Array]
    units: dict[str, str]
    text: str = field(repr=False)

    def json(self) -> str:
        """The bytes that the verb prints with ``--json``."""
        return self.text

    @property
    def data(self) -> Json:
        """The same as dictionaries and lists, made anew each time."""
        return json.loads(self.text)

    @property
    def n(self) -> int:
        """Measurements it rests on."""
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
