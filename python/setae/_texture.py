# SPDX-License-Identifier: GPL-3.0-or-later
"""Parameters of surface texture by ISO 25178-2 and ISO 21920-2."""

from __future__ import annotations

from typing import Any

from . import _setae
from ._options import Text, filled
from ._scan import Measured, items
from ._spectra import Parameters, shared_options


class Texture(Parameters):
    """Parameters of a standard, as ``setae params --standard --json`` prints them: ``texture(…)["Sq"]`` by symbol or by name."""

    def __getitem__(self, name: str) -> Any:
        for entry in self._data:
            if entry["symbol"] == name:
                return super().__getitem__(entry["quantity"])
        return super().__getitem__(name)


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
    size: Text | None = None,
    unit: str | None = None,
    keep_values: bool = False,
    skip_failed: bool = False,
) -> Texture:
    """Parameters of "iso25178" (maps) or "iso21920" (lines; of maps the mean over scan lines); docs/reference/parameters.md has their formulas.

    only: symbols or names of the parameters wanted, "Sq, Sdr"; others are not computed.
    s_filter, l_filter: nesting indices of the Gaussian filters, "2.5 um", "0.8 mm".  profile: "primary", "waviness" or "roughness".
    averages: "evaluation_length" or "sections".  mean_line: "mean" or "zero".  between: "linear" or "nothing".

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
