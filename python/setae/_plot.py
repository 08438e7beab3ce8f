# SPDX-License-Identifier: GPL-3.0-or-later
"""Plots with matplotlib, an optional dependency: ``pip install setae[plot]``. Every plot takes axes and keywords of matplotlib, and returns the axes."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from ._errors import InvalidArgument
from ._units import shown_unit

if TYPE_CHECKING:
    from ._columns import Array, Columns
    from ._loops import Loop
    from ._scales import FunctionOfScale
    from ._scan import Scan
    from ._spectra import Spectrum


def axes(ax: Any) -> Any:
    """The given axes, or those of a new figure."""
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


def label(name: str, unit: str) -> str:
    """ "mean gap [m]"; a name without unit for numbers."""
    shown = name.replace("_", " ")
    return shown if unit == "1" else f"{shown} [{shown_unit(unit)}]"


def plot_map(values: Any, size: Sequence[float], colours: str, ax: Any, **style: Any) -> Any:
    """A map with x to the right and y upwards, as in figures of the program, with a bar of its colours."""
    ax = axes(ax)
    extent = (0.0, 1e6 * size[0], 0.0, 1e6 * size[1])
    image = ax.imshow(values.T, **{"origin": "lower", "extent": extent, "interpolation": "nearest", **style})
    ax.figure.colorbar(image, ax=ax, label=colours)
    ax.set_xlabel("x [µm]")
    ax.set_ylabel("y [µm]")
    return ax


def plot_line(x: Any, values: Any, name: str, ax: Any, **style: Any) -> Any:
    ax = axes(ax)
    ax.plot(1e6 * x, values, **style)
    ax.set_xlabel("x [µm]")
    ax.set_ylabel(name)
    return ax


def plot_scan(scan: Scan, ax: Any, **style: Any) -> Any:
    import numpy as np

    nanometres = 1e9 * scan.heights
    if scan.heights.ndim == 2:
        return plot_map(nanometres, scan.size, "h [nm]", ax, **style)
    x = np.arange(len(nanometres)) * scan.pixel_size[0] if scan.positions is None else scan.positions
    return plot_line(x, nanometres, "h [nm]", ax, **style)


def plot_contact(pressures: Array, gaps: Array, size: Sequence[float], of: str, ax: Any, **style: Any) -> Any:
    import numpy as np

    fields = {"pressure": (1e-6 * pressures, "pressure [MPa]"), "gap": (1e9 * gaps, "gap [nm]")}
    if of not in fields:
        raise InvalidArgument(f"of: '{of}'; expected pressure or gap")
    values, name = fields[of]
    if len(size) == 2:
        return plot_map(values, size, name, ax, **style)
    return plot_line(np.arange(values.size) * (size[0] / values.size), values.ravel(), name, ax, **style)


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


def plot_loop(loop: Loop, ax: Any, **style: Any) -> Any:
    ax = axes(ax)
    columns = loop.columns
    against = "displacement" if "displacement" in columns else "contact_radius"
    ax.plot(1e6 * columns[against], 1e3 * columns["force"], **style)
    ax.set_xlabel(label(against, "µm"))
    ax.set_ylabel("force [mN]")
    return ax


def plot_function_of_scale(function: FunctionOfScale, ax: Any, **style: Any) -> Any:
    ax = axes(ax)
    ax.loglog(function.distance, function.value, **style)
    ax.set_xlabel("distance [m]")
    ax.set_ylabel(label(function.quantity, function.units[function.quantity]))
    label_log_axes(ax)
    return ax


def plot_columns(result: Columns, along: str, names: Sequence[str], ax: Any, *, scale: str = "linear", **style: Any) -> Any:
    """Columns against another; a legend names several."""
    missing = [name for name in (along, *names) if name not in result.columns]
    if missing:
        raise InvalidArgument(f"no column '{missing[0]}'; expected one of {', '.join(result.columns)}")
    ax = axes(ax)
    for name in names:
        ax.plot(result.columns[along], result.columns[name], **({"label": name.replace("_", " ")} if len(names) > 1 else {}) | style)
    ax.set(xscale=scale, yscale=scale, xlabel=label(along, result.units[along]), ylabel=label(names[0], result.units[names[0]]))
    if len(names) > 1:
        ax.legend()
    return ax


def plot_energies(scales: dict[str, Any], ax: Any, **style: Any) -> Any:
    """Gained and stored energy against the wavevector up to which waves count."""
    ax = axes(ax)
    for name in ("gained", "stored"):
        ax.plot(scales["wavevector"], [1e3 * value for value in scales[name]], **{"label": name, **style})
    ax.set(xscale="log", xlabel="q = 2π/λ [1/m]", ylabel="energy per area of waves up to q [mJ/m²]")
    ax.legend()
    return ax
