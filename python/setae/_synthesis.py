# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces that are made, and the tip that a map shows."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from . import _setae
from ._options import Path, Text, filled, path, text
from ._quantities import Answer, Quantity
from ._scan import Measured, Scan, held, items


@dataclass(frozen=True, repr=False)
class Synthesis(Answer):
    """A surface or line that was made, as ``setae synthesize --json`` says it; ``scan`` holds its heights."""

    scan: Scan = field(compare=False)


def synthesize(
    *,
    size: Text,
    pixels: int | str = 1024,
    hurst: float | None = None,
    rolloff: Text | None = None,
    short_cutoff: Text | None = None,
    long_cutoff: Text | None = None,
    rms_height: Text | None = None,
    rms_slope: float | None = None,
    plateau: Text | None = None,
    spectrum: Path | None = None,
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

    size: "5 um" or "5 um x 2 um".  pixels: 1024 or "1024x512".  hurst, rolloff, short_cutoff: of a self-affine spectrum, with one of rms_height,
    rms_slope and plateau (C_iso below the roll-off, "5e-27 m4").  spectrum: a table of q and C_iso or C1D in their place; unit: of its columns.
    window_of: the extent of a periodic surface of which ``size`` is a part.  amplitudes: "gaussian" or "exact".
    stretch, angle: features longer along a direction, degrees.  output: written there, too.

    >>> made = synthesize(hurst=0.8, rolloff="2 um", short_cutoff="100 nm", rms_height="20 nm", size="8 um", pixels=128, amplitudes="exact", exact_rms=True)
    >>> made.scan.heights.shape, round(float(made.scan.heights.std()), 12)
    ((128, 128), 2e-08)
    """
    request = filled(
        _setae.SynthesisRequest(),
        size=text(size),
        pixels=str(pixels),
        hurst=hurst,
        rolloff=rolloff,
        short_cutoff=short_cutoff,
        long_cutoff=long_cutoff,
        rms_height=rms_height,
        rms_slope=text(rms_slope),
        plateau=plateau,
        spectrum=None if spectrum is None else path(spectrum),
        spectrum_unit=unit,
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
    return Synthesis(made.json, held(made.heights, file or "synthesized"))


@dataclass(frozen=True, repr=False)
class Tip(Answer):
    """The bluntest tip that could have made a map, as ``setae tip --json`` says it.

    ``scan``: the tip, apex up.  ``surface``: the map without it where that is certain, NaN elsewhere.
    """

    scan: Scan = field(compare=False)
    surface: Scan = field(compare=False)

    @property
    def radius(self) -> Quantity:
        """Of a parabola through the apex; the tip is no blunter."""
        return self.quantities[0]


def tip(measurement: Measured, *, points: int = 21, threshold: Text | None = None, rounds: int = 100, size: Text | None = None,
        unit: str | None = None, keep_values: bool = False) -> Tip:
    """The bluntest tip that could have made a map: t(v) ≥ min_u [i(x) + t(u) − i(x + u − v)] for every x [Villarrubia 1997].

    points: extent of the estimate in pixels, odd.  threshold: twice the noise's largest deviation, else noise sharpens the tip. Level and despike first.
    """
    request = filled(_setae.BlindTipRequest(), points=points, threshold=threshold, rounds=rounds)
    found = _setae.blind_tip(one(measurement, size, unit, keep_values), request)
    return Tip(found.json, held(found.tip, "tip"), held(found.surface, "surface"))


def one(measurement: Measured, size: Text | None, unit: str | None, keep_values: bool, trend: str | None = None) -> Any:
    """The one measurement that is meant."""
    found = items(measurement, {"stated_size": text(size), "stated_unit": text(unit), "keep_values": keep_values, "trend": text(trend)})
    if len(found) != 1:
        raise TypeError(f"{len(found)} measurements; expected one")
    return found[0]
