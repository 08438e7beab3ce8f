# SPDX-License-Identifier: GPL-3.0-or-later
"""Several loops in one fit, and force curves of several files or tables."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from . import _setae
from ._errors import InvalidArgument
from ._laboratory import ForceCurves, force_curves
from ._loops import Loop, checked_bodies
from ._options import Text, filled, texts
from ._quantities import Quantity
from ._results import Answer, row_of

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._generated import LoopSettings


class SharedFit(Answer):
    """Several loops in one fit, as printed by ``setae jkr fit --share --json``: ``fit["shared"]``, and ``fit["loops"]`` with the fits of each."""

    tables = ("loops",)

    @property
    def quantities(self) -> tuple[Quantity, ...]:
        """The shared parameters."""
        shared: Answer = self["shared"]
        return shared.quantities

    @property
    def p_value(self) -> float:
        """Probability of the F ratio if the loops share the parameters; small where they differ."""
        return float(self._data["shared"]["sharing_test"]["p_value"])

    def to_pandas(self) -> Any:
        """As a DataFrame of pandas: one row per loop with E* and W in the shared fit."""
        import pandas

        loops = self._data["shared"]["loops"]
        parts = ("contact_modulus", "work_of_adhesion")
        rows = [{"loop": loop["name"], "n": loop["n"], **{name: loop[name]["value"] for name in parts if loop.get(name)},
                 **{f"{name}_standard_error": loop[name].get("standard_error") for name in parts if loop.get(name)}} for loop in loops]
        frame = pandas.DataFrame(rows)
        frame.attrs["units"] = {"contact_modulus": "Pa", "work_of_adhesion": "J/m2"}
        return frame


def fit_together(
    loops: Sequence[Loop],
    *,
    share: Sequence[str] | str = "modulus",
    model: str | None = None,
    branch: str = "loading",
    errors: str = "orthogonal_distance",
    model_contact_point: Text | None = None,
    cohesive_stress: Text | None = None,
    **settings: Unpack[LoopSettings],
) -> SharedFit:
    """Several loops in one fit with a common E*, a common W, or both, and a test of whether the loops share them.

    Each loop has its own bodies, noise and contact point. ``settings`` are those of :meth:`Loop.fit`.

    Parameters
    ----------
    loops : Sequence[Loop]
        two loops or more
    share : Sequence[str] or str, default 'modulus'
        quantity that all loops have in common in one fit; modulus, work or both; one of modulus, work
    model : str, optional
        contact model, such as 'dmt'; default: jkr
    branch : str, default 'loading'
        branch of additional models, profile likelihood and common fits; one of loading, unloading
    errors : str, default 'orthogonal_distance'
        treatment of measurement errors in additional models and common fits; one of effective_variance, orthogonal_distance, force_only
    model_contact_point : str or Quantity, optional
        contact point that is held fixed in additional models, such as "1.2 um"; default: fitted
    cohesive_stress : str or Quantity, optional
        cohesive stress that is held fixed in the model maugis_dugdale, such as "5 MPa"; default: fitted

    Returns
    -------
    SharedFit
        the shared parameters, the test of sharing, and the fit of each loop

    Raises
    ------
    InvalidArgument
        for one loop, a loop without the branch or without a radius, or a value outside its domain

    Examples
    --------
    >>> import numpy as np
    >>> import setae
    >>> random, depth = np.random.default_rng(1), np.linspace(-10e-6, 20e-6, 200)
    >>> def tested(work_of_adhesion):
    ...     retraction = setae.models.jkr(depth[::-1], 1e-3, 1e6, work_of_adhesion, zero_outside=True)
    ...     force = np.append(np.where(depth < 0.0, 0.0, retraction[::-1]), retraction) + 1e-7 * random.standard_normal(400)
    ...     return setae.loop({"force [N]": force, "displacement [m]": np.append(depth, depth[::-1])}, radius="1 mm")
    >>> together = setae.fit_together([tested(0.04), tested(0.05)])
    >>> together.quantities[0].symbol
    'E*'
    """
    if isinstance(loops, Loop) or len(loops) < 2:
        raise InvalidArgument("loops: one loop; expected a list of two or more, or loop.fit() for one")
    wanted = filled(
        _setae.LoopModels(),
        share=texts(share),
        models=[model] if model else None,
        branch=branch,
        errors=errors,
        model_contact_point=model_contact_point,
        cohesive_stress=cohesive_stress,
    )
    given = [(loop._opened, checked_bodies(dict(loop.bodies))) for loop in loops]
    return SharedFit(_setae.fit_loops(given, filled(_setae.LoopSettings(), **settings), wanted))


class ForceCurveSeries(tuple[ForceCurves, ...]):
    """Fits of several force curves, one after the other: ``series[0]``, ``for fit in series``."""

    def json(self) -> str:
        """The bytes that ``setae jkr fit CURVE CURVE --json`` prints."""
        listed = ",\n".join("  " + fit.json().rstrip().replace("\n", "\n  ") for fit in self)
        return f"[\n{listed}\n]\n" if self else "[]\n"

    def to_pandas(self) -> Any:
        """As a DataFrame of pandas: one row per curve and quantity."""
        import pandas

        return pandas.DataFrame([{"file": fit.data.get("file"), **row_of(quantity)} for fit in self for quantity in fit.quantities])

    def __repr__(self) -> str:
        return f"ForceCurveSeries({len(self)} curves)"


def force_curve_series(curves: Sequence[Any], **arguments: Any) -> ForceCurveSeries:
    """Fits of several force curves, with arguments as for :func:`force_curves`.

    Parameters
    ----------
    curves : Sequence[object]
        paths of files, loops, or tables in memory

    Returns
    -------
    ForceCurveSeries
        fits in the order of the curves

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
    >>> import numpy as np
    >>> import setae
    >>> displacement = np.linspace(-1e-6, 0.5e-6, 120)
    >>> curve = {"force [N]": setae.models.hertz(displacement, 5e-6, 10e3, zero_outside=True), "displacement [m]": displacement}
    >>> setae.force_curve_series([curve, curve], radius="5 um")
    ForceCurveSeries(2 curves)
    """
    return ForceCurveSeries(force_curves(curve, **arguments) for curve in curves)
