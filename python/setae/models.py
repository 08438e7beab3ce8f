# SPDX-License-Identifier: GPL-3.0-or-later
"""Closed-form models of contact as functions of arrays, for plots and for fits with lmfit or SciPy.

Force F [N] (pressing is positive) of a sphere, or of a flat punch, on an elastic half-space or layer, at displacement δ [m] from first contact of
the undeformed bodies; and contact radius a [m] of a sphere under force F. Arrays and plain numbers are in SI. Parameters may also be quantities of
setae or pint, whose standard errors are not propagated. The result has the shape of the first argument.

The value is NaN where no equilibrium exists, such as after pull-off. With ``zero_outside=True`` it is 0, the force of separated bodies.

>>> import numpy
>>> from setae import models
>>> models.hertz(numpy.array([1e-6, 2e-6]), radius=1e-3, contact_modulus=1e6)
array([4.21637021e-05, 1.19256959e-04])

A fit with lmfit, where the force is 0 before contact and after pull-off:

>>> model = lmfit.Model(models.jkr, independent_vars=["displacement"], zero_outside=True)    # doctest: +SKIP
>>> parameters = model.make_params(contact_modulus=1e6, work_of_adhesion=0.05, radius={"value": 1e-3, "vary": False})   # doctest: +SKIP
>>> fit = model.fit(force, parameters, displacement=displacement)                            # doctest: +SKIP
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, Union

import numpy as np

from . import _setae
from ._errors import InvalidArgument
from ._quantities import PintQuantity, Quantity, operand
from ._units import have_one_dimension

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import ArrayLike, NDArray

__all__ = [
    "dmt",
    "dmt_contact_radius",
    "dmt_pull_off",
    "flat_punch",
    "flat_punch_pull_off",
    "hertz",
    "hertz_contact_radius",
    "jkr",
    "jkr_contact_radius",
    "jkr_pull_off",
    "layer",
    "layer_contact_radius",
    "maugis_dugdale",
    "maugis_dugdale_contact_radius",
    "maugis_dugdale_pull_off",
]

#: A parameter: a number in SI, or a quantity of setae or pint.
Number = Union[float, Quantity, PintQuantity]


def hertz(displacement: ArrayLike, radius: Number, contact_modulus: Number, *, zero_outside: bool = False) -> Any:
    """Force F = 4/3 E* √R δ^(3/2) [N] of a sphere without adhesion [Hertz 1881].

    Parameters
    ----------
    displacement : array
        displacement δ [m]
    radius : float or Quantity
        radius R of the sphere [m]
    contact_modulus : float or Quantity
        contact modulus E* [Pa]
    zero_outside : bool, default False
        0 in place of NaN for δ < 0, where the bodies do not touch

    Returns
    -------
    float or array
        force in N, in the shape of the first argument

    Raises
    ------
    InvalidArgument
        for a parameter with another dimension, or outside its domain

    Examples
    --------
    >>> round(float(hertz(1e-6, 1e-3, 1e6) / (4 / 3 * 1e6 * 1e-3**0.5 * 1e-6**1.5)), 12)
    1.0
    """
    return values(_setae.hertz_force, displacement, zero_outside, length(radius), pressure(contact_modulus))


def hertz_contact_radius(force: ArrayLike, radius: Number, contact_modulus: Number, *, zero_outside: bool = False) -> Any:
    """Contact radius a = (3RF/4E*)^(1/3) [m] of a sphere without adhesion under force F [N]; parameters as for :func:`hertz`.

    Returns
    -------
    float or array
        contact radius in m, in the shape of the first argument

    Raises
    ------
    InvalidArgument
        for a parameter with another dimension, or outside its domain

    Examples
    --------
    >>> round(float(hertz_contact_radius(4e-3 / 3, 1e-3, 1e6)), 9)
    0.0001
    """
    return values(_setae.hertz_contact_radius, force, zero_outside, length(radius), pressure(contact_modulus))


def dmt(displacement: ArrayLike, radius: Number, contact_modulus: Number, work_of_adhesion: Number, *, zero_outside: bool = False) -> Any:
    """Force F = 4/3 E* √R δ^(3/2) − 2πRW [N] of a sphere with adhesion of long range [Derjaguin, Muller, Toporov 1975].

    Parameters
    ----------
    displacement : array
        displacement δ [m]
    radius : float or Quantity
        radius R of the sphere [m]
    contact_modulus : float or Quantity
        contact modulus E* [Pa]
    work_of_adhesion : float or Quantity
        work of adhesion W [J/m²]
    zero_outside : bool, default False
        0 in place of NaN for δ < 0, where the bodies do not touch

    Returns
    -------
    float or array
        force in N, in the shape of the first argument

    Raises
    ------
    InvalidArgument
        for a parameter with another dimension, or outside its domain

    Examples
    --------
    >>> float(dmt(0.0, 1e-3, 1e6, 0.05) / dmt_pull_off(1e-3, 0.05))
    1.0
    """
    return values(_setae.dmt_force, displacement, zero_outside, length(radius), pressure(contact_modulus), energy(work_of_adhesion))


def dmt_contact_radius(force: ArrayLike, radius: Number, contact_modulus: Number, work_of_adhesion: Number, *, zero_outside: bool = False) -> Any:
    """Contact radius a = (3R(F + 2πRW)/4E*)^(1/3) [m] under force F [N]; parameters as for :func:`dmt`.

    Returns
    -------
    float or array
        contact radius in m, in the shape of the first argument

    Raises
    ------
    InvalidArgument
        for a parameter with another dimension, or outside its domain

    Examples
    --------
    >>> float(dmt_contact_radius(dmt_pull_off(1e-3, 0.05), 1e-3, 1e6, 0.05))
    0.0
    """
    return values(_setae.dmt_contact_radius, force, zero_outside, length(radius), pressure(contact_modulus), energy(work_of_adhesion))


def dmt_pull_off(radius: Number, work_of_adhesion: Number) -> float:
    """Force −2πRW [N] at which a sphere separates; parameters as for :func:`dmt`.

    Returns
    -------
    float
        force in N

    Raises
    ------
    InvalidArgument
        for a parameter with another dimension, or outside its domain

    Examples
    --------
    >>> round(dmt_pull_off(1e-3, 0.05) / (-2 * math.pi * 1e-3 * 0.05), 12)
    1.0
    """
    return -2.0 * math.pi * length(radius) * energy(work_of_adhesion)


def jkr(displacement: ArrayLike, radius: Number, contact_modulus: Number, work_of_adhesion: Number, *, branch: str = "outer",
        zero_outside: bool = False) -> Any:
    """Force [N] of a sphere with adhesion of infinitely short range [Johnson, Kendall, Roberts 1971].

    F = 4E*a³/(3R) − √(8πE*W a³) and δ = a²/R − √(2πaW/E*), with the contact radius a that belongs to δ.

    Parameters
    ----------
    displacement : array
        displacement δ [m]
    radius : float or Quantity
        radius R of the sphere [m]
    contact_modulus : float or Quantity
        contact modulus E* [Pa]
    work_of_adhesion : float or Quantity
        work of adhesion W [J/m²]
    branch : str, default 'outer'
        equilibrium where there are two: 'outer', the stable one with the larger contact radius, or 'inner'
    zero_outside : bool, default False
        0 in place of NaN where no equilibrium exists, after pull-off

    Returns
    -------
    float or array
        force in N, in the shape of the first argument

    Raises
    ------
    InvalidArgument
        for a parameter with another dimension, or outside its domain

    Examples
    --------
    >>> round(float(jkr(0.0, 1e-3, 1e6, 0.05)) / (-4 / 3 * math.pi * 1e-3 * 0.05), 9)
    1.0
    """
    return values(_setae.jkr_force, displacement, zero_outside, length(radius), pressure(contact_modulus), energy(work_of_adhesion), inner(branch))


def jkr_contact_radius(force: ArrayLike, radius: Number, contact_modulus: Number, work_of_adhesion: Number, *, branch: str = "outer",
                       zero_outside: bool = False) -> Any:
    """Contact radius a³ = (3R/4E*) (√P + √(F + P))², P = 3/2 πRW, under force F [N]; parameters as for :func:`jkr`.

    Returns
    -------
    float or array
        contact radius in m, in the shape of the first argument

    Raises
    ------
    InvalidArgument
        for a parameter with another dimension, or outside its domain

    Examples
    --------
    >>> a = float(jkr_contact_radius(0.0, 1e-3, 1e6, 0.05))
    >>> round(a**3 / (4.5 * math.pi * 0.05 * 1e-6 / 1e6), 9)
    1.0
    """
    return values(_setae.jkr_contact_radius, force, zero_outside, length(radius), pressure(contact_modulus), energy(work_of_adhesion), inner(branch))


def jkr_pull_off(radius: Number, work_of_adhesion: Number, *, control: str = "fixed_load") -> float:
    """Force [N] at which a sphere separates: −3/2 πRW under a dead load, −5/6 πRW in an infinitely stiff machine.

    Parameters
    ----------
    radius : float or Quantity
        radius R of the sphere [m]
    work_of_adhesion : float or Quantity
        work of adhesion W [J/m²]
    control : str, default 'fixed_load'
        controlled quantity: 'fixed_load' or 'fixed_grips'

    Returns
    -------
    float
        force in N

    Raises
    ------
    InvalidArgument
        for a parameter with another dimension, or outside its domain

    Examples
    --------
    >>> round(jkr_pull_off(1e-3, 0.05) / (math.pi * 1e-3 * 0.05), 12)
    -1.5
    """
    factors = {"fixed_load": -1.5, "fixed_grips": -5.0 / 6.0}
    if control not in factors:
        raise InvalidArgument(f"control: '{control}'; expected one of {', '.join(factors)}")
    return factors[control] * math.pi * length(radius) * energy(work_of_adhesion)


def maugis_dugdale(displacement: ArrayLike, radius: Number, contact_modulus: Number, work_of_adhesion: Number, cohesive_stress: Number, *,
                   branch: str = "outer", zero_outside: bool = False) -> Any:
    """Force [N] of a sphere with adhesion of any range: a constant attraction σ0 up to the gap W/σ0 [Maugis 1992].

    The limits are :func:`dmt` for small and :func:`jkr` for large λ = 2σ0 (R/(πWK²))^(1/3), K = 4E*/3.

    Parameters
    ----------
    displacement : array
        displacement δ [m]
    radius : float or Quantity
        radius R of the sphere [m]
    contact_modulus : float or Quantity
        contact modulus E* [Pa]
    work_of_adhesion : float or Quantity
        work of adhesion W [J/m²], above 0
    cohesive_stress : float or Quantity
        attraction σ0 [Pa]
    branch : str, default 'outer'
        equilibrium where there are two: 'outer' or 'inner'
    zero_outside : bool, default False
        0 in place of NaN where no equilibrium exists

    Returns
    -------
    float or array
        force in N, in the shape of the first argument

    Raises
    ------
    InvalidArgument
        for a parameter with another dimension, or outside its domain

    Examples
    --------
    >>> jkr_like = maugis_dugdale(1e-6, 1e-3, 1e6, 0.05, 1e9)
    >>> bool(abs(jkr_like / jkr(1e-6, 1e-3, 1e6, 0.05) - 1) < 1e-3)
    True
    """
    return values(_setae.maugis_dugdale_force, displacement, zero_outside, length(radius), pressure(contact_modulus), energy(work_of_adhesion),
                  pressure(cohesive_stress, "cohesive_stress"), inner(branch))


def maugis_dugdale_contact_radius(force: ArrayLike, radius: Number, contact_modulus: Number, work_of_adhesion: Number, cohesive_stress: Number, *,
                                  branch: str = "outer", zero_outside: bool = False) -> Any:
    """Contact radius [m] under force F [N]; parameters as for :func:`maugis_dugdale`.

    Returns
    -------
    float or array
        contact radius in m, in the shape of the first argument

    Raises
    ------
    InvalidArgument
        for a parameter with another dimension, or outside its domain

    Examples
    --------
    >>> bool(maugis_dugdale_contact_radius(0.0, 1e-3, 1e6, 0.05, 1e9) > 0)
    True
    """
    return values(_setae.maugis_dugdale_contact_radius, force, zero_outside, length(radius), pressure(contact_modulus), energy(work_of_adhesion),
                  pressure(cohesive_stress, "cohesive_stress"), inner(branch))


def maugis_dugdale_pull_off(radius: Number, contact_modulus: Number, work_of_adhesion: Number, cohesive_stress: Number) -> float:
    """Force [N] at which a sphere separates under a dead load, between −2πRW (DMT) and −3/2 πRW (JKR); parameters as for :func:`maugis_dugdale`.

    Returns
    -------
    float
        force in N

    Raises
    ------
    InvalidArgument
        for a parameter with another dimension, or outside its domain

    Examples
    --------
    >>> -2.0 < maugis_dugdale_pull_off(1e-3, 1e6, 0.05, 1e4) / (math.pi * 1e-3 * 0.05) < -1.5
    True
    """
    found: float = _setae.maugis_dugdale_pull_off(length(radius), pressure(contact_modulus), energy(work_of_adhesion),
                                                  pressure(cohesive_stress, "cohesive_stress"))
    return found


def layer(displacement: ArrayLike, radius: Number, contact_modulus: Number, work_of_adhesion: Number, thickness: Number, poisson_ratio: float, *,
          branch: str = "outer", zero_outside: bool = False) -> Any:
    """Force [N] of a rigid sphere with adhesion of short range on an elastic layer that is bonded to a rigid base.

    The solution of the layer is exact for contact radii up to five times the thickness; the limit of a thick layer is :func:`jkr`.

    Parameters
    ----------
    displacement : array
        displacement δ [m]
    radius : float or Quantity
        radius R of the sphere [m]
    contact_modulus : float or Quantity
        contact modulus E/(1 − ν²) of the layer [Pa]
    work_of_adhesion : float or Quantity
        work of adhesion W [J/m²]; 0: without adhesion
    thickness : float or Quantity
        thickness of the layer [m]
    poisson_ratio : float
        Poisson ratio ν of the layer, up to 0.5
    branch : str, default 'outer'
        equilibrium where there are two: 'outer' or 'inner'
    zero_outside : bool, default False
        0 in place of NaN where no equilibrium exists

    Returns
    -------
    float or array
        force in N, in the shape of the first argument

    Raises
    ------
    InvalidArgument
        for a parameter with another dimension, or outside its domain

    Examples
    --------
    >>> bool(abs(layer(1e-6, 1e-3, 1e6, 0.05, 1.0, 0.5) / jkr(1e-6, 1e-3, 1e6, 0.05) - 1) < 1e-3)
    True
    """
    return values(_setae.layer_force, displacement, zero_outside, length(radius), pressure(contact_modulus), energy(work_of_adhesion),
                  length(thickness, "thickness"), ratio(poisson_ratio), inner(branch))


def layer_contact_radius(force: ArrayLike, radius: Number, contact_modulus: Number, work_of_adhesion: Number, thickness: Number,
                         poisson_ratio: float, *, branch: str = "outer", zero_outside: bool = False) -> Any:
    """Contact radius [m] on a layer under force F [N]; parameters as for :func:`layer`.

    Returns
    -------
    float or array
        contact radius in m, in the shape of the first argument

    Raises
    ------
    InvalidArgument
        for a parameter with another dimension, or outside its domain

    Examples
    --------
    >>> thin = layer_contact_radius(1e-3, 1e-3, 1e6, 0.0, 1e-4, 0.5)
    >>> bool(thin < hertz_contact_radius(1e-3, 1e-3, 1e6))
    True
    """
    return values(_setae.layer_contact_radius, force, zero_outside, length(radius), pressure(contact_modulus), energy(work_of_adhesion),
                  length(thickness, "thickness"), ratio(poisson_ratio), inner(branch))


def flat_punch(displacement: ArrayLike, radius: Number, contact_modulus: Number, work_of_adhesion: Number, *, zero_outside: bool = False) -> Any:
    """Force F = 2E*aδ [N] of a flat circular punch that adheres until F = −√(8πE*W a³) [Kendall 1971].

    Parameters
    ----------
    displacement : array
        displacement δ [m]
    radius : float or Quantity
        radius a of the punch [m]
    contact_modulus : float or Quantity
        contact modulus E* [Pa]
    work_of_adhesion : float or Quantity
        work of adhesion W [J/m²]; 0: without adhesion
    zero_outside : bool, default False
        0 in place of NaN after pull-off

    Returns
    -------
    float or array
        force in N, in the shape of the first argument

    Raises
    ------
    InvalidArgument
        for a parameter with another dimension, or outside its domain

    Examples
    --------
    >>> float(flat_punch(1e-6, 1e-3, 1e6, 0.0))
    0.002
    """
    a, modulus = length(radius), pressure(contact_modulus)
    array = np.asarray(displacement, dtype=np.float64)
    force = 2.0 * modulus * a * array
    outside = force < flat_punch_pull_off(a, modulus, work_of_adhesion) * (1.0 + 1e-12)
    return np.where(outside, 0.0 if zero_outside else np.nan, force)[()]


def flat_punch_pull_off(radius: Number, contact_modulus: Number, work_of_adhesion: Number) -> float:
    """Force −√(8πE*W a³) [N] at which a flat punch separates; parameters as for :func:`flat_punch`.

    Returns
    -------
    float
        force in N

    Raises
    ------
    InvalidArgument
        for a parameter with another dimension, or outside its domain

    Examples
    --------
    >>> round(flat_punch_pull_off(1e-3, 1e6, 0.05), 6)
    -0.035449
    """
    return -math.sqrt(8.0 * math.pi * pressure(contact_modulus) * energy(work_of_adhesion) * length(radius) ** 3)


def values(function: Callable[..., Any], first: ArrayLike, zero_outside: bool, *parameters: float | bool) -> Any:
    """A function of the library for every element of an array, in the shape of the array."""
    array = np.asarray(first, dtype=np.float64)
    found: NDArray[np.float64] = function(np.ascontiguousarray(array).reshape(-1), *parameters)
    if zero_outside:
        found = np.nan_to_num(found, copy=False, nan=0.0)
    return found.reshape(array.shape)[()]


def si(value: Number, argument: str, unit: str) -> float:
    """A parameter in SI."""
    if isinstance(value, (int, float)):
        return float(value)
    quantity = operand(value)
    if quantity is None:
        raise TypeError(f"{argument}: {type(value).__name__}; expected a number in {unit}, or a quantity")
    if not isinstance(value, np.generic) and not have_one_dimension(quantity.unit, unit):
        raise InvalidArgument(f"{argument}: {quantity} has another dimension; expected a quantity in {unit}")
    return quantity._in_si()


def length(value: Number, argument: str = "radius") -> float:
    return si(value, argument, "m")


def pressure(value: Number, argument: str = "contact_modulus") -> float:
    return si(value, argument, "Pa")


def energy(value: Number) -> float:
    return si(value, "work_of_adhesion", "J/m2")


def ratio(value: Number) -> float:
    return si(value, "poisson_ratio", "1")


def inner(branch: str) -> bool:
    if branch not in ("outer", "inner"):
        raise InvalidArgument(f"branch: '{branch}'; expected one of outer, inner")
    return branch == "inner"
