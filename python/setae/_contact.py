# SPDX-License-Identifier: GPL-3.0-or-later
"""Contact of rough surfaces with an elastic body, without and with adhesion, and Persson's theory."""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from . import _setae
from ._columns import Columns, Named, edge_of
from ._errors import InvalidArgument
from ._options import Path, Size, Text, filled, path, require
from ._quantities import Quantity, quantity_from
from ._results import Answer
from ._scan import Measured, items
from ._spectra import analysis_of, shared_options
from ._synthesis import one

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from ._columns import Array


@dataclass(frozen=True, repr=False)
class Contact(Answer):
    """A rigid rough surface pressed on an elastic body, as printed by ``setae contact solve --json``.

    ``pressures`` [Pa], negative for tension, and ``gaps`` [m] are maps with the first index x; a line gives one row.
    """

    pressures: Array = field(compare=False)
    gaps: Array = field(compare=False)
    measured: tuple[Quantity, ...] = field(default=(), compare=False)

    @property
    def quantities(self) -> tuple[Quantity, ...]:
        return self.measured

    @property
    def converged(self) -> bool:
        return bool(self["status"] == "converged")

    def to_xarray(self) -> Any:
        """Pressures and gaps as a Dataset of xarray with coordinates in metres."""
        return maps_dataset(self.pressures, self.gaps, self._data["size"])

    def plot(self, ax: Any = None, *, of: str = "pressure", **style: Any) -> Any:
        """Plots the map of ``of``, "pressure" or "gap", or the line, on axes of matplotlib; ``style``: keywords of matplotlib."""
        from ._plot import plot_contact

        return plot_contact(self.pressures, self.gaps, self._data["size"], of, ax, **style)


def maps_dataset(pressures: Array, gaps: Array, size: Sequence[float]) -> Any:
    """Maps of a contact as a Dataset of xarray."""
    import numpy
    import xarray

    names = ("x", "y")[: len(size)]
    shape = pressures.shape if len(size) == 2 else (pressures.size,)
    steps = {name: (name, numpy.arange(n) * (extent / n), {"units": "m"}) for name, n, extent in zip(names, shape, size)}
    fields = {"pressure": (names, pressures.reshape(shape), {"units": "Pa"}), "gap": (names, gaps.reshape(shape), {"units": "m"})}
    return xarray.Dataset(fields, coords=steps)


def made_surface(pixels: int | str | None, cell: Text | None, surface: str | None, seed: int) -> Any:
    """Options of a surface that is made from a spectrum."""
    return filled(_setae.MadeSurfaceRequest(), pixels=None if pixels is None else str(pixels), cell=cell, surface=surface, seed=seed)


def contact(
    measurement: Measured,
    *,
    contact_modulus: Text,
    pressure: Text | None = None,
    displacement: Text | None = None,
    mean_gap: Text | None = None,
    stage_stiffness: Text | None = None,
    free: bool = False,
    layer: Text | None = None,
    bonded: bool = False,
    frictionless: bool = False,
    nu: float | None = None,
    hardness: Text | None = None,
    W_int: Text | None = None,
    range: Text | None = None,
    law: str = "exponential",
    tolerance: float = 1e-8,
    pixels: int | str | None = None,
    cell: Text | None = None,
    surface: str | None = None,
    seed: int = 1,
    trend: str | None = None,
    edges: str = "automatic",
    size: Size | None = None,
    unit: str | None = None,
    keep_values: bool = False,
) -> Contact:
    """A rigid rough surface pressed on an elastic body without friction: p ≥ 0, g ≥ 0, p g = 0 [Johnson 1985, ch. 13].

    One of pressure, displacement and mean_gap is given. With W_int and range the bodies attract each other: V(0) = −W_int and
    dV/dg = W_int/range at g = 0. The result is the equilibrium that is reached from a large distance, without hardness and free edges.

    If the file is the table of a spectrum, or a study, a surface is made from it (pixels, cell, surface, seed) with the waves of the spectrum
    that fit on the grid. Measured heights are levelled as before a spectrum, unless they are periodic. A map that is not periodic and is
    repeated raises the warning MAP_NOT_PERIODIC.

    Parameters
    ----------
    contact_modulus : str or Quantity
        contact modulus E* = E/(1 - nu^2) of the soft body, such as "1 GPa"
    pressure : str or Quantity
        mean pressure over the map, such as "10 MPa"
    displacement : str or Quantity
        approach from first touch, such as "5 nm"
    mean_gap : str or Quantity
        mean gap over the map, such as "2 nm"
    stage_stiffness : str or Quantity
        stiffness of the stage that is displaced, with adhesion only, such as "10 N/m"
    free : bool, default False
        nothing touches beyond the map; without it the map repeats itself
    layer : str or Quantity
        thickness of an elastic layer on a rigid base, such as "1 um"; default: a half-space
    bonded : bool, default False
        the layer sticks to its base
    frictionless : bool, default False
        the layer slides on its base
    nu : float
        Poisson ratio of the layer, from 0 to 0.5
    hardness : str or Quantity
        pressure at which the body flows, such as "1 GPa"; default: the body stays elastic
    W_int : str or Quantity
        work of adhesion per unit area in contact, such as "50 mJ/m2"
    range : str or Quantity
        range of the attraction: its greatest tension is the work of adhesion over the range, such as "0.3 nm"
    law : str, default 'exponential'
        decay of the attraction with the gap; one of exponential, cubic, dugdale, lennard_jones
    tolerance : float, default 1e-08
        largest relative duality gap of a converged contact
    pixels : int or str
        points of a surface made from a spectrum, 512 or 1024x512
    cell : str or Quantity
        extent of a surface made from a spectrum, such as "2 um"; default: twice the longest wavelength
    surface : str
        name of the surface in a study from whose spectrum one is made
    seed : int, default 1
        seed of the phases of a surface made from a spectrum
    trend : str
        trend that is removed from the heights: 'none', 'mean', 'tilt' or 'parabola'
    edges : str, default 'automatic'
        edges of a map: 'automatic' (repeated, with a warning where heights do not match), 'periodic' or 'windowed'
    size : str or Quantity or tuple
        extent of the heights, where the file does not state it
    unit : str
        unit of the heights, where the file does not state it
    keep_values : bool, default False
        heights are taken as they are: no value counts as a mark of missing data

    Full contact of a wave needs p = E* q A/2:

    >>> import numpy, setae
    >>> wave = setae.scan(1e-9 * numpy.cos(2 * numpy.pi * numpy.arange(64) / 64), size="1 um", unit="m", periodic=True)
    >>> setae.contact(wave, contact_modulus="1 MPa", pressure="3.2 kPa")["area_fraction"]
    1.000
    """
    require("a text", edges=edges)
    request = filled(
        _setae.HardWallRequest(),
        contact_modulus=contact_modulus,
        pressure=pressure,
        displacement=displacement,
        mean_gap=mean_gap,
        stage_stiffness=stage_stiffness,
        free=free,
        layer=layer,
        bonded=bonded,
        frictionless=frictionless,
        nu=nu,
        hardness=hardness,
        tolerance=tolerance,
    )
    attraction = filled(_setae.InteractionRequest(), W_int=W_int, range=range, law=law)
    measured = one(measurement, size, unit, keep_values, trend)
    solved: Any = _setae.contact(measured[0], request, attraction, made_surface(pixels, cell, surface, seed), edges)
    return Contact(solved.json, solved.pressures, solved.gaps, tuple(map(quantity_from, json.loads(solved.quantities()))))


@dataclass(frozen=True, eq=False, repr=False)
class _ContactLoop(Columns):
    """Steps of approach and retraction."""

    measured: tuple[Quantity, ...] = field(default=())

    @property
    def quantities(self) -> tuple[Quantity, ...]:
        """Works, losses and other quantities of the loop."""
        return self.measured

    @property
    def n(self) -> int:
        """Steps."""
        return len(self["position"])

    @property
    def complete(self) -> bool:
        """True if the loop reached its end and every step converged."""
        return bool(self._data["status"] == "complete")

    def __repr__(self) -> str:
        return f"{type(self).__name__}({self.n} steps, {', '.join(f'{q.symbol} = {q}' for q in self.quantities)})"


@dataclass(frozen=True, eq=False, repr=False)
class ContactSweep(_ContactLoop):
    """Approach and retraction with one row per step, as printed by ``setae contact sweep --json``; ``quantities``: works and losses.

    ``maps``: pressures [Pa], negative for tension, and gaps [m] by the name of the state, if maps were asked for.
    """

    maps: Mapping[str, tuple[Array, Array]] = field(default_factory=dict)

    def map_dataset(self, state: str) -> Any:
        """Pressures and gaps of a state as a Dataset of xarray with coordinates in metres."""
        return maps_dataset(*self.maps[state], self._data["size"])

    def plot(self, ax: Any = None, **style: Any) -> Any:
        """Plots the tension against the mean gap, approach and separation, on axes of matplotlib."""
        from ._plot import plot_columns

        return plot_columns(self, "mean_gap", ["tension"], ax, **style)


def contact_sweep(
    measurement: Measured,
    *,
    contact_modulus: Text,
    W_int: Text,
    range: Text,
    law: str = "exponential",
    stage_stiffness: Text | None = None,
    to_gap: Text | None = None,
    to_pressure: Text | None = None,
    largest_move: float = 1.0,
    maps: bool = False,
    restart: Path | None = None,
    layer: Text | None = None,
    bonded: bool = False,
    frictionless: bool = False,
    nu: float | None = None,
    pixels: int | str | None = None,
    cell: Text | None = None,
    surface: str | None = None,
    seed: int = 1,
    trend: str | None = None,
    edges: str = "automatic",
    size: Size | None = None,
    unit: str | None = None,
    keep_values: bool = False,
) -> ContactSweep:
    """Approach and retraction of a rigid rough surface and an elastic body that attract each other, in a periodic cell.

    The sweep turns at to_gap or to_pressure, without them at full contact. A cell has a loss of its own, even a flat one, because it jumps
    into and out of contact as a whole. Surfaces are given as for :func:`contact`. With maps the states are kept point by point at first load
    ("approach_zero_load"), where the sweep turns ("turn"), at zero load on retraction ("separation_zero_load") and at the greatest tension
    ("greatest_tension").

    Parameters
    ----------
    contact_modulus : str or Quantity
        contact modulus E* = E/(1 - nu^2) of the soft body, such as "1 GPa"
    W_int : str or Quantity
        work of adhesion per unit area in contact, such as "50 mJ/m2"
    range : str or Quantity
        range of the attraction: its greatest tension is the work of adhesion over the range, such as "0.3 nm"
    law : str, default 'exponential'
        decay of the attraction with the gap; one of exponential, cubic, dugdale, lennard_jones
    stage_stiffness : str or Quantity
        stiffness of the stage that is moved, such as "10 N/m"; default: the mean gap is prescribed
    to_gap : str or Quantity
        mean gap, or position of the stage, where the sweep turns, such as "2 nm"; default: 0, full contact
    to_pressure : str or Quantity
        mean pressure where the sweep turns, such as "10 kPa"
    largest_move : float, default 1.0
        largest change of any gap per step, in ranges: 2 takes two thirds of the time, works change by up to 1 %
    maps : bool, default False
        states are kept point by point: at first load, at the turn, at zero load on retraction, at the greatest tension
    restart : str or path
        file written every 20 steps; where it exists the sweep continues from it, to the same bytes; removed at the end
    layer : str or Quantity
        thickness of an elastic layer on a rigid base, such as "1 um"; default: a half-space
    bonded : bool, default False
        the layer sticks to its base
    frictionless : bool, default False
        the layer slides on its base
    nu : float
        Poisson ratio of the layer, from 0 to 0.5
    pixels : int or str
        points of a surface made from a spectrum, 512 or 1024x512
    cell : str or Quantity
        extent of a surface made from a spectrum, such as "2 um"; default: twice the longest wavelength
    surface : str
        name of the surface in a study from whose spectrum one is made
    seed : int, default 1
        seed of the phases of a surface made from a spectrum
    trend : str
        trend that is removed from the heights: 'none', 'mean', 'tilt' or 'parabola'
    edges : str, default 'automatic'
        edges of a map: 'automatic' (repeated, with a warning where heights do not match), 'periodic' or 'windowed'
    size : str or Quantity or tuple
        extent of the heights, where the file does not state it
    unit : str
        unit of the heights, where the file does not state it
    keep_values : bool, default False
        heights are taken as they are: no value counts as a mark of missing data

    >>> import numpy, setae
    >>> flat = setae.scan(numpy.zeros((8, 8)), size="80 nm x 80 nm", unit="m", periodic=True)
    >>> sweep = setae.contact_sweep(flat, contact_modulus="1 GPa", W_int="50 mJ/m2", range="10 nm")
    >>> sweep.complete, sweep.units["tension"]
    (True, 'Pa')
    """
    require("a text", edges=edges)
    require("True or False", maps=maps)
    request = filled(
        _setae.SweepRequest(),
        contact_modulus=contact_modulus,
        W_int=W_int,
        range=range,
        law=law,
        stage_stiffness=stage_stiffness,
        to_gap=to_gap,
        to_pressure=to_pressure,
        largest_move=largest_move,
        maps=maps,
        restart=None if restart is None else path(restart),
        layer=layer,
        bonded=bonded,
        frictionless=frictionless,
        nu=nu,
    )
    measured = one(measurement, size, unit, keep_values, trend)
    swept: Any = _setae.contact_sweep(measured[0], request, made_surface(pixels, cell, surface, seed), edges)
    return ContactSweep(swept.columns, swept.units, swept.json, tuple(map(quantity_from, json.loads(swept.quantities()))), swept.maps)


@dataclass(frozen=True, eq=False, repr=False)
class ContactFront(_ContactLoop):
    """Loop of a soft sphere on a rough surface, one row per step, as printed by ``setae contact front --json``; ``quantities``: works, jumps, losses.

    ``edge``: with a duration the columns "time", "frame", "displacement", "force", "radius_1" … during contact. ``save_edge("edge.csv")``
    writes a table for :func:`contact_line`.
    """

    edge: Named = field(default_factory=lambda: edge_of({}))
    handle: Any = None

    def __getstate__(self) -> dict[str, Any]:
        return {**super().__getstate__(), "handle": None}

    def plot(self, ax: Any = None, **style: Any) -> Any:
        """Plots the force against the displacement on axes of matplotlib."""
        from ._plot import plot_columns

        return plot_columns(self, "displacement", ["force"], ax, **style)

    def save_edge(self, file: Path) -> None:
        """Writes the edge as a table."""
        if not self.edge:
            raise InvalidArgument("no edge was kept; expected the argument duration")
        if self.handle is None:
            raise InvalidArgument("the edge was computed in another process; expected save_edge() there")
        self.handle.save_edge(path(file))


def contact_front(
    measurement: Measured,
    *,
    radius: Text,
    contact_modulus: Text,
    W_int: Text,
    to_force: Text | None = None,
    to_displacement: Text | None = None,
    stage_stiffness: Text | None = None,
    dead_load: bool = False,
    shortest_wavelength: Text | None = None,
    realisations: int = 1,
    steps: int = 500,
    duration: Text | None = None,
    model: str = "constant_toughness",
    method: str = "trust_region",
    pixels: int | str | None = None,
    cell: Text | None = None,
    surface: str | None = None,
    seed: int = 1,
    trend: str | None = None,
    edges: str = "automatic",
    size: Size | None = None,
    unit: str | None = None,
    keep_values: bool = False,
) -> ContactFront:
    """A soft sphere pressed on a rough surface and pulled off, with the edge of the contact as a crack front.

    The loop turns at to_force or to_displacement. The stage is moved (stage_stiffness), or the force (dead_load), otherwise the displacement
    of the sphere. Surfaces are given as for :func:`contact`; the contact must end within a measured map. With a duration the edge is kept at
    every step.

    Parameters
    ----------
    radius : str or Quantity
        radius of the sphere, such as "1.25 mm"
    contact_modulus : str or Quantity
        contact modulus E* of sphere and surface together, such as "1 MPa"
    W_int : str or Quantity
        energy gained per unit area of full contact, such as "50 mJ/m2"
    to_force : str or Quantity
        force of a smooth sphere where the loop turns, such as "0.1 mN"
    to_displacement : str or Quantity
        displacement of a smooth sphere where the loop turns, such as "1 um"
    stage_stiffness : str or Quantity
        stiffness of the stage that is moved, such as "100 N/m"; default: the displacement of the sphere is prescribed
    dead_load : bool, default False
        the force is prescribed; the loop ends at pull-off
    shortest_wavelength : str or Quantity
        shortest wavelength that counts, such as "1 um"; default: four pixels
    realisations : int, default 1
        number of surfaces made, with seeds from `seed` on; results are means with their standard errors
    steps : int, default 500
        steps on approach; halved where the edge jumps
    duration : str or Quantity
        duration of the approach: times of the edge that is saved, such as "100 s"
    model : str, default 'constant_toughness'
        dependence of the energy on the position of the edge; one of constant_toughness, variational, energy_release_rate,
        stress_intensity, mean_circle
    method : str, default 'trust_region'
        solver for the equilibria; one of trust_region, rosso_krauth
    pixels : int or str
        points of a surface made from a spectrum, 512 or 1024x512
    cell : str or Quantity
        extent of a surface made from a spectrum, such as "2 um"; default: twice the longest wavelength
    surface : str
        name of the surface in a study from whose spectrum one is made
    seed : int, default 1
        seed of the phases of a surface made from a spectrum
    trend : str
        trend that is removed from the heights: 'none', 'mean', 'tilt' or 'parabola'
    edges : str, default 'automatic'
        edges of a map: 'automatic' (repeated, with a warning where heights do not match), 'periodic' or 'windowed'
    size : str or Quantity or tuple
        extent of the heights, where the file does not state it
    unit : str
        unit of the heights, where the file does not state it
    keep_values : bool, default False
        heights are taken as they are: no value counts as a mark of missing data

    >>> import numpy, setae
    >>> x = numpy.arange(64) / 64
    >>> wave = setae.scan(2e-9 * numpy.sin(8 * numpy.pi * x)[:, None] * numpy.ones(64), size="64 um x 64 um", unit="m", periodic=True)
    >>> front = setae.contact_front(wave, radius="1 mm", contact_modulus="1 MPa", W_int="50 mJ/m2", to_displacement="0.2 um", steps=40)
    >>> front.complete, front.units["force"]
    (True, 'N')
    """
    require("a text", edges=edges)
    require("a whole number", realisations=realisations)
    request = filled(
        _setae.FrontRequest(),
        radius=radius,
        contact_modulus=contact_modulus,
        W_int=W_int,
        to_force=to_force,
        to_displacement=to_displacement,
        stage_stiffness=stage_stiffness,
        dead_load=dead_load,
        shortest_wavelength=shortest_wavelength,
        model=model,
        method=method,
        steps=steps,
        duration=duration,
    )
    measured = one(measurement, size, unit, keep_values, trend)
    found: Any = _setae.contact_front(measured[0], request, made_surface(pixels, cell, surface, seed), edges, realisations)
    return ContactFront(found.columns, found.units, found.json, tuple(map(quantity_from, json.loads(found.quantities()))), edge_of(found.edge), found)


class PerssonContact(Columns):
    """Contact by Persson's theory: against pressure or, for one pressure, against q with only the waves up to q."""

    @property
    def n(self) -> int:
        """Number of pressures, or of wavevectors for one pressure."""
        return len(next(iter(self.columns.values())))

    def plot(self, ax: Any = None, *, of: str = "area_fraction", **style: Any) -> Any:
        """Plots a column against pressure, or against the wavevector, on logarithmic axes of matplotlib."""
        from ._plot import plot_columns

        return plot_columns(self, next(iter(self.columns)), [of], ax, scale="log", **style)

    def __repr__(self) -> str:
        return f"PerssonContact({self.n} rows of {', '.join(self.columns)})"


def persson(
    measurements: Measured,
    *,
    contact_modulus: Text,
    pressure: Text,
    W_int: Text | None = None,
    layer: Text | None = None,
    bonded: bool = False,
    frictionless: bool = False,
    nu: float | None = None,
    energy_factor: float = 0.45,
    instrument: str | None = None,
    tip_radius: Text | None = None,
    resolution: Text | None = None,
    trend: str | None = None,
    size: Size | None = None,
    unit: str | None = None,
    keep_values: bool = False,
    longest: Text | None = None,
    shortest: Text | None = None,
    window: str | None = None,
    contours: str | None = None,
    skip_failed: bool = False,
) -> PerssonContact:
    """Area, gap and stiffness of a rough contact from its spectrum [Persson 2001], with W_int also with adhesion [Persson 2002].

    Measurements are given as for :func:`power_spectrum`, or as the table of a spectrum.

    Parameters
    ----------
    contact_modulus : str or Quantity
        contact modulus E* = E/(1 - nu^2) of the soft body, such as "1 GPa"
    pressure : str or Quantity
        mean pressure: one, several as 1MPa,10MPa, or ten per decade as 1MPa:100MPa; below 0 with adhesion
    W_int : str or Quantity
        work of adhesion per unit projected area, such as "50 mJ/m2"; default: none
    layer : str or Quantity
        thickness of an elastic layer on a rigid base, such as "1 um"; default: a half-space
    bonded : bool, default False
        the layer sticks to its base
    frictionless : bool, default False
        the layer slides on its base
    nu : float
        Poisson ratio of the layer, from 0 to 0.5
    energy_factor : float, default 0.45
        factor of the stored energy of partial contact, in (0, 1]
    instrument : str
        kind of the instrument: 'stylus', 'afm', 'tem' or 'optical'
    tip_radius : str or Quantity
        radius of the tip, with its standard error, such as '10 ± 2 nm'
    resolution : str or Quantity
        distance below which the instrument does not resolve heights
    trend : str
        trend that is removed from the heights: 'none', 'mean', 'tilt' or 'parabola'
    size : str or Quantity or tuple
        extent of the heights, where the file does not state it
    unit : str
        unit of the heights, where the file does not state it
    keep_values : bool, default False
        heights are taken as they are: no value counts as a mark of missing data
    longest : str or Quantity
        longest wavelength that counts
    shortest : str or Quantity
        shortest wavelength that counts
    window : str
        window of the spectrum: 'hann' or 'none'; None chooses by the heights
    contours : str
        treatment of traced contours: 'unique' or 'full'
    skip_failed : bool, default False
        measurements that cannot be analysed are left out with a warning
    """
    request = filled(
        _setae.PerssonRequest(),
        contact_modulus=contact_modulus,
        pressure=pressure,
        W_int=W_int,
        layer=layer,
        bonded=bonded,
        frictionless=frictionless,
        nu=nu,
        energy_factor=energy_factor,
    )
    shared = shared_options(instrument, tip_radius, resolution, trend, size, unit, keep_values)
    analysis = analysis_of(longest, shortest, window, contours)
    found: Any = _setae.persson(items(measurements, shared), analysis, request, not skip_failed)
    return PerssonContact(found.columns, found.units, found.json)


class ContactComparison(Columns):
    """Solved contacts of surfaces with one spectrum, and Persson's theory, against pressure.

    "mean_gap" is the mean over surfaces, "mean_gap_standard_error" is its standard error, and "mean_gap_persson" is the value of the theory.
    The quantities "area_fraction", "contact_stiffness" and "stored_energy" have columns with the same endings.
    """

    @property
    def n(self) -> int:
        """Number of surfaces in every mean."""
        return int(self._data["surfaces"])

    def plot(self, ax: Any = None, *, of: str = "area_fraction", **style: Any) -> Any:
        """Plots solved contacts and Persson's theory against pressure on logarithmic axes of matplotlib."""
        from ._plot import plot_columns

        return plot_columns(self, "pressure", [of, f"{of}_persson"], ax, scale="log", **style)

    def __repr__(self) -> str:
        return f"ContactComparison({len(self['pressure'])} pressures, {self.n} surfaces)"


def contact_compare(
    measurements: Measured,
    *,
    contact_modulus: Text,
    pressure: Text,
    pixels: str = "512",
    cell: Text | None = None,
    surfaces: int = 4,
    seed: int = 0,
    tolerance: float = 1e-6,
    layer: Text | None = None,
    bonded: bool = False,
    frictionless: bool = False,
    nu: float | None = None,
    energy_factor: float = 0.45,
    instrument: str | None = None,
    tip_radius: Text | None = None,
    resolution: Text | None = None,
    trend: str | None = None,
    size: Size | None = None,
    unit: str | None = None,
    keep_values: bool = False,
    longest: Text | None = None,
    shortest: Text | None = None,
    window: str | None = None,
    contours: str | None = None,
    skip_failed: bool = False,
) -> ContactComparison:
    """Persson's theory compared with the solved contacts of surfaces with the same spectrum.

    Measurements are given as for :func:`persson`.

    Parameters
    ----------
    contact_modulus : str or Quantity
        contact modulus E* = E/(1 - nu^2) of the soft body, such as "1 GPa"
    pressure : str or Quantity
        mean pressure: one, several as 1MPa,10MPa, or ten per decade as 1MPa:100MPa; below 0 with adhesion
    pixels : str, default '512'
        points of each surface, 512 or 1024x512; at least four per shortest wavelength
    cell : str or Quantity
        extent of each surface, such as "2 um"; default: twice the longest wavelength
    surfaces : int, default 4
        number of surfaces
    seed : int, default 0
        seed of the first surface; the others have the next ones
    tolerance : float, default 1e-06
        largest relative duality gap of each contact
    layer : str or Quantity
        thickness of an elastic layer on a rigid base, such as "1 um"; default: a half-space
    bonded : bool, default False
        the layer sticks to its base
    frictionless : bool, default False
        the layer slides on its base
    nu : float
        Poisson ratio of the layer, from 0 to 0.5
    energy_factor : float, default 0.45
        factor of the stored energy of partial contact, in (0, 1]
    instrument : str
        kind of the instrument: 'stylus', 'afm', 'tem' or 'optical'
    tip_radius : str or Quantity
        radius of the tip, with its standard error, such as '10 ± 2 nm'
    resolution : str or Quantity
        distance below which the instrument does not resolve heights
    trend : str
        trend that is removed from the heights: 'none', 'mean', 'tilt' or 'parabola'
    size : str or Quantity or tuple
        extent of the heights, where the file does not state it
    unit : str
        unit of the heights, where the file does not state it
    keep_values : bool, default False
        heights are taken as they are: no value counts as a mark of missing data
    longest : str or Quantity
        longest wavelength that counts
    shortest : str or Quantity
        shortest wavelength that counts
    window : str
        window of the spectrum: 'hann' or 'none'; None chooses by the heights
    contours : str
        treatment of traced contours: 'unique' or 'full'
    skip_failed : bool, default False
        measurements that cannot be analysed are left out with a warning

    >>> import setae
    >>> made = setae.synthesize(hurst=0.8, rolloff="2 um", short_cutoff="250 nm", rms_height="20 nm", size="4 um", pixels="64")
    >>> found = setae.contact_compare(made.scan, contact_modulus="1 GPa", pressure="10 MPa", shortest="250 nm", pixels="128", surfaces=2)
    >>> found.n, bool(abs(found["area_fraction_persson"][0] / found["area_fraction"][0] - 1) < 0.4)
    (2, True)
    """
    theory = filled(
        _setae.PerssonRequest(),
        contact_modulus=contact_modulus,
        pressure=pressure,
        layer=layer,
        bonded=bonded,
        frictionless=frictionless,
        nu=nu,
        energy_factor=energy_factor,
    )
    request = filled(
        _setae.ComparisonRequest(), theory=theory, pixels=pixels, cell=cell, surfaces=surfaces, seed=seed, tolerance=tolerance
    )
    shared = shared_options(instrument, tip_radius, resolution, trend, size, unit, keep_values)
    analysis = analysis_of(longest, shortest, window, contours)
    found: Any = _setae.contact_compare(items(measurements, shared), analysis, request, not skip_failed)
    return ContactComparison(found.columns, found.units, found.json)
