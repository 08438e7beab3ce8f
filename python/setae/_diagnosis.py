# SPDX-License-Identifier: GPL-3.0-or-later
"""Problems of measurements."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from . import _setae
from ._options import Size, Text, size_text, text
from ._quantities import Alert, Quantity, alerts_from, quantity_from
from ._results import Answer, alerts_html, unknown
from ._scan import Measured, items


@dataclass(frozen=True)
class Finding:
    """A problem of a measurement, with the size of its effects."""

    alert: Alert
    effects: tuple[Quantity, ...]

    def __str__(self) -> str:
        return str(self.alert)


class Diagnosis(Answer):
    """Problems of measurements by their code, as printed by ``setae check --json``; empty if there are none."""

    def __getitem__(self, code: str) -> tuple[Finding, ...]:
        found = tuple(finding for finding in self.findings if finding.alert.code == code)
        if not found:
            raise KeyError(unknown(code, list(self)))
        return found

    def __iter__(self) -> Iterator[str]:
        return iter(dict.fromkeys(entry["code"] for entry in self._data))

    @property
    def quantities(self) -> tuple[Quantity, ...]:
        """Effects of all problems."""
        return tuple(effect for finding in self.findings for effect in finding.effects)

    def to_dict(self) -> dict[str, Any]:
        """The JSON of the problems by their code."""
        return {code: [entry for entry in self.data if entry["code"] == code] for code in self}

    def to_pandas(self) -> Any:
        """As a DataFrame of pandas: one row per problem."""
        import pandas

        return pandas.DataFrame([{name: entry[name] for name in ("code", "subject", "message", "action")} for entry in self._data])

    @cached_property
    def findings(self) -> tuple[Finding, ...]:
        return tuple(
            Finding(alert, tuple(map(quantity_from, entry["effects"]))) for alert, entry in zip(self.alerts, self._data)
        )

    @property
    def alerts(self) -> tuple[Alert, ...]:
        return alerts_from(self._data)

    def __repr__(self) -> str:
        return "\n".join(map(str, self.findings)) or "nothing found"

    def _repr_html_(self) -> str:
        return alerts_html(self.alerts) or "<p>nothing found</p>"


def check(measurements: Measured, *, tip_radius: Text | None = None, size: Size | None = None, unit: str | None = None, keep_values: bool = False,
          skip_failed: bool = False) -> Diagnosis:
    """Problems of single measurements and differences between them, with the size of the effect and a remedy.

    Tests look for spikes, scars, noise, quantised heights, offsets of scan lines, curves that turn back … (docs/reference/diagnostics.md).

    Parameters
    ----------
    measurements : scan, str, path, array, table or a list of them
        one measurement, or all measurements of one surface: scans, files, arrays with a size
    tip_radius : str or Quantity, optional
        radius of the tip, with its standard error, such as '10 ± 2 nm'; default: that of the file
    size : str or Quantity or tuple, optional
        extent of the heights, where the file does not state it, such as '5 um x 5 um'
    unit : str, optional
        unit of the heights, where the file does not state it, such as 'nm'
    keep_values : bool, default False
        heights are taken as they are: no value counts as a mark of missing data
    skip_failed : bool, default False
        measurements that cannot be analysed are left out with a warning

    Returns
    -------
    Diagnosis
        problems by their code; empty if there are none

    Raises
    ------
    FileError
        for a path that cannot be read
    FormatError
        for content of an unknown format, or damaged content
    InvalidArgument
        for a value outside its domain, with another dimension or without its unit

    Examples
    --------
    >>> import numpy, setae
    >>> heights = 1e-9 * numpy.random.default_rng(1).standard_normal((64, 64))
    >>> heights[3, 5] = 1e-6
    >>> "SPIKES" in [alert.code for alert in check(setae.scan(heights, size="1 um x 1 um", unit="m")).alerts]
    True
    """
    shared = {"stated_size": size_text(size), "stated_unit": text(unit), "keep_values": keep_values}
    return Diagnosis(_setae.diagnosis(items(measurements, shared), text(tip_radius, "tip_radius"), not skip_failed))
