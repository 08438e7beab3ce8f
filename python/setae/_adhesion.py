# SPDX-License-Identifier: GPL-3.0-or-later
"""Work of adhesion on rough surfaces."""

from __future__ import annotations

import html
from typing import Any

from . import _setae
from ._names import renamed
from ._options import Size, Text, filled
from ._quantities import Quantity
from ._results import Answer
from ._scan import Measured, items
from ._spectra import Surface, analysis_of, shared_options


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


@renamed("E", "nu", "gamma", "rough_E", "rough_nu", "longest", "shortest")
def work_of_adhesion(
    surface: Surface | Measured,
    *,
    youngs_modulus: Text,
    W_int: Text,
    surface_energy: Text,
    poisson_ratio: float = 0.5,
    rough_youngs_modulus: Text | None = None,
    rough_poisson_ratio: float = 0.0,
    radius: Text | None = None,
    preload: Text | None = None,
    instrument: str | None = None,
    tip_radius: Text | None = None,
    resolution: Text | None = None,
    trend: str | None = None,
    size: Size | None = None,
    unit: str | None = None,
    keep_values: bool | None = None,
    longest_wavelength: Text | None = None,
    shortest_wavelength: Text | None = None,
    window: str | None = None,
    contours: str | None = None,
    conversion: str | None = None,
    memory: float | None = None,
    bootstrap_resamples: int | None = None,
    skip_failed: bool = False,
) -> WorkOfAdhesion:
    """Apparent work of adhesion of a soft solid on a rough surface.

    The result is that of simulated patches that store U_el/(A W), W = W_int r − γ1 (r − 1). In full contact it is W − U_el/A_app, the
    full-contact balance (Eq. 7), with r = A_true/A_app and U_el/A_app = (E*/8) ∫ q C1D dq [Dalvi et al., PNAS 116 (2019) 25484, Eq. 7 and 8].
    Other theories are in ``["answers"]``. The first argument is a surface of :func:`surface`, or measurements, which are averaged as by
    ``setae adhesion``. Pull-off force and loss of a sphere (radius, preload) are lower bounds. The bounds tend to the values of JKR as the
    roughness tends to zero.

    Parameters
    ----------
    surface : Surface or scan, str, path, array, table or a list of them
        result of `surface`, or measurements, which are averaged
    youngs_modulus : str or Quantity
        Young's modulus of the soft solid, such as "0.7 ± 0.02 MPa"
    W_int : str or Quantity
        intrinsic work of adhesion, such as "37 ± 3.7 mJ/m2"
    surface_energy : str or Quantity
        surface energy of the soft solid, such as "25 mJ/m2"
    poisson_ratio : float, default 0.5
        Poisson ratio of the soft solid, from 0 to 0.5
    rough_youngs_modulus : str or Quantity, optional
        Young's modulus of the rough solid, such as "70 GPa"; default: a rigid solid
    rough_poisson_ratio : float, default 0.0
        Poisson ratio of the rough solid, from 0 to 0.5
    radius : str or Quantity, optional
        radius of a soft sphere that is pressed on and pulled off, given with the preload, such as "1.25 mm"
    preload : str or Quantity, optional
        largest force on the soft sphere, given with the radius, such as "1 mN"
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
    keep_values : bool, optional
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
    WorkOfAdhesion
        W_app of every theory, and the quantities that it depends on

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
    >>> w = setae.work_of_adhesion(rough, youngs_modulus="0.7 MPa", W_int="37 mJ/m2", surface_energy="25 mJ/m2")
    >>> w.conforms, 0.02 < float(w) < 0.037
    (True, True)
    """
    solids = filled(
        _setae.Solids(),
        youngs_modulus=youngs_modulus,
        poisson_ratio=poisson_ratio,
        W_int=W_int,
        surface_energy=surface_energy,
        rough_youngs_modulus=rough_youngs_modulus,
        rough_poisson_ratio=rough_poisson_ratio,
        radius=radius,
        preload=preload,
    )
    solids.require_valid()
    measured: Any = {
        "instrument": instrument, "tip_radius": tip_radius, "resolution": resolution, "trend": trend, "size": size, "unit": unit,
        "keep_values": keep_values,
    }  # fmt: skip
    limits: Any = {
        "longest_wavelength": longest_wavelength, "shortest_wavelength": shortest_wavelength, "window": window, "contours": contours,
        "conversion": conversion, "memory": memory, "bootstrap_resamples": bootstrap_resamples,
    }  # fmt: skip
    if isinstance(surface, Surface):
        given = [name for name, value in {**measured, **limits}.items() if value is not None]
        if given:
            raise TypeError(f"{', '.join(given)}: the surface is analysed already; give this argument to setae.surface")
        return WorkOfAdhesion(_setae.adhesion_of_surface(surface.analysed(), solids))
    shared = shared_options(**measured)
    return WorkOfAdhesion(_setae.adhesion_of_files(items(surface, shared), analysis_of(**limits), solids, not skip_failed))
