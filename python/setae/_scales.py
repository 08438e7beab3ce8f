# SPDX-License-Identifier: GPL-3.0-or-later
"""Functions of a distance: slopes and curvatures at every scale, autocorrelation, variable bandwidth."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from . import _setae
from ._columns import Columns
from ._options import Text, text
from ._scan import Measured, items
from ._spectra import analysis_of, shared_options

if TYPE_CHECKING:
    from ._columns import Array


class FunctionOfScale(Columns):
    """A function of a distance, from one measurement or combined from several."""

    @property
    def quantity(self) -> str:
        """Name of the column that is a function of the distance."""
        return list(self.columns)[1]

    @property
    def distance(self) -> Array:
        """Distances [m]."""
        return self.columns["distance"]

    @property
    def value(self) -> Array:
        return self.columns[self.quantity]

    def __repr__(self) -> str:
        return f"FunctionOfScale({self.quantity} [{self.units[self.quantity]}] at {len(self.distance)} distances, {self.n} measurements)"

    def plot(self, ax: Any = None, **style: Any) -> Any:
        """Plots the function on logarithmic axes of matplotlib."""
        from ._plot import plot_function_of_scale

        return plot_function_of_scale(self, ax, **style)


def function_of_scale(command: str, measurements: Measured, asked: dict[str, Any], options: dict[str, Any]) -> FunctionOfScale:
    names = ("instrument", "tip_radius", "resolution", "trend", "size", "unit", "keep_values")
    shared = shared_options(*(options.pop(name, None) for name in names))
    request = _setae.ScaleRequest()
    request.every_measurement = not options.pop("skip_failed", False)
    memory = options.pop("memory", None)
    for name in ("all", "binned", "bins_per_decade", "weighting"):
        if name in options:
            setattr(request, name, options.pop(name))
    if options:
        raise TypeError(f"unknown argument '{next(iter(options))}'")
    for name, value in asked.items():
        setattr(request, name, value)
    answer = _setae.functions_of_scale(command, items(measurements, shared), analysis_of(memory=memory), request)
    return FunctionOfScale(answer.columns, answer.units, answer.json)


def scale_dependent(
    measurements: Measured,
    *,
    order: int = 1,
    distance: Text | Sequence[Text] = (),
    statistic: str = "rms",
    along: str = "x",
    **options: Any,
) -> FunctionOfScale:
    """Slope (order 1), curvature (order 2) or third derivative (order 3) as a function of scale, as ``setae sdrp``.

    [h(x + s) − h(x)]/s over d = s; [h(x − s) − 2h(x) + h(x + s)]/s² over d = 2s.

    Parameters
    ----------
    order : int, default 1
        order of the derivative: 1 slope, 2 curvature, 3 third derivative
    distance : str or Quantity or Sequence[str or Quantity], default ()
        length of the stencil, or several lengths separated by commas, such as "10nm,100nm"; default: ten per decade
    statistic : str, default 'rms'
        statistic of the derivative; one of rms, variance, mean, skewness, kurtosis, minimum, maximum
    along : str, default 'x'
        direction of the differences; one of x, y, both
    **options
        keywords of measurements, as those of `power_spectrum`, and of ScaleRequest
    """
    lengths: list[Any] = [distance] if not isinstance(distance, (list, tuple)) else list(distance)
    asked = {"order": order, "distance": ",".join(text(length, "distance") for length in lengths), "statistic": statistic, "along": along}
    return function_of_scale("sdrp", measurements, asked, options)


def autocorrelation(
    measurements: Measured, *, area: bool = False, slope: bool = False, longest: Text | None = None, **options: Any
) -> FunctionOfScale:
    """Height-difference autocorrelation A(d) = ⟨[h(x + d) − h(x)]²⟩/2 [m²], as ``setae acf``.

    Parameters
    ----------
    area : bool, default False
        maps as areas, over all directions or by planes, instead of along scan lines
    slope : bool, default False
        rms slope between points, sqrt(2A)/d, instead of A
    longest : str or Quantity
        longest distance over an area, needed for maps that are read in bands, such as "5 um"
    **options
        keywords of measurements, as those of `power_spectrum`, and of ScaleRequest

    >>> import numpy, setae
    >>> wave = setae.scan(3e-9 * numpy.cos(2 * numpy.pi * 8 * numpy.arange(512) / 512), size="2 um", unit="m", periodic=True)
    >>> A = setae.autocorrelation(wave, trend="none", all=True)
    >>> bool(numpy.isclose(A.value.max(), (3e-9) ** 2))
    True
    """
    return function_of_scale("acf", measurements, {"area": area, "slope": slope, "longest": text(longest, "longest")}, options)


def variable_bandwidth(measurements: Measured, *, area: bool = False, **options: Any) -> FunctionOfScale:
    """Rms height in cells of every length after subtraction of the best line (area: plane), as ``setae vbw``.

    Parameters
    ----------
    area : bool, default False
        maps as areas, over all directions or by planes, instead of along scan lines
    **options
        keywords of measurements, as those of `power_spectrum`, and of ScaleRequest
    """
    return function_of_scale("vbw", measurements, {"area": area}, options)
