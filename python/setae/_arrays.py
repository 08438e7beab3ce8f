# SPDX-License-Identifier: GPL-3.0-or-later
"""Heights of arrays and of other packages as measurements: arrays of float64 in metres, or tables of positions and heights."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _setae
from ._errors import InvalidArgument
from ._given import Given, plain_name
from ._options import Size
from ._scan import lengths
from ._tables import Table, is_table, own_unit, table_of, without_unit

if TYPE_CHECKING:
    from numpy.typing import NDArray


@dataclass(frozen=True)
class InMemory:
    """Heights on a grid with their extents, or a table for the readers; and metadata of their origin."""

    grid: tuple[NDArray[np.float64], list[float], bool] | None = None  #: the array in metres, its extents in metres, whether it is periodic
    table: Given | None = None
    unit: str = ""  #: unit of a table that states none
    stated: dict[str, str] = field(default_factory=dict)  #: instrument, tip_radius …, as of a scan


def in_memory(heights: Any, size: Size | None, unit: str | None, x: Any, periodic: bool, name: str) -> InMemory:
    """The heights of an array, of a table, or of an object of another package."""
    if hasattr(heights, "physical_sizes") and callable(getattr(heights, "heights", None)):
        return of_topography(heights, name)
    if "heights" in getattr(heights, "data_vars", ()) and set(heights.heights.dims) <= set(heights.heights.coords):
        heights = heights.heights
    if is_table(heights):
        return InMemory(table=Given(plain_name(name), table_of(heights).text()), unit=unit or "")
    if hasattr(heights, "dims") and hasattr(heights, "coords"):
        return of_data_array(heights, size, unit, periodic, name)
    if x is not None:
        return of_points(x, heights, unit, name)
    if size is None:
        raise InvalidArgument('an array has no size; expected size="5 um x 5 um" of a map, size="1 mm" or positions x=… of a line')
    return InMemory((metres(heights, unit), lengths(size), periodic))


def metres(heights: Any, unit: str | None) -> NDArray[np.float64]:
    heights, own = without_unit(heights)
    unit = own or unit
    if not unit:
        raise InvalidArgument('an array has no unit; expected unit="m", "nm" …')
    if isinstance(heights, np.ma.MaskedArray):
        heights = np.ma.filled(heights.astype(np.float64), np.nan)
    array = np.asarray(heights)
    if array.dtype.kind not in "fiu":
        raise TypeError(f"heights of type {array.dtype}; expected real numbers")
    factor = _setae.length_factor(unit)
    array = np.asarray(array, dtype=np.float64, order="C")
    return array if factor == 1.0 else array * factor


def of_points(x: Any, heights: Any, unit: str | None, name: str) -> InMemory:
    """Heights at positions along a line. ``unit``: of both, or "mm, um" of positions and heights."""
    (x, own_x), (heights, own_heights) = without_unit(x), without_unit(heights)
    parts = [part.strip() for part in unit.split(",")] if unit else [""]
    unit_of_x, unit_of_heights = own_x or own_unit(x) or parts[0], own_heights or own_unit(heights) or parts[-1]
    for what, found in (("positions x have", unit_of_x), ("an array has", unit_of_heights)):
        if not found:
            raise InvalidArgument(f'{what} no unit; expected unit="um", or unit="mm, um" for positions and heights')
    points = Table({"x": numbers(x), "height": numbers(heights)}, {"x": unit_of_x, "height": unit_of_heights})
    return InMemory(table=Given(plain_name(name), points.text()))


def numbers(values: Any) -> NDArray[np.float64]:
    array = np.ma.filled(np.ma.asarray(values).astype(np.float64), np.nan)
    return np.asarray(array, dtype=np.float64)


def steps_of(values: NDArray[np.float64]) -> float | None:
    """The step of positions that increase by equal steps; None for others."""
    steps = np.diff(values)
    equal = len(steps) > 0 and np.allclose(steps, steps[0], rtol=1e-6, atol=0.0) and steps[0] > 0.0
    return float((values[-1] - values[0]) / (len(values) - 1)) if equal else None


def extent_of(coordinate: Any) -> float:
    """Number of points times their step, for coordinates with equal steps."""
    values = np.asarray(coordinate.values, dtype=np.float64)
    step = steps_of(values)
    if step is None:
        raise InvalidArgument(f"coordinate {coordinate.name} does not increase by equal steps; expected a grid, or size=…")
    unit = own_unit(coordinate)
    if not unit:
        raise InvalidArgument(f"coordinate {coordinate.name} has no unit; expected attrs['units'], or size=…")
    return step * len(values) * _setae.length_factor(unit)


def of_data_array(array: Any, size: Size | None, unit: str | None, periodic: bool, name: str) -> InMemory:
    """A DataArray of xarray with the dimensions x and y, or with other names in the order x, y."""
    if set(array.dims) == {"x", "y"}:
        array = array.transpose("x", "y")
    attributes = array.attrs
    stated = {key: str(attributes[key]) for key in ("instrument", "tip_radius", "resolution", "trend") if attributes.get(key)}
    unit = unit or own_unit(array)
    if size is not None:
        return InMemory((metres(array.data, unit), lengths(size), periodic), stated=stated)
    coordinates = [array.coords[dimension] for dimension in array.dims if dimension in array.coords]
    if len(coordinates) < len(array.dims):
        raise InvalidArgument("a dimension has no coordinate; expected coordinates with a unit, or size=…")
    if len(coordinates) == 1 and steps_of(np.asarray(coordinates[0].values, dtype=np.float64)) is None:
        points = of_points(coordinates[0], array.data, unit, name)
        return InMemory(table=points.table, stated=stated)
    extents = [extent_of(coordinate) for coordinate in coordinates]
    repeats = all(is_period(coordinate, extent) for coordinate, extent in zip(coordinates, extents))
    return InMemory((metres(array.data, unit), extents, periodic or repeats), stated=stated)


def is_period(coordinate: Any, extent: float) -> bool:
    """Whether the attribute "period" of a coordinate is its extent [m]; it is not in a part of a periodic map."""
    period = coordinate.attrs.get("period")
    return period is not None and abs(float(period) * _setae.length_factor(own_unit(coordinate)) / extent - 1.0) < 1e-6


def of_topography(topography: Any, name: str) -> InMemory:
    if topography.unit is None:
        raise InvalidArgument("the topography has no unit; expected one, such as topography.to_unit('m')")
    stated = instrument_of(getattr(topography, "info", {}))
    if not topography.is_uniform:
        positions, heights = topography.positions_and_heights()
        points = of_points(positions, heights, topography.unit, name)
        return InMemory(table=points.table, stated=stated)
    factor = _setae.length_factor(topography.unit)
    extent = [float(length) * factor for length in np.atleast_1d(topography.physical_sizes)]
    return InMemory((metres(topography.heights(), topography.unit), extent, bool(topography.is_periodic)), stated=stated)


def instrument_of(info: Any) -> dict[str, str]:
    """Radius of the tip and resolution in the info of a topography.

    >>> instrument_of({"instrument": {"parameters": {"tip_radius": {"value": 10.0, "unit": "nm"}}}})
    {'tip_radius': '10.0 nm'}
    """
    parameters = ((info or {}).get("instrument") or {}).get("parameters") or {}
    known = {key: parameters[key] for key in ("tip_radius", "resolution") if parameters.get(key)}
    return {key: f"{float(entry['value'])!r} {entry['unit']}" for key, entry in known.items()}


def info_of(tip_radius: str, resolution: str) -> dict[str, Any]:
    """The info of a topography with radius of the tip and resolution, without their standard errors.

    >>> info_of("10 ± 2 nm", "")
    {'instrument': {'parameters': {'tip_radius': {'value': 10.0, 'unit': 'nm'}}}}
    """
    parameters = {}
    for key, text in (("tip_radius", tip_radius), ("resolution", resolution)):
        found = re.fullmatch(r"\s*([-+.\deE]+)\s*(?:(?:±|\+-|\+/-)\s*[-+.\deE]+\s*)?(\S+)\s*", text)
        if found:
            parameters[key] = {"value": float(found[1]), "unit": found[2]}
    return {"instrument": {"parameters": parameters}} if parameters else {}
