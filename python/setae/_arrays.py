# SPDX-License-Identifier: GPL-3.0-or-later
"""Heights of other packages as arrays of float64 in metres."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from . import _setae
from ._errors import InvalidArgument
from ._options import Text
from ._scan import lengths

if TYPE_CHECKING:
    from numpy.typing import NDArray


def as_heights(
    heights: Any, size: Text | tuple[Text, ...] | None, unit: str | None, periodic: bool
) -> tuple[NDArray[np.float64], list[float], bool]:
    """The array in metres, its extents in metres, and whether it is periodic."""
    if hasattr(heights, "physical_sizes") and callable(getattr(heights, "heights", None)):
        return of_topography(heights)
    if hasattr(heights, "dims") and hasattr(heights, "coords"):
        own = heights.attrs.get("units", heights.attrs.get("unit"))
        extent = lengths(size) if size is not None else [extent_of(heights.coords[name]) for name in heights.dims]
        return metres(heights.values, unit or own), extent, periodic
    if size is None:
        raise InvalidArgument('an array has no size; expected size="5 um x 5 um" of a map, size="1 mm" of a line')
    return metres(heights, unit), lengths(size), periodic


def metres(heights: Any, unit: str | None) -> NDArray[np.float64]:
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


def extent_of(coordinate: Any) -> float:
    """Number of points times their step, for coordinates with equal steps."""
    values = np.asarray(coordinate.values, dtype=np.float64)
    steps = np.diff(values)
    if len(steps) == 0 or not np.allclose(steps, steps[0], rtol=1e-6, atol=0.0) or not steps[0] > 0.0:
        raise InvalidArgument(f"coordinate {coordinate.name} does not increase by equal steps; expected a grid, or size=…")
    unit = coordinate.attrs.get("units", coordinate.attrs.get("unit"))
    if not unit:
        raise InvalidArgument(f"coordinate {coordinate.name} has no unit; expected attrs['units'], or size=…")
    return float((values[-1] - values[0]) / (len(values) - 1) * len(values)) * _setae.length_factor(unit)


def of_topography(topography: Any) -> tuple[NDArray[np.float64], list[float], bool]:
    if not topography.is_uniform:
        raise InvalidArgument("a nonuniform line scan; expected heights on a grid: write the line scan to a file and read this file")
    if topography.unit is None:
        raise InvalidArgument("the topography has no unit; expected one, such as topography.to_unit('m')")
    factor = _setae.length_factor(topography.unit)
    extent = [float(length) * factor for length in np.atleast_1d(topography.physical_sizes)]
    return metres(topography.heights(), topography.unit), extent, bool(topography.is_periodic)
