# SPDX-License-Identifier: GPL-3.0-or-later
"""Plots with matplotlib, an optional dependency: ``pip install setae[plot]``."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from ._loops import Loop
    from ._scales import FunctionOfScale
    from ._scan import Scan
    from ._spectra import Spectrum


def axes(ax: Any) -> Any:
    if ax is not None:
        return ax
    import matplotlib.pyplot as plt

    return plt.subplots()[1]


def label_log_axes(ax: Any) -> None:
    """Label powers of ten only; on an axis with fewer than two of them also 2 and 5 times a power, or four round numbers."""
    import math

    from matplotlib.ticker import LogFormatterSciNotation, LogLocator, MaxNLocator, NullFormatter

    for axis in (ax.xaxis, ax.yaxis):
        low, high = sorted(axis.get_view_interval())
        powers = math.floor(math.log10(high)) - math.ceil(math.log10(low)) + 1
        if powers >= 2:
            axis.set_major_locator(LogLocator())
        else:
            axis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)) if high > 3 * low else MaxNLocator(4))
        axis.set_major_formatter(LogFormatterSciNotation(minor_thresholds=(math.inf, math.inf)))
        axis.set_minor_formatter(NullFormatter())


def plot_scan(scan: Scan, ax: Any) -> Any:
    ax = axes(ax)
    nanometres, micrometres = 1e9 * scan.heights, [1e6 * length for length in scan.size]
    ax.set_xlabel("x [µm]")
    if scan.heights.ndim == 1:
        import numpy as np

        x = np.arange(len(nanometres)) * scan.pixel_size[0] if scan.positions is None else scan.positions
        ax.plot(1e6 * x, nanometres)
        ax.set_ylabel("h [nm]")
        return ax
    image = ax.imshow(nanometres.T, extent=(0, micrometres[0], micrometres[1], 0))
    ax.figure.colorbar(image, ax=ax, label="h [nm]")
    ax.set_ylabel("y [µm]")
    return ax


def plot_spectrum(spectrum: Spectrum, ax: Any, **style: Any) -> Any:
    ax = axes(ax)
    name = "C1D" if "C1D" in spectrum.columns else "C_iso"
    density, q = spectrum.columns[name], spectrum.q
    (line,) = ax.loglog(q, density, **style)
    if "standard_error" in spectrum.columns:
        error = spectrum.standard_error
        below = (density - error).clip(min=density / 10)
        ax.fill_between(q, below, density + error, color=line.get_color(), alpha=0.2, linewidth=0)
    ax.set_xlabel("q = 2π/λ [1/m]")
    ax.set_ylabel("C$_{1D}$ [m³]" if name == "C1D" else "C$_{iso}$ [m⁴]")
    label_log_axes(ax)
    return ax


def plot_loop(loop: Loop, ax: Any) -> Any:
    ax = axes(ax)
    columns = loop.columns
    against = "displacement" if "displacement" in columns else "contact_radius"
    ax.plot(1e6 * columns[against], 1e3 * columns["force"])
    ax.set_xlabel(f"{against.replace('_', ' ')} [µm]")
    ax.set_ylabel("force [mN]")
    return ax


def plot_function_of_scale(function: FunctionOfScale, ax: Any, **style: Any) -> Any:
    ax = axes(ax)
    ax.loglog(function.distance, function.value, **style)
    ax.set_xlabel("distance [m]")
    ax.set_ylabel(f"{function.quantity.replace('_', ' ')} [{function.units[function.quantity]}]")
    label_log_axes(ax)
    return ax
