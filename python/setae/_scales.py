# SPDX-License-Identifier: GPL-3.0-or-later
"""Functions of a distance: slopes and curvatures at every scale, autocorrelation, variable bandwidth."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from . import _setae
from ._columns import Columns
from ._names import renamed
from ._options import Size, Text, filled, text
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


def function_of_scale(command: str, measurements: Measured, shared: dict[str, Any], memory: float | None, skip_failed: bool,
                      **asked: Any) -> FunctionOfScale:
    request = filled(_setae.ScaleRequest(), every_measurement=not skip_failed, **asked)
    answer = _setae.functions_of_scale(command, items(measurements, shared), analysis_of(memory=memory), request)
    return FunctionOfScale(answer.columns, answer.units, answer.json)


@renamed("all")
def scale_dependent_roughness(
    measurements: Measured,
    *,
    order: int = 1,
    distance: Text | Sequence[Text] = (),
    statistic: str = "rms",
    along: str = "x",
    keep_unreliable: bool = False,
    binned: bool = False,
    bins_per_decade: int | None = None,
    weighting: str | None = None,
    instrument: str | None = None,
    tip_radius: Text | None = None,
    resolution: Text | None = None,
    trend: str | None = None,
    size: Size | None = None,
    unit: str | None = None,
    keep_values: bool = False,
    memory: float | None = None,
    skip_failed: bool = False,
) -> FunctionOfScale:
    """Slope (order 1), curvature (order 2) or third derivative (order 3) as a function of scale, as ``setae sdrp``.

    [h(x + s) − h(x)]/s over d = s; [h(x − s) − 2h(x) + h(x + s)]/s² over d = 2s.

    Parameters
    ----------
    measurements : scan, str, path, array, table or a list of them
        one measurement, or all measurements of one surface: scans, files, arrays with a size
    order : int, default 1
        order of the derivative: 1 slope, 2 curvature, 3 third derivative
    distance : str or Quantity or Sequence[str or Quantity], default ()
        length of the stencil, or several lengths separated by commas, such as "10nm,100nm"; default: ten per decade
    statistic : str, default 'rms'
        statistic of the derivative; one of rms, variance, mean, skewness, kurtosis, minimum, maximum
    along : str, default 'x'
        direction of the differences; one of x, y, both
    keep_unreliable : bool, default False
        unreliable distances, too: those that sampling, tip or resolution distort
    binned : bool, default False
        one measurement is shown in the bins of combined measurements, too
    bins_per_decade : int, optional
        bins per decade of combined functions
    weighting : str, optional
        weights of measurements that are combined; one of equal, per_instrument, by_count
    instrument : str, optional
        kind of the instrument; default: that of the file; one of stylus, afm, tem, optical
    tip_radius : str or Quantity, optional
        radius of the tip, with its standard error, such as '10 ± 2 nm'; default: that of the file
    resolution : str or Quantity, optional
        shortest wavelength that the instrument resolves, such as '500 nm'; default: that of the file
    trend : str, optional
        trend that is removed before the analysis; default: none after steps that level, else by instrument; one of none, mean, tilt,
        parabola
    size : str or Quantity or tuple, optional
        extent of the heights, where the file does not state it, such as '5 um x 5 um'
    unit : str, optional
        unit of the heights, where the file does not state it, such as 'nm'
    keep_values : bool, default False
        heights are taken as they are: no value counts as a mark of missing data
    memory : float, optional
        memory for heights in GiB; larger maps are read in bands of scan lines
    skip_failed : bool, default False
        measurements that cannot be analysed are left out with a warning

    Returns
    -------
    FunctionOfScale
        distances and the statistic at each distance

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
    >>> wave = setae.scan(3e-9 * numpy.cos(2 * numpy.pi * 8 * numpy.arange(512) / 512), size="2 um", unit="m")
    >>> slope = setae.scale_dependent_roughness(wave, distance=["50 nm", "100 nm"], trend="none")
    >>> slope.distance.size, slope.quantity
    (2, 'rms_slope')
    """
    lengths: list[Any] = [distance] if not isinstance(distance, (list, tuple)) else list(distance)
    shared = shared_options(instrument, tip_radius, resolution, trend, size, unit, keep_values)
    return function_of_scale(
        "sdrp",
        measurements,
        shared,
        memory,
        skip_failed,
        order=order,
        distance=",".join(text(length, "distance") for length in lengths),
        statistic=statistic,
        along=along,
        all=keep_unreliable,
        binned=binned,
        bins_per_decade=bins_per_decade,
        weighting=weighting,
    )


@renamed("all", longest="longest_distance")
def autocorrelation(
    measurements: Measured,
    *,
    area: bool = False,
    slope: bool = False,
    longest_distance: Text | None = None,
    keep_unreliable: bool = False,
    binned: bool = False,
    bins_per_decade: int | None = None,
    weighting: str | None = None,
    instrument: str | None = None,
    tip_radius: Text | None = None,
    resolution: Text | None = None,
    trend: str | None = None,
    size: Size | None = None,
    unit: str | None = None,
    keep_values: bool = False,
    memory: float | None = None,
    skip_failed: bool = False,
) -> FunctionOfScale:
    """Height-difference autocorrelation A(d) = ⟨[h(x + d) − h(x)]²⟩/2 [m²], as ``setae acf``.

    Parameters
    ----------
    measurements : scan, str, path, array, table or a list of them
        one measurement, or all measurements of one surface: scans, files, arrays with a size
    area : bool, default False
        maps as areas, over all directions or by planes, instead of along scan lines
    slope : bool, default False
        rms slope between points, sqrt(2A)/d, instead of A
    longest_distance : str or Quantity, optional
        longest distance over an area, needed for maps that are read in bands, such as '5 um'
    keep_unreliable : bool, default False
        unreliable distances, too: those that sampling, tip or resolution distort
    binned : bool, default False
        one measurement is shown in the bins of combined measurements, too
    bins_per_decade : int, optional
        bins per decade of combined functions
    weighting : str, optional
        weights of measurements that are combined; one of equal, per_instrument, by_count
    instrument : str, optional
        kind of the instrument; default: that of the file; one of stylus, afm, tem, optical
    tip_radius : str or Quantity, optional
        radius of the tip, with its standard error, such as '10 ± 2 nm'; default: that of the file
    resolution : str or Quantity, optional
        shortest wavelength that the instrument resolves, such as '500 nm'; default: that of the file
    trend : str, optional
        trend that is removed before the analysis; default: none after steps that level, else by instrument; one of none, mean, tilt,
        parabola
    size : str or Quantity or tuple, optional
        extent of the heights, where the file does not state it, such as '5 um x 5 um'
    unit : str, optional
        unit of the heights, where the file does not state it, such as 'nm'
    keep_values : bool, default False
        heights are taken as they are: no value counts as a mark of missing data
    memory : float, optional
        memory for heights in GiB; larger maps are read in bands of scan lines
    skip_failed : bool, default False
        measurements that cannot be analysed are left out with a warning

    Returns
    -------
    FunctionOfScale
        distances and A at each distance

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
    >>> wave = setae.scan(3e-9 * numpy.cos(2 * numpy.pi * 8 * numpy.arange(512) / 512), size="2 um", unit="m", periodic=True)
    >>> A = setae.autocorrelation(wave, trend="none", keep_unreliable=True)
    >>> bool(numpy.isclose(A.value.max(), (3e-9) ** 2))
    True
    """
    shared = shared_options(instrument, tip_radius, resolution, trend, size, unit, keep_values)
    return function_of_scale(
        "acf",
        measurements,
        shared,
        memory,
        skip_failed,
        area=area,
        slope=slope,
        longest=text(longest_distance, "longest_distance"),
        all=keep_unreliable,
        binned=binned,
        bins_per_decade=bins_per_decade,
        weighting=weighting,
    )


@renamed("all")
def variable_bandwidth(
    measurements: Measured,
    *,
    area: bool = False,
    keep_unreliable: bool = False,
    binned: bool = False,
    bins_per_decade: int | None = None,
    weighting: str | None = None,
    instrument: str | None = None,
    tip_radius: Text | None = None,
    resolution: Text | None = None,
    trend: str | None = None,
    size: Size | None = None,
    unit: str | None = None,
    keep_values: bool = False,
    memory: float | None = None,
    skip_failed: bool = False,
) -> FunctionOfScale:
    """Rms height in cells of every length after subtraction of the best line (area: plane), as ``setae vbw``.

    Parameters
    ----------
    measurements : scan, str, path, array, table or a list of them
        one measurement, or all measurements of one surface: scans, files, arrays with a size
    area : bool, default False
        maps as areas, over all directions or by planes, instead of along scan lines
    keep_unreliable : bool, default False
        unreliable distances, too: those that sampling, tip or resolution distort
    binned : bool, default False
        one measurement is shown in the bins of combined measurements, too
    bins_per_decade : int, optional
        bins per decade of combined functions
    weighting : str, optional
        weights of measurements that are combined; one of equal, per_instrument, by_count
    instrument : str, optional
        kind of the instrument; default: that of the file; one of stylus, afm, tem, optical
    tip_radius : str or Quantity, optional
        radius of the tip, with its standard error, such as '10 ± 2 nm'; default: that of the file
    resolution : str or Quantity, optional
        shortest wavelength that the instrument resolves, such as '500 nm'; default: that of the file
    trend : str, optional
        trend that is removed before the analysis; default: none after steps that level, else by instrument; one of none, mean, tilt,
        parabola
    size : str or Quantity or tuple, optional
        extent of the heights, where the file does not state it, such as '5 um x 5 um'
    unit : str, optional
        unit of the heights, where the file does not state it, such as 'nm'
    keep_values : bool, default False
        heights are taken as they are: no value counts as a mark of missing data
    memory : float, optional
        memory for heights in GiB; larger maps are read in bands of scan lines
    skip_failed : bool, default False
        measurements that cannot be analysed are left out with a warning

    Returns
    -------
    FunctionOfScale
        lengths of cells and the rms height in cells of each length

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
    >>> wave = setae.scan(3e-9 * numpy.cos(2 * numpy.pi * 8 * numpy.arange(512) / 512), size="2 um", unit="m")
    >>> found = setae.variable_bandwidth(wave)
    >>> bool(found.value[-1] > found.value[0])
    True
    """
    shared = shared_options(instrument, tip_radius, resolution, trend, size, unit, keep_values)
    return function_of_scale(
        "vbw",
        measurements,
        shared,
        memory,
        skip_failed,
        area=area,
        all=keep_unreliable,
        binned=binned,
        bins_per_decade=bins_per_decade,
        weighting=weighting,
    )
