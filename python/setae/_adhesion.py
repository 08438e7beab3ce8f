# SPDX-License-Identifier: GPL-3.0-or-later
"""Work of adhesion on rough surfaces."""

from __future__ import annotations

import html
from typing import Any

from . import _setae
from ._options import Text, filled, require_known
from ._quantities import Quantity
from ._results import Answer
from ._scan import Measured, items
from ._spectra import ANALYSIS, Surface, analysis_of, shared_options


class WorkOfAdhesion(Answer):
    """W_app and the quantities that it depends on, as printed by ``setae adhesion --json``. ``float()`` is W_app without load [J/m²].

    ``w["answers"]``: W_app of each theory, with its assumptions.  ``w["work_of_adhesion_modified"]``, ``w["stored_energy"]``,
    ``w["true_area_ratio"]`` … by the names of the JSON.  ``w["scales"]``: energy that waves of each scale gain and store.
    """

    @property
    def estimate(self) -> Quantity:
        """W_app of contact without load by the recommended theory, the same in every command."""
        found: Quantity = self["work_of_adhesion"]
        return found

    def __float__(self) -> float:
        return self.estimate.value

    @property
    def conforms(self) -> bool:
        """Whether full contact forms spontaneously."""
        return bool(self["conforms"])

    def plot(self, ax: Any = None, **style: Any) -> Any:
        """Plots the energies that waves up to each wavevector gain and store on axes of matplotlib."""
        from ._plot import plot_energies

        return plot_energies(self._data["scales"], ax, **style)

    def __repr__(self) -> str:
        return f"WorkOfAdhesion(W_app = {self.estimate}{'' if self.conforms else ', ' + str(self['contact'])})"

    def _repr_html_(self) -> str:
        return f"<b>{html.escape(str(self.estimate))}</b>{super()._repr_html_()}"


def work_of_adhesion(
    surface: Surface | Measured,
    *,
    E: Text,
    W_int: Text,
    gamma: Text,
    nu: float = 0.5,
    rough_E: Text | None = None,
    rough_nu: float = 0.0,
    radius: Text | None = None,
    preload: Text | None = None,
    skip_failed: bool = False,
    **measurement: Any,
) -> WorkOfAdhesion:
    """Apparent work of adhesion of a soft solid on a rough surface.

    The result is that of simulated patches that store U_el/(A W), W = W_int r − γ1 (r − 1). In full contact it is W − U_el/A_app, the
    full-contact balance (Eq. 7), with r = A_true/A_app and U_el/A_app = (E*/8) ∫ q C1D dq [Dalvi et al., PNAS 116 (2019) 25484, Eq. 7 and 8].
    Other theories are in ``["answers"]``. The first argument is a surface of :func:`surface`, or measurements, which are averaged as by
    ``setae adhesion``. Pull-off force and loss of a sphere (radius, preload) are lower bounds. The bounds tend to the values of JKR as the
    roughness tends to zero.

    Parameters
    ----------
    E : str or Quantity
        Young's modulus of the soft solid, such as "0.7 ± 0.02 MPa"
    W_int : str or Quantity
        intrinsic work of adhesion, such as "37 ± 3.7 mJ/m2"
    gamma : str or Quantity
        surface energy of the soft solid, such as "25 mJ/m2"
    nu : float, default 0.5
        Poisson ratio of the soft solid, from 0 to 0.5
    rough_E : str or Quantity
        Young's modulus of the rough solid, such as "70 GPa"; default: a rigid solid
    rough_nu : float, default 0.0
        Poisson ratio of the rough solid, from 0 to 0.5
    radius : str or Quantity
        radius of a soft sphere that is pressed on and pulled off, given with the preload, such as "1.25 mm"
    preload : str or Quantity
        largest force on the soft sphere, given with the radius, such as "1 mN"
    skip_failed : bool, default False
        measurements that cannot be analysed are left out with a warning
    **measurement
        keywords of measurements, as those of `parameters`
    """
    solids = filled(
        _setae.Solids(),
        E=E,
        nu=nu,
        W_int=W_int,
        gamma=gamma,
        rough_E=rough_E,
        rough_nu=rough_nu,
        radius=radius,
        preload=preload,
    )
    solids.require_valid()
    if isinstance(surface, Surface):
        if measurement:
            raise TypeError(f"{', '.join(measurement)}: the surface is analysed already; give this argument to setae.surface")
        return WorkOfAdhesion(_setae.adhesion_of_surface(surface.analysed(), solids))
    names = ("instrument", "tip_radius", "resolution", "trend", "size", "unit", "keep_values")
    require_known(measurement, (*names, *ANALYSIS))
    shared = shared_options(*(measurement.pop(name, None) for name in names))
    return WorkOfAdhesion(_setae.adhesion_of_files(items(surface, shared), analysis_of(**measurement), solids, not skip_failed))
