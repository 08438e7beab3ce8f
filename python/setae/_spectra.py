# SPDX-License-Identifier: GPL-3.0-or-later
"""Power spectra, parameters and surfaces."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Any

from . import _setae
from ._columns import Columns
from ._errors import InvalidArgument
from ._names import renamed
from ._options import Size, Text, exact, filled, require, size_text, text
from ._quantities import Alert, Band, Quantity, alerts_from, number, quantity_from
from ._results import Answer
from ._scan import Measured, items

if TYPE_CHECKING:
    from ._columns import Array
    from ._fits import SpectrumFit


def shared_options(
    instrument: str | None, tip_radius: Text | None, resolution: Text | None, trend: str | None, size: Size | None, unit: str | None,
    keep_values: bool | None = False,
) -> dict[str, Any]:
    require("True or False", keep_values=keep_values)
    return {
        "instrument": text(instrument),
        "tip_radius": text(tip_radius, "tip_radius"),
        "resolution": text(exact(resolution), "resolution"),
        "trend": text(trend),
        "stated_size": size_text(size),
        "stated_unit": text(unit),
        "keep_values": bool(keep_values),
    }


def analysis_of(
    longest_wavelength: Text | None = None,
    shortest_wavelength: Text | None = None,
    window: str | None = None,
    contours: str | None = None,
    conversion: str | None = None,
    memory: float | None = None,
    bootstrap_resamples: int | None = None,
) -> _setae.Analysis:
    texts = {"longest_wavelength": longest_wavelength, "shortest_wavelength": shortest_wavelength, "window": window, "contours": contours,
             "conversion": conversion}
    given = {name: text(value, name) for name, value in texts.items() if value is not None}
    analysis = filled(_setae.Analysis(), memory=memory, bootstrap_resamples=bootstrap_resamples, **given)
    analysis.require_valid()
    return analysis


class Spectrum(Columns):
    """A spectrum with columns along the wavevector."""

    @property
    def q(self) -> Array:
        """Wavevectors 2π/λ [1/m]."""
        return self.columns["wavevector"]

    @property
    def C1D(self) -> Array:
        """Density of the spectrum of lines [m³]: h_rms² = (1/π) ∫ C1D dq."""
        return self.columns["C1D"]

    @property
    def C_iso(self) -> Array:
        """Radial density of the spectrum of the surface [m⁴]: h_rms² = (1/2π) ∫ q C_iso dq."""
        return self.columns["C_iso"]

    @property
    def standard_error(self) -> Array:
        return self.columns["standard_error"]

    def plot(self, ax: Any = None, **style: Any) -> Any:
        """Plots the spectrum on logarithmic axes of matplotlib."""
        from ._plot import plot_spectrum

        return plot_spectrum(self, ax, **style)


@dataclass(frozen=True, eq=False, repr=False)
class PowerSpectrum(Spectrum):
    """A spectrum of the modes of one measurement, or of several measurements in the bins of the combined grid."""

    @property
    def band(self) -> Band:
        """Wavevectors of the combined spectrum."""
        band = self._data["band"]
        return Band(number(band["lower"]), number(band["upper"]))

    fitted: dict[str, Array] = field(default_factory=dict, repr=False)  #: columns of the fitted values and of the model

    @property
    def fit(self) -> SpectrumFit:
        """Parameters of the self-affine fit, by name, with ``best_fit``, ``residuals`` and ``plot()``; empty without a fit."""
        from ._fits import SpectrumFit

        fit = self._data.get("fit")
        named = {entry["quantity"]: quantity_from(entry, self._shared) for entry in fit["parameters"]} if fit else {}
        return SpectrumFit(named, self.fitted, self.columns)

    def __repr__(self) -> str:
        return f"PowerSpectrum({len(self.q)} of {', '.join(self.columns)}, {self.n} measurements)"


@renamed("longest", "shortest", rolloff="fit_rolloff", short_cutoff="fit_short_cutoff")
def power_spectrum(
    measurements: Measured,
    *,
    isotropic: bool = False,
    abel: bool = False,
    binned: bool = False,
    fit: bool = False,
    fit_range: str | None = None,
    fit_rolloff: bool = True,
    fit_short_cutoff: bool = False,
    instrument: str | None = None,
    tip_radius: Text | None = None,
    resolution: Text | None = None,
    trend: str | None = None,
    size: Size | None = None,
    unit: str | None = None,
    keep_values: bool = False,
    longest_wavelength: Text | None = None,
    shortest_wavelength: Text | None = None,
    window: str | None = None,
    contours: str | None = None,
    memory: float | None = None,
    skip_failed: bool = False,
) -> PowerSpectrum:
    """The power spectral density of one measurement, or of all measurements of one surface.

    C1D(q) = |h(q)|²/L [m³], h(q) = ∫ h exp(−iqx) dx, two-sided and averaged over ±q, so that h_rms² = (1/π) ∫ C1D dq
    [Jacobs, Junge, Pastewka, Surf. Topogr. 5 (2017) 013001]. The range that tip or resolution limit is excluded.

    Metadata such as tip_radius are those of every measurement that does not state its own.

    Parameters
    ----------
    measurements : scan, str, path, array, table or a list of them
        one measurement, or all measurements of one surface: scans, files, arrays with a size
    isotropic : bool, default False
        C_iso by the transform of maps, too
    abel : bool, default False
        C_iso by the inverse Abel transform, too
    binned : bool, default False
        a spectrum of one measurement in the bins of combined measurements
    fit : bool, default False
        fit of a self-affine spectrum
    fit_range : str, optional
        wavevectors of the self-affine fit in 1/m, such as '1e5:1e8'; default: all
    fit_rolloff : bool, default True
        the fit has a roll-off; False: a power law without roll-off
    fit_short_cutoff : bool, default False
        the fit also finds where the spectrum ends
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
    longest_wavelength : str or Quantity, optional
        longest wavelength in all integrals, such as "100 um"
    shortest_wavelength : str or Quantity, optional
        shortest wavelength in all integrals, such as "50 nm"
    window : str, optional
        window of the Fourier transform: automatic, none, hann or blackman_harris; default: automatic
    contours : str, optional
        spectrum of traced curves: corrected for straight segments between points, or of the segments as they are; default:
        sinc_corrected; one of sinc_corrected, segments
    memory : float, optional
        memory for heights in GiB; larger maps are read in bands of scan lines
    skip_failed : bool, default False
        measurements that cannot be analysed are left out with a warning

    Returns
    -------
    PowerSpectrum
        columns wavevector, C1D and, if asked for, C_iso, with standard errors for several measurements

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
    A wave of amplitude A over the length L has A² L/4 in its mode:

    >>> import numpy, setae
    >>> wave = setae.scan(3e-9 * numpy.cos(2 * numpy.pi * 8 * numpy.arange(512) / 512), size="2 um", unit="m")
    >>> psd = setae.power_spectrum(wave, window="none", trend="mean")
    >>> bool(numpy.isclose(psd.C1D.max(), (3e-9) ** 2 * 2e-6 / 4))
    True
    """
    require("True or False", isotropic=isotropic, abel=abel, binned=binned, fit=fit, fit_rolloff=fit_rolloff, fit_short_cutoff=fit_short_cutoff)
    shared = shared_options(instrument, tip_radius, resolution, trend, size, unit, keep_values)
    spectrum = _setae.power_spectrum(
        items(measurements, shared),
        analysis_of(longest_wavelength, shortest_wavelength, window, contours, memory=memory),
        isotropic,
        abel,
        binned,
        fit,
        text(fit_range),
        not fit_rolloff,
        fit_short_cutoff,
        not skip_failed,
    )
    return PowerSpectrum(spectrum.columns, spectrum.units, spectrum.json, spectrum.fitted)


def name_of_parameter(quantity: str) -> str:
    """Parameters of maps and lines have one name in Python: "rms_height" for "areal_rms_height" and "profile_rms_height"."""
    return quantity.removeprefix("areal_").removeprefix("profile_")


class Parameters(Answer):
    """Parameters from heights and from the spectrum by name or symbol, as printed by ``setae params --json``.

    ``parameters["rms_height"]`` is ``parameters["Sq"]`` of a map and ``parameters["Rq"]`` of a line; of several measurements, the first.
    ``to_pandas()`` has a row for each.
    """

    def __iter__(self) -> Iterator[str]:
        return iter(self._by_name)

    @cached_property
    def _by_name(self) -> dict[str, Quantity]:
        named: dict[str, Quantity] = {}
        for quantity in self._kept:
            named.setdefault(name_of_parameter(quantity.quantity), quantity)
        return named

    @property
    def headline(self) -> dict[str, Quantity]:
        """The parameters to quote: rms height, slope, curvature and true area of the waves inside the reliable band."""
        return {entry["quantity"]: quantity_from(entry, self._shared) for entry in self._data if entry["headline"]}

    def of(self, file: str) -> dict[str, Quantity]:
        """The parameters of one measurement, or those called "combined"."""
        return {name_of_parameter(entry["quantity"]): quantity_from(entry, self._shared) for entry in self._data if entry["file"] == file}

    def to_dict(self) -> dict[str, Any]:
        """The JSON of each parameter by its name."""
        return {name_of_parameter(entry["quantity"]): entry for entry in reversed(self.data)}


@renamed("longest", "shortest")
def parameters(
    measurements: Measured,
    *,
    only: str | None = None,
    instrument: str | None = None,
    tip_radius: Text | None = None,
    resolution: Text | None = None,
    trend: str | None = None,
    size: Size | None = None,
    unit: str | None = None,
    keep_values: bool = False,
    longest_wavelength: Text | None = None,
    shortest_wavelength: Text | None = None,
    window: str | None = None,
    contours: str | None = None,
    conversion: str | None = None,
    memory: float | None = None,
    bootstrap_resamples: int | None = None,
    skip_failed: bool = False,
) -> Parameters:
    """Roughness parameters from heights and from the spectrum.

    No spectrum is computed if ``only`` names rms heights, slopes and curvatures of the heights, such as Sq.

    Parameters
    ----------
    measurements : scan, str, path, array, table or a list of them
        one measurement, or all measurements of one surface: scans, files, arrays with a size
    only : str, optional
        names or symbols of the parameters that are wanted, such as 'Sq, rms_slope_from_spectrum'; default: all
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
    longest_wavelength : str or Quantity, optional
        longest wavelength in all integrals, such as "100 um"
    shortest_wavelength : str or Quantity, optional
        shortest wavelength in all integrals, such as "50 nm"
    window : str, optional
        window of the Fourier transform: automatic, none, hann or blackman_harris; default: automatic
    contours : str, optional
        spectrum of traced curves: corrected for straight segments between points, or of the segments as they are; default:
        sinc_corrected; one of sinc_corrected, segments
    conversion : str, optional
        conversion of C1D to parameters of the surface: exact, or Eq. 11 of Dalvi et al. 2019 (eq11); default: exact; one of exact, eq11
    memory : float, optional
        memory for heights in GiB; larger maps are read in bands of scan lines
    bootstrap_resamples : int, optional
        bootstrap replicas for standard errors, 0 for none
    skip_failed : bool, default False
        measurements that cannot be analysed are left out with a warning

    Returns
    -------
    Parameters
        quantities by name or symbol

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
    >>> print(setae.parameters(wave, trend="mean")["rms_height"])
    2.121 nm
    """
    shared = shared_options(instrument, tip_radius, resolution, trend, size, unit, keep_values)
    analysis = analysis_of(longest_wavelength, shortest_wavelength, window, contours, conversion, memory, bootstrap_resamples)
    names = [name.strip() for name in (only or "").split(",") if name.strip()]
    return Parameters(_setae.parameters(items(measurements, shared), analysis, not skip_failed, names))


@dataclass(frozen=True, eq=False, repr=False)
class Surface(Spectrum):
    """A surface from several measurements: the spectrum and its moments with their standard errors.

    ``json()`` is the entry of the surface in the JSON of a study.
    """

    moments: tuple[Quantity, ...] = ()
    arguments: tuple[Any, ...] = field(default=(), repr=False)  #: arguments for the analysis in another process
    handle: Any = field(default=None, repr=False)

    def __getstate__(self) -> dict[str, Any]:
        return {**super().__getstate__(), "handle": None}

    @property
    def quantities(self) -> tuple[Quantity, ...]:
        """Moments of the spectrum with their standard errors."""
        return self.moments

    def __getitem__(self, name: str) -> Any:
        return self._by_name[name] if name in self._by_name else super().__getitem__(name)

    @property
    def method(self) -> str:
        """Origin of the spectrum: "likelihood", "average" or "given"."""
        return str(self._data["spectrum_method"])

    @property
    def n(self) -> int:
        return int(self._data["n_measurements"])

    @property
    def alerts(self) -> tuple[Alert, ...]:
        data = self._data
        return tuple(alert for m in data["measurements"] for alert in alerts_from(m.get("alerts", ()))) + alerts_from(data["alerts"])

    def __repr__(self) -> str:
        return f"Surface({self.method} of {self.n}: {', '.join(f'{q.symbol} = {q}' for q in self.moments[:4])})"

    def to_surface_topography(self) -> Any:
        """The measurements as a container of SurfaceTopography in memory, with their instruments."""
        from SurfaceTopography.Container.SurfaceContainer import InMemorySurfaceContainer

        measurements, shared, *_ = self.arguments
        if self.method == "given":
            raise InvalidArgument("a surface from a spectrum has no heights; expected a surface from measurements")
        return InMemorySurfaceContainer([scan.to_surface_topography() for scan in items(measurements, shared).kept])

    def analysed(self) -> _setae.Surface:
        """The surface of the library; it is computed again in another process."""
        if self.handle is not None:
            found: _setae.Surface = self.handle
            return found
        return computed(*self.arguments)


def computed(measurements: Any, shared: dict[str, str], analysis: tuple[Any, ...], spectrum: str, every: bool) -> _setae.Surface:
    return _setae.surface(items(measurements, shared), analysis_of(*analysis), spectrum, every)


@renamed("longest", "shortest")
def surface(
    measurements: Measured,
    *,
    spectrum: str | None = None,
    instrument: str | None = None,
    tip_radius: Text | None = None,
    resolution: Text | None = None,
    trend: str | None = None,
    size: Size | None = None,
    unit: str | None = None,
    keep_values: bool = False,
    longest_wavelength: Text | None = None,
    shortest_wavelength: Text | None = None,
    window: str | None = None,
    contours: str | None = None,
    conversion: str | None = None,
    memory: float | None = None,
    bootstrap_resamples: int | None = None,
    skip_failed: bool = False,
) -> Surface:
    """One spectrum of all measurements of a surface: a likelihood fit to all measurements, or their average.

    Parameters
    ----------
    measurements : scan, str, path, array, table or a list of them
        one measurement, or all measurements of one surface: scans, files, arrays with a size
    spectrum : str, optional
        combination of the spectra; one of likelihood, average; default: likelihood for several measurements, average for one
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
    longest_wavelength : str or Quantity, optional
        longest wavelength in all integrals, such as "100 um"
    shortest_wavelength : str or Quantity, optional
        shortest wavelength in all integrals, such as "50 nm"
    window : str, optional
        window of the Fourier transform: automatic, none, hann or blackman_harris; default: automatic
    contours : str, optional
        spectrum of traced curves: corrected for straight segments between points, or of the segments as they are; default:
        sinc_corrected; one of sinc_corrected, segments
    conversion : str, optional
        conversion of C1D to parameters of the surface: exact, or Eq. 11 of Dalvi et al. 2019 (eq11); default: exact; one of exact, eq11
    memory : float, optional
        memory for heights in GiB; larger maps are read in bands of scan lines
    bootstrap_resamples : int, optional
        bootstrap replicas for standard errors, 0 for none
    skip_failed : bool, default False
        measurements that cannot be analysed are left out with a warning

    Returns
    -------
    Surface
        the spectrum of the surface and its moments, for :func:`work_of_adhesion` and studies

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
    >>> import setae
    >>> rough = setae.synthesize(hurst_exponent=0.8, rolloff="2 um", short_cutoff="250 nm", rms_height="20 nm", size="4 um", pixels=64).scan
    >>> setae.surface(rough).method
    'average'
    """
    shared = shared_options(instrument, tip_radius, resolution, trend, size, unit, keep_values)
    limits = (text(longest_wavelength, "longest_wavelength"), text(shortest_wavelength, "shortest_wavelength"))
    options = (*limits, text(window), text(contours), text(conversion), memory, bootstrap_resamples)
    arguments = (items(measurements, shared).kept, shared, options, text(spectrum), not skip_failed)
    found = computed(*arguments)
    moments = tuple(map(quantity_from, json.loads(found.quantities())))
    return Surface(found.columns, found.units, found.json, moments, arguments, found)
