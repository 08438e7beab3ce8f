# SPDX-License-Identifier: GPL-3.0-or-later
"""Simulated surfaces, and the tip estimated from a map."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from . import _setae
from ._given import Source, as_file
from ._names import renamed
from ._options import Path, Size, Text, filled, path, size_text, text
from ._quantities import Quantity
from ._results import Answer
from ._scan import Items, Measured, Scan, items, scan_of


@dataclass(frozen=True, repr=False)
class Synthesis(Answer):
    """A simulated surface or line, as printed by ``setae synthesize --json``; ``scan`` contains its heights."""

    scan: Scan = field(compare=False)

    def plot(self, ax: Any = None, **style: Any) -> Any:
        """Plots the heights on axes of matplotlib."""
        return self.scan.plot(ax, **style)


@renamed("hurst")
def synthesize(
    *,
    size: Size,
    pixels: int | str = 1024,
    hurst_exponent: float | None = None,
    rolloff: Text | None = None,
    short_cutoff: Text | None = None,
    long_cutoff: Text | None = None,
    rms_height: Text | None = None,
    rms_slope: float | None = None,
    plateau: Text | None = None,
    spectrum: Source | None = None,
    unit: str | None = None,
    window_of: Text | None = None,
    line: bool = False,
    exact_rms: bool = False,
    amplitudes: str = "gaussian",
    stretch: float = 1.0,
    angle: float = 0.0,
    skewness: float | None = None,
    kurtosis: float | None = None,
    seed: int = 0,
    output: Path | None = None,
) -> Synthesis:
    """A random surface, or a line on one, with a given spectrum; the same seed gives the same surface.

    C_iso(q) = C_0 for q < q_r, C_0 (q/q_r)^(−2−2H) up to q_s, 0 above; q = 2π/wavelength [Jacobs, Junge, Pastewka, Surf. Topogr. 5 (2017) 013001].
    A self-affine spectrum takes hurst_exponent, rolloff, short_cutoff and one of rms_height, rms_slope and plateau; a spectrum table replaces them.

    Parameters
    ----------
    size : str or Quantity or tuple
        extent of the surface along x and y, or one length for both, such as "5 um x 2 um"
    pixels : int or str, default 1024
        points along x and y, 1024x512, or one number for both
    hurst_exponent : float, optional
        Hurst exponent H of a self-affine spectrum, 0 < H <= 1
    rolloff : str or Quantity, optional
        roll-off wavelength, above which the spectrum is flat, such as "2 um"
    short_cutoff : str or Quantity, optional
        shortest wavelength of a self-affine spectrum, such as "20 nm"
    long_cutoff : str or Quantity, optional
        longest wavelength of a self-affine spectrum, such as "20 um"; default: no limit
    rms_height : str or Quantity, optional
        rms height of the spectrum, such as "20 nm"
    rms_slope : float, optional
        rms slope of the spectrum, such as "0.3"
    plateau : str or Quantity, optional
        C_iso at wavelengths longer than the roll-off, such as "5e-27 m4"
    spectrum : str or path or table, optional
        table of q and C_iso [m4] or C1D [m3] instead of a self-affine spectrum
    unit : str, optional
        units of the columns of a spectrum's table whose header has none, such as "frequency 1/um, one-sided nm3"
    window_of : str or Quantity, optional
        extent of the periodic surface from which a window of the size given is cut, which is not periodic, such as "20 um"
    line : bool, default False
        a line on a surface with the spectrum, instead of a map
    exact_rms : bool, default False
        heights are scaled to the rms height of the spectrum, or to the rms height given
    amplitudes : str, default 'gaussian'
        amplitudes of the modes: random, or exactly those of the spectrum; one of gaussian, exact
    stretch : float, default 1.0
        factor by which features are longer along one direction
    angle : float, default 0.0
        angle between the long direction of stretched features and x in degrees
    skewness : float, optional
        skewness of the heights of a surface, which keeps the spectrum; default: 0
    kurtosis : float, optional
        kurtosis of the heights of a surface, which keeps the spectrum; default: 3, Gaussian
    seed : int, default 0
        seed of the random numbers; equal seeds give equal surfaces
    output : str or path, optional
        file for the surface, whose ending gives the format; nothing is written without it

    Returns
    -------
    Synthesis
        the surface as ``scan``, and the quantities of its spectrum

    Raises
    ------
    InvalidArgument
        for a value outside its domain, with another dimension or without its unit
    FormatError
        for content of an unknown format, or damaged content

    Examples
    --------
    >>> made = synthesize(hurst_exponent=0.8, rolloff="2 um", short_cutoff="100 nm", rms_height="20 nm", size="8 um", pixels=128, amplitudes="exact", exact_rms=True)
    >>> made.scan.heights.shape, round(float(made.scan.heights.std()), 12)
    ((128, 128), 2e-08)
    """
    table = None if spectrum is None else as_file(spectrum, "spectrum")
    request = filled(
        _setae.SynthesisRequest(),
        size=size_text(size),
        pixels=str(pixels),
        hurst_exponent=hurst_exponent,
        rolloff=rolloff,
        short_cutoff=short_cutoff,
        long_cutoff=long_cutoff,
        rms_height=rms_height,
        rms_slope=rms_slope,
        plateau=plateau,
        spectrum=None if table is None else path(table),
        unit=unit,
        window_of=window_of,
        line=line,
        exact_rms=exact_rms,
        amplitudes=amplitudes,
        stretch=stretch,
        angle=angle,
        skewness=skewness,
        kurtosis=kurtosis,
        seed=seed,
    )
    file = "" if output is None else path(output)
    made = _setae.synthesize(request, file)
    return Synthesis(made.json, scan_of(made.heights, file or "synthesized"))


@dataclass(frozen=True, repr=False)
class Tip(Answer):
    """The bluntest tip that could have made a map, as printed by ``setae tip --json``.

    ``scan``: the tip, apex up.  ``surface``: the surface without the tip where it is certain, NaN elsewhere.
    """

    scan: Scan = field(compare=False)
    surface: Scan = field(compare=False)

    @property
    def radius(self) -> Quantity:
        """Radius of a parabola through the apex, an upper bound."""
        return self.quantities[0]

    def plot(self, ax: Any = None, **style: Any) -> Any:
        """Plots the tip on axes of matplotlib."""
        return self.scan.plot(ax, **style)


def tip(measurement: Measured, *, points: int = 21, threshold: Text | None = None, rounds: int = 100, size: Size | None = None,
        unit: str | None = None, keep_values: bool = False) -> Tip:
    """The bluntest tip that could have made a map: t(v) ≥ min_u [i(x) + t(u) − i(x + u − v)] for every x [Villarrubia 1997].

    Noise above the threshold sharpens the estimate. Level and despike the map first.

    Parameters
    ----------
    measurement : scan, str, path, array, table or a list of them
        a map
    points : int, default 21
        extent of the estimated tip in pixels, an odd number
    threshold : str or Quantity, optional
        height by which the map must demand a sharper tip, about twice the noise, such as "0.2 nm"; default: 0
    rounds : int, default 100
        largest number of passes over the map
    size : str or Quantity or tuple, optional
        extent of the heights, where the file does not state it, such as '5 um x 5 um'
    unit : str, optional
        unit of the heights, where the file does not state it, such as 'nm'
    keep_values : bool, default False
        heights are taken as they are: no value counts as a mark of missing data

    Returns
    -------
    Tip
        the tip as ``scan``, its radius, and the surface where it is certain

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
    >>> spike = numpy.zeros((15, 15))
    >>> spike[7, 7] = 5.0
    >>> setae.tip(setae.scan(spike, size="15 nm x 15 nm", unit="nm"), points=5).scan.heights.shape
    (5, 5)
    """
    request = filled(_setae.BlindTipRequest(), points=points, threshold=threshold, rounds=rounds)
    measured = one(measurement, size, unit, keep_values)
    found = _setae.blind_tip(measured[0], request)
    return Tip(found.json, scan_of(found.tip, "tip"), scan_of(found.surface, "surface"))


def one(measurement: Measured, size: Size | None, unit: str | None, keep_values: bool, trend: str | None = None) -> Items:
    """The single measurement of a call, in a list that keeps it."""
    found = items(measurement, {"stated_size": size_text(size), "stated_unit": text(unit), "keep_values": keep_values, "trend": text(trend)})
    if len(found) != 1:
        raise TypeError(f"{len(found)} measurements; expected one")
    return found
