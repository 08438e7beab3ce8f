# SPDX-License-Identifier: GPL-3.0-or-later
"""Measured heights from a channel of a file or an array, and their processing steps."""

from __future__ import annotations

import dataclasses
import html
import json
import pathlib
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Any, Union, cast

from . import _setae
from ._options import Path, Text, named, path, require, text
from ._quantities import Alert, Json, Quantity, alerts_from, quantity_from
from ._results import Answer, alerts_html

if TYPE_CHECKING:
    from ._columns import Array


def lengths(size: Text | tuple[Text, ...]) -> list[float]:
    """Lengths in metres.

    >>> lengths("2 um x 1 m")
    [2e-06, 1.0]
    """
    parts = size if isinstance(size, tuple) else (size,)
    return [length for part in parts for length in _setae.lengths(text(part, "size"))]


class Info(Answer):
    """Content of files, as printed by ``setae info --json``."""

    tables = ("channels",)

    @property
    def channels(self) -> tuple[Json, ...]:
        return tuple(self._data["channels"])

    @property
    def files(self) -> tuple[Json, ...]:
        return tuple(self._data["files"])

    def __repr__(self) -> str:
        return f"Info({len(self.files)} files, {len(self.channels)} channels)"


@dataclass(frozen=True)
class Step:
    """Record of one step of a pipeline."""

    step: str
    numbers: tuple[Quantity, ...]
    alerts: tuple[Alert, ...]

    def __str__(self) -> str:
        return self.step + ": " + ", ".join(f"{q.quantity.replace('_', ' ')} {q}" for q in self.numbers)


class Processing(Answer):
    """Records of the steps of a scan, as printed by ``setae level --json``."""

    @property
    def steps(self) -> tuple[Step, ...]:
        entries = self._data["files"][0]["steps"]
        return tuple(
            Step(entry["step"], tuple(map(quantity_from, entry["numbers"])), alerts_from(entry["alerts"])) for entry in entries
        )

    @property
    def alerts(self) -> tuple[Alert, ...]:
        return tuple(alert for step in self.steps for alert in step.alerts)

    @property
    def quantities(self) -> tuple[Quantity, ...]:
        """Numbers of all steps."""
        return tuple(number for step in self.steps for number in step.numbers)

    def __repr__(self) -> str:
        return "\n".join(map(str, self.steps)) or "no steps"

    def _repr_html_(self) -> str:
        steps = "".join(f"<li>{html.escape(str(step))}</li>" for step in self.steps)
        return (f"<ol>{steps}</ol>" if steps else "<p>no steps</p>") + alerts_html(self.alerts)


@dataclass(frozen=True, eq=False)
class Scan:
    """A map, a line or a traced curve, with the processing steps before its analysis.

    ``heights`` is an array of NumPy in metres, first index x, NaN where undefined. Heights are read at the first use.
    Every processing method returns a new scan with one more step.
    """

    file: str
    channel: int | str | None = None
    steps: tuple[str, ...] = ()
    pipeline: str = ""
    instrument: str = ""
    tip_radius: str = ""
    resolution: str = ""
    trend: str = ""
    stated_size: str = ""
    stated_unit: str = ""
    layout: str = ""
    keep_values: bool = False
    source: Any = field(default=None, repr=False)  #: the array, its size, and whether it is periodic; None for a file

    @cached_property
    def _given(self) -> _setae.Heights | None:
        if self.source is None:
            return None
        array, size, periodic = self.source
        return _setae.Heights(array, size, periodic, self.file)

    @cached_property
    def _item(self) -> _setae.Item:
        item = _setae.Item(self.file, self._given)
        item.set_file(self.stated_size, self.stated_unit, self.layout, named(self.channel), self.keep_values)
        item.set_processing(self.pipeline, list(self.steps))
        item.set_instrument(self.instrument, self.tip_radius, self.resolution, self.trend)
        return item

    @cached_property
    def _processed(self) -> tuple[_setae.Heights, str]:
        processed = _setae.process(self._item)
        return processed.heights, processed.json

    @cached_property
    def _heights(self) -> _setae.Heights:
        if self.steps or self.pipeline:
            return self._processed[0]
        return self._given or _setae.read(self._item)

    def __getstate__(self) -> dict[str, Any]:
        return {entry.name: getattr(self, entry.name) for entry in dataclasses.fields(self)}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state)

    @property
    def heights(self) -> Array:
        """Heights [m] after all steps: a read-only view of memory of setae, or the given array itself."""
        return cast("Array", self._heights.array)

    @property
    def positions(self) -> Array | None:
        """x of every point of a traced curve [m]; None for heights on a grid."""
        return cast("Array | None", self._heights.positions)

    @property
    def size(self) -> tuple[float, ...]:
        """Extent along x, for maps also along y [m]: points times pixel size."""
        return tuple(self._heights.size)

    @property
    def pixel_size(self) -> tuple[float, ...]:
        """Extent over number of points [m]."""
        return tuple(extent / points for extent, points in zip(self.size, self.heights.shape))

    @property
    def periodic(self) -> bool:
        return self._heights.periodic

    @property
    def name(self) -> str:
        return self._heights.name

    @property
    def unit(self) -> str:
        """The unit of the file; ``heights`` are in metres for every unit."""
        return self._heights.unit

    @property
    def attributes(self) -> dict[str, str]:
        """Further entries of the header of the file."""
        return self._heights.attributes

    @property
    def alerts(self) -> tuple[Alert, ...]:
        """Warnings about reading the heights: values taken as undefined, points averaged."""
        return alerts_from(json.loads(self._heights.alerts))

    @property
    def processing(self) -> Processing:
        """Records of the steps.

        >>> import numpy, setae
        >>> ramp = setae.scan(numpy.arange(64.0).reshape(8, 8), size="8 um x 8 um", unit="nm").level()
        >>> print(ramp.processing.steps[0].step, float(abs(ramp.heights).max()) < 1e-20)
        level_plane True
        """
        return Processing(self._processed[1])

    def process(self, step: str, **parameters: Text | float | bool) -> Scan:
        """Adds a step by its name in docs/reference/processing-steps.md: ``scan.process("gaussian_filter", cutoff="8 um")``."""
        line = step
        for name, value in parameters.items():
            word = str(value).lower() if isinstance(value, bool) else text(value)
            line += f' {name}="{word}"' if " " in word else f" {name}={word}"
        changed = dataclasses.replace(self, steps=(*self.steps, line))
        changed._item  # noqa: B018  raises an error for an unknown step
        return changed

    def level(self, by: str = "plane", **parameters: Text | float | bool) -> Scan:
        """Subtracts the trend ``by``: "mean", "plane", "polynomial", "facet" …"""
        return self.process(f"level_{by}", **parameters)

    def despike(self, **parameters: Text | float | bool) -> Scan:
        """Replaces spikes."""
        return self.process("despike", **parameters)

    def align_rows(self, **parameters: Text | float | bool) -> Scan:
        """Brings scan lines to one level."""
        return self.process("align_rows", **parameters)

    def fill(self, **parameters: Text | float | bool) -> Scan:
        """Fills undefined heights."""
        return self.process("fill_undefined", **parameters)

    def stated(
        self,
        *,
        instrument: str | None = None,
        tip_radius: Text | None = None,
        resolution: Text | None = None,
        trend: str | None = None,
    ) -> Scan:
        """The scan with metadata that its file does not contain: "stylus", "afm", "tem" or "optical"; radius of the tip with its ±."""
        given: dict[str, Any] = {
            name: text(value, name)
            for name, value in (("instrument", instrument), ("tip_radius", tip_radius), ("resolution", resolution), ("trend", trend))
            if value is not None
        }
        return dataclasses.replace(self, **given)

    def plot(self, ax: Any = None, **style: Any) -> Any:
        """Plots the heights on axes of matplotlib, a map with y upwards as the program draws it; ``style``: keywords of matplotlib."""
        from ._plot import plot_scan

        return plot_scan(self, ax, **style)

    def save(self, file: Path) -> None:
        """Writes the heights after all steps. The ending gives the format: .x3p, .sdf, .gwy, .nc, .npy, .txt or .csv."""
        _setae.write_heights(self._heights, path(file))

    def to_xarray(self) -> Any:
        """As a DataArray of xarray with coordinates in metres."""
        import numpy
        import xarray

        if self.positions is not None:
            return xarray.DataArray(self.heights, dims="x", coords={"x": self.positions}, name="heights", attrs={"unit": "m"})
        names = ("x", "y")[: self.heights.ndim]
        coordinates = {n: numpy.arange(points) * step for n, points, step in zip(names, self.heights.shape, self.pixel_size)}
        return xarray.DataArray(self.heights, dims=names, coords=coordinates, name="heights", attrs={"unit": "m"})

    def to_surface_topography(self) -> Any:
        """As a topography of SurfaceTopography, in metres."""
        import SurfaceTopography

        if self.positions is not None:
            return SurfaceTopography.NonuniformLineScan(self.positions, self.heights, unit="m")
        if self.heights.ndim == 1:
            return SurfaceTopography.UniformLineScan(self.heights, self.size[0], periodic=self.periodic, unit="m")
        return SurfaceTopography.Topography(self.heights, self.size, periodic=self.periodic, unit="m")

    def _repr_html_(self) -> str:
        shape = " × ".join(map(str, self.heights.shape))
        extent = " × ".join(_setae.format_uncertain(length, float("nan"), "m") for length in self.size)
        steps = self.processing._repr_html_() if self.steps or self.pipeline else ""
        return f"<b>{html.escape(self.name or self.file)}</b>: {shape} points, {extent}{steps}"


def read(
    file: Path,
    *,
    channel: int | str | None = None,
    size: Text | None = None,
    unit: str | None = None,
    layout: str | None = None,
    keep_values: bool = False,
    instrument: str | None = None,
    tip_radius: Text | None = None,
    resolution: Text | None = None,
    trend: str | None = None,
) -> Scan:
    """A channel of a file by its number, counted from 0, or its name; without ``channel`` the preferred channel of heights.

    size, unit, layout: metadata that the file does not contain, as ``--size``, ``--unit`` and ``--as`` of the program.
    keep_values: values that mark missing heights, such as −9999, stay heights. Otherwise they are undefined, with a warning in ``Scan.alerts``.

    :raises FileError: for a path that cannot be read
    :raises FormatError: for content of an unknown format, or damaged content
    """
    require("True or False", keep_values=keep_values)
    scan = Scan(
        path(file),
        channel,
        instrument=text(instrument),
        tip_radius=text(tip_radius, "tip_radius"),
        resolution=text(resolution, "resolution"),
        trend=text(trend),
        stated_size=text(size, "size"),
        stated_unit=text(unit),
        layout=text(layout),
        keep_values=keep_values,
    )
    _setae.channels(scan._item, False)
    return scan


def channels(file: Path, **stated: Any) -> tuple[Scan, ...]:
    """All channels of heights of a file, or measurements of a container; ``stated``: arguments of :func:`read`."""
    first = read(file, **stated)
    return tuple(dataclasses.replace(first, channel=index) for index in _setae.channels(first._item, True))


def info(*paths: Path, heights: bool | None = None, size: Text | None = None, unit: str | None = None, layout: str | None = None,
         channel: int | str | None = None, keep_values: bool = False) -> Info:
    """Content of files or folders. heights: read (True), not read (False), or read from files up to 64 MB (None)."""
    require("True or False", heights=heights, keep_values=keep_values)
    item = _setae.Item("")
    item.set_file(text(size, "size"), text(unit), text(layout), named(channel), keep_values)
    return Info(_setae.contents([path(entry) for entry in paths], item, heights))


def scan(heights: Any, size: Text | tuple[Text, ...] | None = None, unit: str | None = None, *, periodic: bool = False, name: str = "array",
         instrument: str | None = None, tip_radius: Text | None = None, resolution: Text | None = None,
         trend: str | None = None) -> Scan:
    """Heights from an array with size and unit, a DataArray of xarray with coordinates, or a topography of SurfaceTopography.

    An array of float64 in metres that is C-contiguous is not copied: ``scan(array, …).heights is array``. Other arrays are converted.

    >>> import numpy
    >>> wave = scan(3e-9 * numpy.cos(2 * numpy.pi * 8 * numpy.arange(512) / 512), size="2 um", unit="m")
    >>> wave.size, wave.heights.shape
    ((2e-06,), (512,))
    """
    from ._arrays import as_heights

    require("True or False", periodic=periodic)
    require("a text", name=name)
    array, extent, is_periodic = as_heights(heights, size, unit, periodic)
    made = Scan(name, instrument=text(instrument), tip_radius=text(tip_radius, "tip_radius"), resolution=text(resolution, "resolution"),
                trend=text(trend), source=(array, extent, is_periodic))
    made._item  # noqa: B018  raises an error for wrong arguments
    return made


def scan_of(heights: _setae.Heights, name: str) -> Scan:
    """A scan of heights from setae, without a copy."""
    return Scan(name, source=(heights.array, heights.size, heights.periodic))


#: Measurements: scans, files, arrays with a size.
Measured = Union[Scan, Path, Any]


def items(measurements: Measured, shared: dict[str, Any]) -> list[_setae.Item]:
    """Measurements of one surface. Options of all measurements apply where a measurement has none of its own."""
    single = isinstance(measurements, (Scan, str, pathlib.PurePath)) or not hasattr(measurements, "__iter__") or is_array(measurements)
    listed: list[Any] = [measurements] if single else list(cast(Any, measurements))
    found = []
    for number_of, entry in enumerate(listed):
        if isinstance(entry, Scan):
            made = entry
        elif isinstance(entry, (str, pathlib.PurePath)):
            made = Scan(path(entry), stated_size=shared.get("stated_size", ""), stated_unit=shared.get("stated_unit", ""))
        else:
            made = scan(entry, name=f"array {number_of}")
        own: dict[str, Any] = {key: value for key, value in shared.items() if value and not getattr(made, key)}
        found.append(dataclasses.replace(made, **own)._item if own else made._item)
    return found


def is_array(value: Any) -> bool:
    """True for an array of heights, False for a list of measurements."""
    return hasattr(value, "physical_sizes") or hasattr(value, "__array__") or hasattr(value, "dims")
