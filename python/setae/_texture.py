# SPDX-License-Identifier: GPL-3.0-or-later
"""Parameters of surface texture by ISO 25178-2 and ISO 21920-2."""

from __future__ import annotations

from . import _setae
from ._options import Size, Text, filled
from ._scan import Measured, items
from ._spectra import Parameters, shared_options


class Texture(Parameters):
    """Parameters of a standard by symbol or by name, ``texture(…)["Sq"]``, as printed by ``setae params --standard --json``."""


def texture(
    measurements: Measured,
    standard: str,
    *,
    only: str | None = None,
    s_filter: Text | None = None,
    l_filter: Text | None = None,
    section_length: Text | None = None,
    profile: str | None = None,
    averages: str | None = None,
    mean_line: str | None = None,
    between: str | None = None,
    material_height: Text | None = None,
    material_ratio: float | None = None,
    instrument: str | None = None,
    tip_radius: Text | None = None,
    resolution: Text | None = None,
    trend: str | None = None,
    size: Size | None = None,
    unit: str | None = None,
    keep_values: bool = False,
    skip_failed: bool = False,
) -> Texture:
    """Parameters of "iso25178" (maps) or "iso21920" (lines; for maps the mean over scan lines).

    The formulas are in docs/reference/parameters.md.

    Parameters
    ----------
    measurements : scan, str, path, array, table or a list of them
        one measurement, or all measurements of one surface: scans, files, arrays with a size
    standard : str
        standard of the parameters: of maps (iso25178), or of lines (iso21920; of a map the mean over scan lines); one of iso25178,
        iso21920
    only : str, optional
        symbols or names of the parameters of a standard that are wanted, such as "Sq, Sdr"; default: all
    s_filter : str or Quantity, optional
        nesting index of the Gaussian S-filter (λs), such as "2.5um"
    l_filter : str or Quantity, optional
        Gaussian L-filter: "default" for both filters of iso21920 by Ra (ISO 4288), or a nesting index (λc), such as "0.8mm"
    section_length : str or Quantity, optional
        length of a section by iso21920, such as "0.8mm"; default: the nesting index of the L-filter, else all
    profile : str, optional
        profile whose parameters iso21920 gives; default: roughness; one of primary, waviness, roughness
    averages : str, optional
        averages of iso21920: over the evaluation length (2021), or over sections (ISO 4287:1997); default: evaluation_length; one of
        evaluation_length, sections
    mean_line : str, optional
        zero of heights in iso21920: the mean, or zero for profiles that an instrument filtered; default: mean; one of mean, zero
    between : str, optional
        heights between points in the material ratio: linear (triangles), or nothing; default: linear; one of linear, nothing
    material_height : str or Quantity, optional
        height c above the mean in Smr(c) and Rmr(c), such as "0.2um"; default: 0
    material_ratio : float, optional
        material ratio p in Smc(p) and Rmc(p), from 0 to 1; default: 0.5, the median
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
    skip_failed : bool, default False
        measurements that cannot be analysed are left out with a warning

    Returns
    -------
    Texture
        parameters of the standard by symbol or by name

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
    >>> print(setae.texture(wave, "iso21920", profile="primary", trend="mean")["Pq"])
    2.121 nm
    """
    request = filled(
        _setae.TextureRequest(),
        standard=standard,
        only=only,
        s_filter=s_filter,
        l_filter=l_filter,
        section_length=section_length,
        profile=profile,
        averages=averages,
        mean_line=mean_line,
        between=between,
        material_height=material_height,
        material_ratio=material_ratio,
    )
    shared = shared_options(instrument, tip_radius, resolution, trend, size, unit, keep_values)
    return Texture(_setae.texture(items(measurements, shared), request, not skip_failed))
