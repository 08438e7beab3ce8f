# SPDX-License-Identifier: GPL-3.0-or-later
"""Measured points of fits, the model at these points, and residuals; their plots."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from ._columns import Columns
from ._errors import InvalidArgument
from ._plot import axes, label, label_log_axes

if TYPE_CHECKING:
    from ._columns import Array

UNITS = {"force": "N", "displacement": "m", "contact_radius": "m", "time": "s", "wavevector": "1/m", "C1D": "m3"}
#: Channel of the residuals of a route of JKR, by the unit of the residuals.
CHANNELS = {
    "radius_force": {"m": "contact_radius"},
    "radius_force_effective_variance": {"N": "force"},
    "linear_form": {"N/m^1.5": "force"},
    "force_displacement": {"m": "displacement"},
    "force_displacement_held_contact_point": {"N": "force"},
    "joint": {"N": "force"},
}


@dataclass(frozen=True, eq=False, repr=False)
class Fitted(Columns):
    """Points of a fit: the columns ``x`` and ``y`` as measured, "best_fit", the model of y at these points, and "residuals".

    ``record``: the whole measurement, of which the fit uses a part.
    """

    x: str = ""  #: name of the column of abscissae, such as "force"
    y: str = ""  #: name of the fitted column, such as "contact_radius"
    record: dict[str, Array] = field(default_factory=dict, repr=False)
    logarithmic: bool = False

    @property
    def best_fit(self) -> Array:
        """The model at the measured points."""
        return self.columns["best_fit"]

    @property
    def residuals(self) -> Array:
        """Measured minus fitted values; of spectra the signed roots of the deviances."""
        return self.columns["residuals"]

    @property
    def n(self) -> int:
        """Number of fitted points."""
        return len(self.best_fit)

    def __repr__(self) -> str:
        return f"Fitted({self.y} against {self.x}, {self.n} points)"

    def plot(self, ax: Any = None, **style: Any) -> Any:
        """Plots the record, the fitted points and the model, and the residuals below. The fitted range is shaded. ``style``: of the points."""
        return plot_fitted(self, ax, **style)


def fitted(x: str, y: str, measured: Mapping[str, Array], residuals: Array, *, record: Mapping[str, Array] | None = None,
           best_fit: Array | None = None, logarithmic: bool = False) -> Fitted:
    """A fit with the residuals of ``y``. Without ``best_fit`` they are measured minus fitted values."""
    best = measured[y] - residuals if best_fit is None else best_fit
    columns = {x: measured[x], y: measured[y], "best_fit": best, "residuals": residuals}
    units = {x: UNITS[x], y: UNITS[y], "best_fit": UNITS[y], "residuals": UNITS[y] if best_fit is None else "1"}
    text: Callable[[], str] = lambda: json.dumps({**{name: list(map(float, values)) for name, values in columns.items()}, "units": units})
    return Fitted(columns, units, text, x, y, dict(record or {}), logarithmic)


def loop_curve(fit: Mapping[str, Any], samples: Mapping[str, Mapping[str, Array]], branch: str, route: str | None) -> Fitted:
    """A route of JKR on a branch of a loop."""
    if branch not in ("loading", "unloading"):
        raise InvalidArgument(f"branch: '{branch}'; expected loading or unloading")
    if fit[branch] is None:
        raise InvalidArgument(f"the loop has no fit of the branch '{branch}'; fit['{branch}_reason'] states the reason")
    routes = {name: found for name, found in fit[branch]["fits"].items() if found and "residuals" in found}
    if route is not None and route not in routes:
        raise InvalidArgument(f"route: '{route}'; expected one of {', '.join(routes)}")
    method = fit[branch]["method"]
    found = routes[route] if route else next(one for one in routes.values() if one["method"] == method)
    channel = CHANNELS[found["method"]][found["rms_residual"]["unit"]]
    residuals = np.asarray(found["residuals"], dtype=float)
    points = every(samples[branch], found.get("residuals_every", 1))
    if found["method"] == "linear_form":
        residuals = residuals * np.sqrt(6.0 * np.pi * points["contact_radius"] ** 3)
    return fitted(abscissa(channel, found["method"]), channel, points, residuals, record=samples["record"])


def model_curve(fit: Mapping[str, Any], samples: Mapping[str, Mapping[str, Array]], model: str) -> Fitted:
    """An additional model, fitted to the branch that was requested."""
    models = fit.get("models") or {}
    compared = (models.get("comparison") or {}).get("models", ())
    known = {one["model"]: one for one in [*models.get("fits", ()), *compared] if "force_residuals" in one}
    if model not in known:
        raise InvalidArgument(f"model: '{model}'; expected one of {', '.join(known)}" if known else
                              f"model: '{model}' was not fitted; expected fit(models=['{model}'])")
    found = known[model]
    residuals = np.asarray(found["force_residuals"]["values"], dtype=float)
    points = next((samples[b] for b in ("loading", "unloading") if len(samples[b].get("force", ())) == len(residuals)), None)
    if points is None:
        raise InvalidArgument(f"model: '{model}' has {len(residuals)} residuals, but no branch has as many points")
    x = "displacement" if "displacement" in found["channels"] else "contact_radius"
    return fitted(x, "force", points, residuals, record=samples["record"])


def abscissa(channel: str, method: str) -> str:
    if channel != "force":
        return "force"
    return "displacement" if method in ("joint", "force_displacement_held_contact_point") else "contact_radius"


def every(columns: Mapping[str, Array], step: int) -> dict[str, Array]:
    """Every n-th sample, as long columns of the JSON have them."""
    return {name: values[::step] for name, values in columns.items()}


def curve_of_segment(segment: Mapping[str, Array]) -> Fitted:
    """A segment of a force curve, whose samples outside the fit have no value of the model."""
    used = np.isfinite(segment["best_fit"])
    measured = {name: segment[name][used] for name in ("displacement", "force")}
    return fitted("displacement", "force", measured, measured["force"] - segment["best_fit"][used], record=segment)


class SpectrumFit(dict[str, Any]):
    """Parameters of a self-affine fit by name, the model at the fitted wavevectors, and residuals."""

    def __init__(self, parameters: Mapping[str, Any], values: Mapping[str, Array], record: Mapping[str, Array]) -> None:
        super().__init__(parameters)
        self._values, self._record = dict(values), dict(record)

    @property
    def points(self) -> Fitted:
        """The fitted values with the model at their wavevectors."""
        if not self._values:
            raise InvalidArgument("the spectrum has no fit; expected power_spectrum(…, fit=True)")
        values = self._values
        return fitted("wavevector", "C1D", values, values["residuals"], record=self._record, best_fit=values["best_fit"], logarithmic=True)

    @property
    def q(self) -> Array:
        """Wavevectors of the fitted values [1/m]."""
        return self.points.columns["wavevector"]

    @property
    def best_fit(self) -> Array:
        """C1D of the model [m³] at the fitted wavevectors, with window and aliases as far as the fit includes them."""
        return self.points.best_fit

    @property
    def residuals(self) -> Array:
        """Signed root of the deviance of each value: about normal with variance 1 if the model is correct."""
        return self.points.residuals

    def plot(self, ax: Any = None, **style: Any) -> Any:
        """Plots the spectrum, the model and the residuals below. The fitted range is shaded. ``style``: keywords of matplotlib for the points."""
        return self.points.plot(ax, **style)


def plot_fitted(points: Fitted, ax: Any, **style: Any) -> Any:
    """Measurement and model with a panel of residuals below; returns the axes of the measurement."""
    from mpl_toolkits.axes_grid1 import make_axes_locatable

    ax = axes(ax)
    below = make_axes_locatable(ax).append_axes("bottom", size="30%", pad=0.1, sharex=ax)
    (factor_x, unit_x), (factor_y, unit_y) = (shown_in(points.columns[name], points.units[name], points.logarithmic) for name in (points.x, points.y))
    x, order = factor_x * points.columns[points.x], np.argsort(points.columns[points.x], kind="stable")
    ax.plot(x, factor_y * points.columns[points.y], **{"linestyle": "none", "marker": ".", "markersize": 3, "label": "fitted points", **style})
    if points.x in points.record and points.y in points.record:
        ax.plot(factor_x * points.record[points.x], factor_y * points.record[points.y], color="0.7", linewidth=0.8, label="record", zorder=1)
    ax.plot(x[order], factor_y * points.best_fit[order], color="C1", label="best fit", zorder=3)
    factor, unit = shown_in(points.residuals, points.units["residuals"], points.logarithmic)
    below.plot(x, factor * points.residuals, linestyle="none", marker=".", markersize=3, color="0.3")
    below.axhline(0.0, color="C1")
    for panel in (ax, below):
        panel.axvspan(x.min(), x.max(), color="C0", alpha=0.08, linewidth=0, zorder=0)
    if points.logarithmic:
        ax.set(xscale="log", yscale="log")
        label_log_axes(ax)
    ax.tick_params(labelbottom=False)
    ax.set_ylabel(label(points.y, unit_y) if points.y != "C1D" else "C$_{1D}$ [m³]")
    below.set_xlabel(label(points.x, unit_x) if points.x != "wavevector" else "q = 2π/λ [1/m]")
    below.set_ylabel(label("residual", unit))
    ax.legend()
    return ax


def shown_in(values: Array, unit: str, logarithmic: bool) -> tuple[float, str]:
    """Factor and unit in which the largest value has one to three digits before the point.

    >>> shown_in(np.array([0.0, 2.5e-6]), "m", False)
    (1000000.0, 'µm')
    """
    largest = float(np.nanmax(np.abs(values)))
    if logarithmic or not 1e-12 <= largest < 1e3:
        return 1.0, unit
    power = min(-3 * int(np.floor(np.log10(largest) / 3.0)), 12)
    return (10.0**power, {3: "m", 6: "µ", 9: "n", 12: "p"}[power] + unit) if power > 0 else (1.0, unit)

