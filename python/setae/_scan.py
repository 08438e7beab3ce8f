# SPDX-License-Identifier: GPL-3.0-or-later
"""Measured heights from a channel of a file or an array, and their processing steps."""

from __future__ import annotations

import dataclasses
import functools
import html
import json
import pathlib
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Any, Union, cast

from . import _setae
from ._given import Given, is_path, shown
from ._names import former_method
from ._options import Length, Path, Size, Text, exact, named, path, require, size_text, text
from ._quantities import Alert, Json, Quantity, alerts_from, quantity_from
from ._results import Answer, alerts_html

if TYPE_CHECKING:
    from ._columns import Array
    from ._own_steps import OwnStep


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
        return ": ".join(filter(None, (self.step, ", ".join(f"{q.quantity.replace('_', ' ')} {q}" for q in self.numbers))))


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

    file: str | Given
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
    earlier: str = field(default="", repr=False)  #: history up to the last function of Python, as JSON

    @cached_property
    def _given(self) -> _setae.Heights | None:
        if self.source is None:
            return None
        array, size, periodic = self.source
        return _setae.Heights(array, size, periodic, str(self.file))

    @cached_property
    def _item(self) -> _setae.Item:
        item = _setae.Item(path(self.file), self._given)
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
    def size(self) -> tuple[Length, ...]:
        """Extent along x, for maps also along y [m]: points times pixel size. It is accepted as ``size=…`` of other scans."""
        return tuple(map(Length, self._heights.size))

    @property
    def pixel_size(self) -> tuple[Length, ...]:
        """Extent over number of points [m]."""
        return tuple(Length(extent / points) for extent, points in zip(self.size, self.heights.shape))

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
        earlier = json.loads(self.earlier)["alerts"] if self.earlier else []
        return alerts_from([*earlier, *json.loads(shown(self._heights.alerts))])

    @property
    def processing(self) -> Processing:
        """Records of the steps.

        >>> import numpy, setae
        >>> ramp = setae.scan(numpy.arange(64.0).reshape(8, 8), size="8 um x 8 um", unit="nm").level()
        >>> print(ramp.processing.steps[0].step, float(abs(ramp.heights).max()) < 1e-20)
        level_plane True
        """
        return Processing(with_earlier(self._processed[1], self.earlier))

    def process(self, step: str | OwnStep | Sequence[str | OwnStep], **parameters: Any) -> Scan:
        """Adds a step by its name in docs/reference/processing-steps.md, a function of Python, or several steps.

        A function gets the heights as an array in metres, and returns heights of the same shape. It also gets the scan if it has a parameter
        ``scan``. A function that returns a scan may change the size. It is called at once. :attr:`processing` records its name.

        >>> import numpy, setae
        >>> wave = setae.scan(numpy.arange(8.0), size="8 um", unit="nm")
        >>> wave.process(["level_mean", numpy.flip]).process("level_mean").processing.data["pipeline"]
        ['level_mean', 'flip()', 'level_mean']
        """
        if isinstance(step, Sequence) and not isinstance(step, str):
            if parameters:
                raise TypeError("several steps with common parameters; expected \"gaussian_filter cutoff=8um\" or functools.partial(function, …)")
            return functools.reduce(Scan.process, step, self)
        if not isinstance(step, str):
            from ._own_steps import with_own_step

            return with_own_step(self, step, parameters)
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

    def assign_metadata(
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

    stated = former_method("stated", assign_metadata)

    def plot(self, ax: Any = None, **style: Any) -> Any:
        """Plots the heights on axes of matplotlib, a map with y upwards as the program draws it; ``style``: keywords of matplotlib."""
        from ._plot import plot_scan

        return plot_scan(self, ax, **style)

    def save(self, file: Path) -> None:
        """Writes the heights after all steps. The ending gives the format: .x3p, .sdf, .gwy, .nc, .npy, .txt or .csv."""
        _setae.write_heights(self._heights, path(file))

    def to_xarray(self) -> Any:
        """As a DataArray of xarray with coordinates in metres, which :func:`scan` takes with its metadata.

        The attribute "period" of the coordinates of a periodic map is the extent at which the map repeats itself.
        """
        import numpy
        import xarray

        stated = {"instrument": self.instrument, "tip_radius": self.tip_radius, "resolution": self.resolution, "trend": self.trend}
        attributes = {"units": "m", "unit": "m", **{name: value for name, value in stated.items() if value}}
        if self.positions is not None:
            positions = ("x", self.positions, {"units": "m"})
            return xarray.DataArray(self.heights, dims="x", coords={"x": positions}, name="heights", attrs=attributes)
        names = ("x", "y")[: self.heights.ndim]
        coordinates = {}
        for name, points, step, extent in zip(names, self.heights.shape, self.pixel_size, self.size):
            about = {"units": "m", **({"period": float(extent)} if self.periodic else {})}
            coordinates[name] = (name, numpy.arange(points) * float(step), about)
        return xarray.DataArray(self.heights, dims=names, coords=coordinates, name="heights", attrs=attributes)

    def to_surface_topography(self) -> Any:
        """As a topography of SurfaceTopography in metres, with radius of the tip and resolution."""
        import SurfaceTopography

        from ._arrays import info_of

        about = {"unit": "m", "info": info_of(self.tip_radius, self.resolution)}
        if self.positions is not None:
            return SurfaceTopography.NonuniformLineScan(self.positions, self.heights, **about)
        if self.heights.ndim == 1:
            return SurfaceTopography.UniformLineScan(self.heights, float(self.size[0]), periodic=self.periodic, **about)
        return SurfaceTopography.Topography(self.heights, tuple(map(float, self.size)), periodic=self.periodic, **about)

    def _repr_html_(self) -> str:
        shape = " × ".join(map(str, self.heights.shape))
        extent = " × ".join(_setae.format_uncertain(length, float("nan"), "m") for length in self.size)
        steps = self.processing._repr_html_() if self.steps or self.pipeline or self.earlier else ""
        return f"<b>{html.escape(self.name or str(self.file))}</b>: {shape} points, {extent}{steps}"


def read(
    file: Path,
    *,
    channel: int | str | None = None,
    size: Size | None = None,
    unit: str | None = None,
    layout: str | None = None,
    keep_values: bool = False,
    instrument: str | None = None,
    tip_radius: Text | None = None,
    resolution: Text | None = None,
    trend: str | None = None,
) -> Scan:
    """A channel of a file by its number, counted from 0, or its name; without ``channel`` the preferred channel of heights.

    Values that mark missing heights, such as −9999, are undefined, with a warning in ``Scan.alerts``, unless ``keep_values`` is given.

    Parameters
    ----------
    file : str or path
        path of a file, of any format in `setae.formats()`
    channel : int or str, optional
        channel by its number, counted from 0, or by its name; default: the preferred channel of heights
    size : str or Quantity or tuple, optional
        extent of the heights, where the file does not state it, such as '5 um x 5 um'
    unit : str, optional
        unit of the heights, where the file does not state it, such as 'nm'
    layout : str, optional
        layout of a text file: a narrow map, points x y z, or the table of a spectrum; one of matrix, columns, spectrum
    keep_values : bool, default False
        heights are taken as they are: no value counts as a mark of missing data
    instrument : str, optional
        kind of the instrument; default: that of the file; one of stylus, afm, tem, optical
    tip_radius : str or Quantity, optional
        radius of the tip, with its standard error, such as '10 ± 2 nm'; default: that of the file
    resolution : str or Quantity, optional
        shortest wavelength that the instrument resolves, such as '500 nm'; default: that of the file
    trend : str, optional
        trend that is removed before the analysis; default: none after steps that level, else by instrument; one of none, mean, tilt,
        parabola

    Returns
    -------
    Scan
        a map, a line or a traced curve; heights are read at the first use

    Raises
    ------
    FileError
        for a path that cannot be read
    FormatError
        for content of an unknown format, or damaged content

    Examples
    --------
    >>> import setae
    >>> scan = setae.read("map_bump.csv", size="15 nm x 15 nm", unit="nm", layout="matrix", instrument="afm", tip_radius="10 ± 2 nm")
    >>> scan.level().despike().heights.shape
    (15, 15)
    """
    require("True or False", keep_values=keep_values)
    scan = Scan(
        path(file),
        channel,
        instrument=text(instrument),
        tip_radius=text(tip_radius, "tip_radius"),
        resolution=text(exact(resolution), "resolution"),
        trend=text(trend),
        stated_size=size_text(size),
        stated_unit=text(unit),
        layout=text(layout),
        keep_values=keep_values,
    )
    _setae.channels(scan._item, False)
    return scan


def channels(
    file: Path,
    *,
    size: Size | None = None,
    unit: str | None = None,
    layout: str | None = None,
    keep_values: bool = False,
    instrument: str | None = None,
    tip_radius: Text | None = None,
    resolution: Text | None = None,
    trend: str | None = None,
) -> tuple[Scan, ...]:
    """All channels of heights of a file, or measurements of a container, with metadata as for :func:`read`.

    Parameters
    ----------
    file : str or path
        path of a file or a container
    size : str or Quantity or tuple, optional
        extent of the heights, where the file does not state it, such as '5 um x 5 um'
    unit : str, optional
        unit of the heights, where the file does not state it, such as 'nm'
    layout : str, optional
        layout of a text file: a narrow map, points x y z, or the table of a spectrum; one of matrix, columns, spectrum
    keep_values : bool, default False
        heights are taken as they are: no value counts as a mark of missing data
    instrument : str, optional
        kind of the instrument; default: that of the file; one of stylus, afm, tem, optical
    tip_radius : str or Quantity, optional
        radius of the tip, with its standard error, such as '10 ± 2 nm'; default: that of the file
    resolution : str or Quantity, optional
        shortest wavelength that the instrument resolves, such as '500 nm'; default: that of the file
    trend : str, optional
        trend that is removed before the analysis; default: none after steps that level, else by instrument; one of none, mean, tilt,
        parabola

    Returns
    -------
    tuple of Scan
        one scan per channel or measurement

    Raises
    ------
    FileError
        for a path that cannot be read
    FormatError
        for content of an unknown format, or damaged content

    Examples
    --------
    >>> import setae
    >>> [scan.name for scan in setae.channels("map_two_channels.txt")]
    ['Height (trace)', 'Height (retrace)']
    """
    first = read(file, size=size, unit=unit, layout=layout, keep_values=keep_values, instrument=instrument, tip_radius=tip_radius,
                 resolution=resolution, trend=trend)
    return tuple(dataclasses.replace(first, channel=index) for index in _setae.channels(first._item, True))


def info(*paths: Path, heights: bool | None = None, size: Size | None = None, unit: str | None = None, layout: str | None = None,
         channel: int | str | None = None, keep_values: bool = False) -> Info:
    """Content of files or folders.

    Parameters
    ----------
    *paths : str or path
        files or folders
    heights : bool, optional
        heights are read (True), not read (False), or read from files up to 64 MB (None)
    size : str or Quantity or tuple, optional
        extent of the heights, where the file does not state it, such as '5 um x 5 um'
    unit : str, optional
        unit of the heights, where the file does not state it, such as 'nm'
    layout : str, optional
        layout of a text file: a narrow map, points x y z, or the table of a spectrum; one of matrix, columns, spectrum
    channel : int or str, optional
        channel by its number, counted from 0, or by its name; default: the preferred channel of heights
    keep_values : bool, default False
        heights are taken as they are: no value counts as a mark of missing data

    Returns
    -------
    Info
        channels and files with their metadata

    Raises
    ------
    FileError
        for a path that cannot be read
    FormatError
        for content of an unknown format, or damaged content

    Examples
    --------
    >>> import setae
    >>> setae.info("map_two_channels.txt", "line.csv")
    Info(2 files, 3 channels)
    """
    require("True or False", heights=heights, keep_values=keep_values)
    item = _setae.Item("")
    item.set_file(size_text(size), text(unit), text(layout), named(channel), keep_values)
    return Info(_setae.contents([path(entry) for entry in paths], item, heights))


def lengths(size: Size) -> list[float]:
    """Lengths in metres.

    Parameters
    ----------
    size : str or Quantity or tuple
        one length, or extents separated by x, such as '2 um x 1 mm'

    Returns
    -------
    list of float
        lengths in metres

    Raises
    ------
    InvalidArgument
        for a value outside its domain, with another dimension or without its unit

    Examples
    --------
    >>> lengths("2 um x 1 m")
    [2e-06, 1.0]
    """
    parts = size if isinstance(size, (tuple, list)) else (size,)
    return [length for part in parts for length in _setae.lengths(size_text(part))]


def scan(heights: Any, size: Size | None = None, unit: str | None = None, *, x: Any = None, periodic: bool = False,
         name: str | None = None, instrument: str | None = None, tip_radius: Text | None = None, resolution: Text | None = None,
         trend: str | None = None) -> Scan:
    """Heights from arrays, tables and objects of other packages.

    An array of float64 in metres that is C-contiguous is not copied: ``scan(array, …).heights is array``. Other arrays are converted. Heights
    at positions ``x`` are a line: on a grid for equal steps, otherwise a traced curve, as in a file with two columns.

    Parameters
    ----------
    heights : object
        array with the first index x, array of pint, DataArray of xarray, topography of SurfaceTopography, table of positions and
        heights with units, or a result of setae: a scan, a simulated surface, a contour
    size : str or Quantity or tuple, optional
        extent of an array, such as '5 um x 5 um' or `other.size`; needed for arrays without x
    unit : str, optional
        unit of an array, such as 'nm'; with x also 'mm, um' of positions and heights
    x : object, optional
        positions of the heights along a line
    periodic : bool, default False
        the heights repeat themselves beyond their edges
    name : str, optional
        name in results and messages; default: 'array'
    instrument : str, optional
        kind of the instrument; default: that of the file; one of stylus, afm, tem, optical
    tip_radius : str or Quantity, optional
        radius of the tip, with its standard error, such as '10 ± 2 nm'; default: that of the file
    resolution : str or Quantity, optional
        shortest wavelength that the instrument resolves, such as '500 nm'; default: that of the file
    trend : str, optional
        trend that is removed before the analysis; default: none after steps that level, else by instrument; one of none, mean, tilt,
        parabola

    Returns
    -------
    Scan
        heights with their size, for every function of measurements

    Raises
    ------
    InvalidArgument
        for a value outside its domain, with another dimension or without its unit
    TypeError
        for a value of another kind

    Examples
    --------
    >>> import numpy
    >>> wave = scan(3e-9 * numpy.cos(2 * numpy.pi * 8 * numpy.arange(512) / 512), size="2 um", unit="m")
    >>> wave.size, wave.heights.shape
    ((2e-06,), (512,))
    >>> scan([0.0, 2.0, 1.0], x=[0.0, 1.0, 4.0], unit="um, nm").positions
    array([0.e+00, 1.e-06, 4.e-06])
    """
    require("True or False", periodic=periodic)
    require("a text", name=name)
    stated = {"instrument": text(instrument), "tip_radius": text(tip_radius, "tip_radius"),
              "resolution": text(exact(resolution), "resolution"), "trend": text(trend)}
    given = {key: value for key, value in stated.items() if value}
    own = own_scan(heights)
    if own is not None:
        made = dataclasses.replace(own, **cast(Any, given)) if given else own
    else:
        from ._arrays import in_memory

        found = in_memory(heights, size, unit, x, periodic, name or "array")
        about: dict[str, Any] = {**found.stated, **given}
        if found.table is None:
            made = Scan(name or "array", source=found.grid, **about)
        else:
            made = Scan(found.table, stated_size=size_text(size), stated_unit=found.unit, keep_values=True, **about)
    made._item  # noqa: B018  raises an error for wrong arguments
    return made


def own_scan(value: Any) -> Scan | None:
    """The scan of a result of setae: of a scan, a simulated surface, or the longest profile of a contour; None for other values."""
    if isinstance(value, Scan):
        return value
    if isinstance(value, Answer) and isinstance(getattr(value, "scan", None), Scan):
        return cast("Scan", value.scan)
    profiles = getattr(value, "profiles", ()) if isinstance(value, Answer) else ()
    return Scan(Given("profile", profiles[0].encode())) if profiles else None


def scan_of(heights: _setae.Heights, name: str) -> Scan:
    """A scan of heights from setae, without a copy."""
    return Scan(name, source=(heights.array, heights.size, heights.periodic))


def with_earlier(records: str, earlier: str) -> str:
    """JSON of processing with the steps of an earlier history before its own."""
    if not earlier:
        return records
    data, before = json.loads(records), json.loads(earlier)
    data["pipeline"] = before["pipeline"] + data["pipeline"]
    data["files"][0]["steps"] = before["steps"] + data["files"][0]["steps"]
    return json.dumps(data, indent=2, ensure_ascii=False) + "\n"


#: Measurements: scans, files, arrays with a size.
Measured = Union[Scan, Path, Any]


class Items(list[_setae.Item]):
    """Measurements for the library. Their content in memory has files as long as the list."""

    kept: list[Scan]


def items(measurements: Measured, shared: dict[str, Any]) -> Items:
    """Measurements of one surface. Options of all measurements apply where a measurement has none of its own."""
    listed: list[Any] = [measurements] if is_one(measurements) else list(cast(Any, measurements))
    found = Items()
    found.kept = [measurement(entry, number_of, shared) for number_of, entry in enumerate(listed)]
    for place, made in enumerate(found.kept):
        own: dict[str, Any] = {key: value for key, value in shared.items() if value and not getattr(made, key)}
        found.kept[place] = dataclasses.replace(made, **own) if own else made
        found.append(found.kept[place]._item)
    return found


def measurement(entry: Measured, number_of: int, shared: dict[str, Any]) -> Scan:
    """One measurement: a scan, a file, or content in memory, which may be the table of a spectrum."""
    if isinstance(entry, Scan):
        return entry
    from ._tables import is_table, table_of

    if is_path(entry):
        file = entry if isinstance(entry, Given) else path(cast(Any, entry))
        return Scan(file, stated_size=shared.get("stated_size", ""), stated_unit=shared.get("stated_unit", ""))
    has_heights = "heights" in getattr(entry, "data_vars", ())
    if is_table(entry) and not has_heights:
        table = table_of(entry)
        units = dict(zip(table.columns, units_of_columns(shared.get("stated_unit", ""))))
        return Scan(Given("table", table_of(table, {**units, **table.units}).text()), keep_values=True)
    return scan(entry, name=f"array {number_of}")


def units_of_columns(unit: str) -> list[str]:
    """Units of two columns, such as those of a spectrum.

    >>> units_of_columns("frequency 1/um, one-sided nm3"), units_of_columns("nm")
    (['1/um', 'nm3'], [])
    """
    return [part.split()[-1] for part in unit.split(",") if part.strip()] if "," in unit else []


def is_one(value: Any) -> bool:
    """True for a single measurement, False for a list or a container of measurements."""
    if isinstance(value, (Scan, Answer)) or is_path(value):
        return True
    if isinstance(value, (list, tuple)):
        return False
    from ._tables import is_table

    is_sequence = hasattr(value, "__iter__") or (hasattr(value, "__len__") and hasattr(value, "__getitem__"))
    return not is_sequence or is_array(value) or is_table(value)


def is_array(value: Any) -> bool:
    """True for an array of heights, False for a list of measurements."""
    return hasattr(value, "physical_sizes") or hasattr(value, "__array__") or hasattr(value, "dims")
