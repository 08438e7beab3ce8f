# SPDX-License-Identifier: GPL-3.0-or-later
"""Contact of rough surfaces with an elastic body, without and with adhesion, and Persson's theory."""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from . import _setae
from ._columns import Columns, Named, edge_of
from ._errors import InvalidArgument
from ._given import Given, saved
from ._names import renamed
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


@renamed("nu", "layer", "range")
def contact(
    measurement: Measured,
    *,
    contact_modulus: Text,
    pressure: Text | None = None,
    displacement: Text | None = None,
    mean_gap: Text | None = None,
    stage_stiffness: Text | None = None,
    free: bool = False,
    layer_thickness: Text | None = None,
    bonded: bool = False,
    frictionless: bool = False,
    poisson_ratio: float | None = None,
    hardness: Text | None = None,
    W_int: Text | None = None,
    interaction_range: Text | None = None,
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

    One of pressure, displacement and mean_gap is given. With W_int and interaction_range the bodies attract each other: V(0) = −W_int and
    dV/dg = W_int/interaction_range at g = 0. The result is the equilibrium that is reached from a large distance, without hardness and free edges.

    If the file is the table of a spectrum, or a study, a surface is made from it (pixels, cell, surface, seed) with the waves of the spectrum
    that fit on the grid. Measured heights are levelled as before a spectrum, unless they are periodic. A map that is not periodic and is
    repeated raises the warning MAP_NOT_PERIODIC.

    Parameters
    ----------
    measurement : scan, str, path, array, table or a list of them
        one measurement, or the table of a spectrum
    contact_modulus : str or Quantity
        contact modulus E* = E/(1 - nu^2) of the soft body, such as "1 GPa"
    pressure : str or Quantity, optional
        mean pressure over the map, such as "10 MPa"
    displacement : str or Quantity, optional
        approach from first touch, such as "5 nm"
    mean_gap : str or Quantity, optional
        mean gap over the map, such as "2 nm"
    stage_stiffness : str or Quantity, optional
        stiffness of the stage that is displaced, with adhesion only, such as "10 N/m"
    free : bool, default False
        nothing touches beyond the map; without it the map repeats itself
    layer_thickness : str or Quantity, optional
        thickness of an elastic layer on a rigid base, such as "1 um"; default: a half-space
    bonded : bool, default False
        the layer sticks to its base
    frictionless : bool, default False
        the layer slides on its base
    poisson_ratio : float, optional
        Poisson ratio of the layer, from 0 to 0.5
    hardness : str or Quantity, optional
        pressure at which the body flows, such as "1 GPa"; default: the body stays elastic
    W_int : str or Quantity, optional
        work of adhesion per unit area in contact, such as "50 mJ/m2"
    interaction_range : str or Quantity, optional
        range of the attraction: its greatest tension is the work of adhesion over the range, such as "0.3 nm"
    law : str, default 'exponential'
        decay of the attraction with the gap; one of exponential, cubic, dugdale, lennard_jones
    tolerance : float, default 1e-08
        largest relative duality gap of a converged contact
    pixels : int or str, optional
        points of a surface made from a spectrum, 512 or 1024x512
    cell : str or Quantity, optional
        extent of a surface made from a spectrum, such as "2 um"; default: twice the longest wavelength
    surface : str, optional
        name of the surface in a study from whose spectrum one is made
    seed : int, default 1
        seed of the phases of a surface made from a spectrum
    trend : str, optional
        trend that is removed before the analysis; default: none after steps that level, else by instrument; one of none, mean, tilt,
        parabola
    edges : str, default 'automatic'
        edges of a map: automatic repeats the map, with a warning where heights do not match; one of automatic, periodic, windowed
    size : str or Quantity or tuple, optional
        extent of the heights, where the file does not state it, such as '5 um x 5 um'
    unit : str, optional
        unit of the heights, where the file does not state it, such as 'nm'
    keep_values : bool, default False
        heights are taken as they are: no value counts as a mark of missing data

    Returns
    -------
    Contact
        pressures and gaps as maps, and the quantities of the contact

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
        layer_thickness=layer_thickness,
        bonded=bonded,
        frictionless=frictionless,
        poisson_ratio=poisson_ratio,
        hardness=hardness,
        tolerance=tolerance,
    )
    attraction = filled(_setae.InteractionRequest(), W_int=W_int, interaction_range=interaction_range, law=law)
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


@renamed("nu", "layer", "range", "largest_move")
def contact_sweep(
    measurement: Measured,
    *,
    contact_modulus: Text,
    W_int: Text,
    interaction_range: Text,
    law: str = "exponential",
    stage_stiffness: Text | None = None,
    to_gap: Text | None = None,
    to_pressure: Text | None = None,
    max_move: float = 1.0,
    maps: bool = False,
    restart: Path | None = None,
    layer_thickness: Text | None = None,
    bonded: bool = False,
    frictionless: bool = False,
    poisson_ratio: float | None = None,
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
    measurement : scan, str, path, array, table or a list of them
        one measurement, or the table of a spectrum
    contact_modulus : str or Quantity
        contact modulus E* = E/(1 - nu^2) of the soft body, such as "1 GPa"
    W_int : str or Quantity
        work of adhesion per unit area in contact, such as "50 mJ/m2"
    interaction_range : str or Quantity
        range of the attraction: its greatest tension is the work of adhesion over the range, such as "0.3 nm"
    law : str, default 'exponential'
        decay of the attraction with the gap; one of exponential, cubic, dugdale, lennard_jones
    stage_stiffness : str or Quantity, optional
        stiffness of the stage that is moved, such as "10 N/m"; default: the mean gap is prescribed
    to_gap : str or Quantity, optional
        mean gap, or position of the stage, where the sweep turns, such as "2 nm"; default: 0, full contact
    to_pressure : str or Quantity, optional
        mean pressure where the sweep turns, such as "10 kPa"
    max_move : float, default 1.0
        largest change of any gap per step, in ranges: 2 takes two thirds of the time, works change by up to 1 %
    maps : bool, default False
        states are kept point by point: at first load, at the turn, at zero load on retraction, at the greatest tension
    restart : str or path, optional
        file written every 20 steps; where it exists the sweep continues from it, to the same bytes; removed at the end
    layer_thickness : str or Quantity, optional
        thickness of an elastic layer on a rigid base, such as "1 um"; default: a half-space
    bonded : bool, default False
        the layer sticks to its base
    frictionless : bool, default False
        the layer slides on its base
    poisson_ratio : float, optional
        Poisson ratio of the layer, from 0 to 0.5
    pixels : int or str, optional
        points of a surface made from a spectrum, 512 or 1024x512
    cell : str or Quantity, optional
        extent of a surface made from a spectrum, such as "2 um"; default: twice the longest wavelength
    surface : str, optional
        name of the surface in a study from whose spectrum one is made
    seed : int, default 1
        seed of the phases of a surface made from a spectrum
    trend : str, optional
        trend that is removed before the analysis; default: none after steps that level, else by instrument; one of none, mean, tilt,
        parabola
    edges : str, default 'automatic'
        edges of a map: automatic repeats the map, with a warning where heights do not match; one of automatic, periodic, windowed
    size : str or Quantity or tuple, optional
        extent of the heights, where the file does not state it, such as '5 um x 5 um'
    unit : str, optional
        unit of the heights, where the file does not state it, such as 'nm'
    keep_values : bool, default False
        heights are taken as they are: no value counts as a mark of missing data

    Returns
    -------
    ContactSweep
        one row per step, with the works and losses of the loop

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
    >>> import numpy, setae
    >>> flat = setae.scan(numpy.zeros((8, 8)), size="80 nm x 80 nm", unit="m", periodic=True)
    >>> sweep = setae.contact_sweep(flat, contact_modulus="1 GPa", W_int="50 mJ/m2", interaction_range="10 nm")
    >>> sweep.complete, sweep.units["tension"]
    (True, 'Pa')
    """
    require("a text", edges=edges)
    require("True or False", maps=maps)
    request = filled(
        _setae.SweepRequest(),
        contact_modulus=contact_modulus,
        W_int=W_int,
        interaction_range=interaction_range,
        law=law,
        stage_stiffness=stage_stiffness,
        to_gap=to_gap,
        to_pressure=to_pressure,
        max_move=max_move,
        maps=maps,
        restart=None if restart is None else path(restart),
        layer_thickness=layer_thickness,
        bonded=bonded,
        frictionless=frictionless,
        poisson_ratio=poisson_ratio,
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
        return {**super().__getstate__(), "handle": saved(self.save_edge, "edge.csv") if self.edge else None}

    def plot(self, ax: Any = None, **style: Any) -> Any:
        """Plots the force against the displacement on axes of matplotlib."""
        from ._plot import plot_columns

        return plot_columns(self, "displacement", ["force"], ax, **style)

    def save_edge(self, file: Path) -> None:
        """Writes the edge as a table."""
        if not self.edge:
            raise InvalidArgument("no edge was kept; expected the argument duration")
        write = self.handle.save if isinstance(self.handle, Given) else self.handle.save_edge
        write(path(file))


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
    measurement : scan, str, path, array, table or a list of them
        one measurement, or the table of a spectrum
    radius : str or Quantity
        radius of the sphere, such as "1.25 mm"
    contact_modulus : str or Quantity
        contact modulus E* of sphere and surface together, such as "1 MPa"
    W_int : str or Quantity
        energy gained per unit area of full contact, such as "50 mJ/m2"
    to_force : str or Quantity, optional
        force of a smooth sphere where the loop turns, such as "0.1 mN"
    to_displacement : str or Quantity, optional
        displacement of a smooth sphere where the loop turns, such as "1 um"
    stage_stiffness : str or Quantity, optional
        stiffness of the stage that is moved, such as "100 N/m"; default: the displacement of the sphere is prescribed
    dead_load : bool, default False
        the force is prescribed; the loop ends at pull-off
    shortest_wavelength : str or Quantity, optional
        shortest wavelength that counts, such as "1 um"; default: four pixels
    realisations : int, default 1
        number of surfaces made, with seeds from `seed` on; results are means with their standard errors
    steps : int, default 500
        steps on approach; halved where the edge jumps
    duration : str or Quantity, optional
        duration of the approach: times of the edge that is saved, such as "100 s"
    model : str, default 'constant_toughness'
        dependence of the energy on the position of the edge; one of constant_toughness, variational, energy_release_rate,
        stress_intensity, mean_circle
    method : str, default 'trust_region'
        solver for the equilibria; one of trust_region, rosso_krauth
    pixels : int or str, optional
        points of a surface made from a spectrum, 512 or 1024x512
    cell : str or Quantity, optional
        extent of a surface made from a spectrum, such as "2 um"; default: twice the longest wavelength
    surface : str, optional
        name of the surface in a study from whose spectrum one is made
    seed : int, default 1
        seed of the phases of a surface made from a spectrum
    trend : str, optional
        trend that is removed before the analysis; default: none after steps that level, else by instrument; one of none, mean, tilt,
        parabola
    edges : str, default 'automatic'
        edges of a map: automatic repeats the map, with a warning where heights do not match; one of automatic, periodic, windowed
    size : str or Quantity or tuple, optional
        extent of the heights, where the file does not state it, such as '5 um x 5 um'
    unit : str, optional
        unit of the heights, where the file does not state it, such as 'nm'
    keep_values : bool, default False
        heights are taken as they are: no value counts as a mark of missing data

    Returns
    -------
    ContactFront
        one row per step, with the works, jumps and losses of the loop

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


@renamed("nu", "layer", "longest", "shortest")
def persson(
    measurements: Measured,
    *,
    contact_modulus: Text,
    pressure: Text,
    W_int: Text | None = None,
    layer_thickness: Text | None = None,
    bonded: bool = False,
    frictionless: bool = False,
    poisson_ratio: float | None = None,
    energy_factor: float = 0.45,
    instrument: str | None = None,
    tip_radius: Text | None = None,
    resolution: Text | None = None,
    trend: str | None = None,
    size: Size | None = None,
    unit: str | None = None,
    keep_values: bool = False,
    longest_wavelength: Text | None = None,
    shortest_wavelength: Text | None = None,
    window: str | None = None,
    contours: str | None = None,
    skip_failed: bool = False,
) -> PerssonContact:
    """Area, gap and stiffness of a rough contact from its spectrum [Persson 2001], with W_int also with adhesion [Persson 2002].

    Measurements are given as for :func:`power_spectrum`, or as the table of a spectrum.

    Parameters
    ----------
    measurements : scan, str, path, array, table or a list of them
        one measurement, all measurements of one surface, or the table of a spectrum
    contact_modulus : str or Quantity
        contact modulus E* = E/(1 - nu^2) of the soft body, such as "1 GPa"
    pressure : str or Quantity
        mean pressure: one, several as 1MPa,10MPa, or ten per decade as 1MPa:100MPa; below 0 with adhesion
    W_int : str or Quantity, optional
        work of adhesion per unit projected area, such as "50 mJ/m2"; default: none
    layer_thickness : str or Quantity, optional
        thickness of an elastic layer on a rigid base, such as "1 um"; default: a half-space
    bonded : bool, default False
        the layer sticks to its base
    frictionless : bool, default False
        the layer slides on its base
    poisson_ratio : float, optional
        Poisson ratio of the layer, from 0 to 0.5
    energy_factor : float, default 0.45
        factor of the stored energy of partial contact, in (0, 1]
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
    keep_values : bool, default False
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
    skip_failed : bool, default False
        measurements that cannot be analysed are left out with a warning

    Returns
    -------
    PerssonContact
        columns against pressure, or against the wavevector for one pressure

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
    >>> found = setae.persson(rough, contact_modulus="1 GPa", pressure="1 MPa,10 MPa")
    >>> found.n, bool(found["area_fraction"][0] < found["area_fraction"][1])
    (2, True)
    """
    request = filled(
        _setae.PerssonRequest(),
        contact_modulus=contact_modulus,
        pressure=pressure,
        W_int=W_int,
        layer_thickness=layer_thickness,
        bonded=bonded,
        frictionless=frictionless,
        poisson_ratio=poisson_ratio,
        energy_factor=energy_factor,
    )
    shared = shared_options(instrument, tip_radius, resolution, trend, size, unit, keep_values)
    analysis = analysis_of(longest_wavelength, shortest_wavelength, window, contours)
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


@renamed("nu", "layer", "longest", "shortest", "surfaces")
def contact_comparison(
    measurements: Measured,
    *,
    contact_modulus: Text,
    pressure: Text,
    pixels: str = "512",
    cell: Text | None = None,
    realisations: int = 4,
    seed: int = 0,
    tolerance: float = 1e-6,
    layer_thickness: Text | None = None,
    bonded: bool = False,
    frictionless: bool = False,
    poisson_ratio: float | None = None,
    energy_factor: float = 0.45,
    instrument: str | None = None,
    tip_radius: Text | None = None,
    resolution: Text | None = None,
    trend: str | None = None,
    size: Size | None = None,
    unit: str | None = None,
    keep_values: bool = False,
    longest_wavelength: Text | None = None,
    shortest_wavelength: Text | None = None,
    window: str | None = None,
    contours: str | None = None,
    skip_failed: bool = False,
) -> ContactComparison:
    """Persson's theory compared with the solved contacts of surfaces with the same spectrum.

    Measurements are given as for :func:`persson`.

    Parameters
    ----------
    measurements : scan, str, path, array, table or a list of them
        one measurement, all measurements of one surface, or the table of a spectrum
    contact_modulus : str or Quantity
        contact modulus E* = E/(1 - nu^2) of the soft body, such as "1 GPa"
    pressure : str or Quantity
        mean pressure: one, several as 1MPa,10MPa, or ten per decade as 1MPa:100MPa; below 0 with adhesion
    pixels : str, default '512'
        points of each surface, 512 or 1024x512; at least four per shortest wavelength
    cell : str or Quantity, optional
        extent of each surface, such as "2 um"; default: twice the longest wavelength
    realisations : int, default 4
        number of surfaces
    seed : int, default 0
        seed of the first surface; the others have the next ones
    tolerance : float, default 1e-06
        largest relative duality gap of each contact
    layer_thickness : str or Quantity, optional
        thickness of an elastic layer on a rigid base, such as "1 um"; default: a half-space
    bonded : bool, default False
        the layer sticks to its base
    frictionless : bool, default False
        the layer slides on its base
    poisson_ratio : float, optional
        Poisson ratio of the layer, from 0 to 0.5
    energy_factor : float, default 0.45
        factor of the stored energy of partial contact, in (0, 1]
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
    keep_values : bool, default False
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
    skip_failed : bool, default False
        measurements that cannot be analysed are left out with a warning

    Returns
    -------
    ContactComparison
        columns of solved contacts and of the theory against pressure

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
    >>> made = setae.synthesize(hurst_exponent=0.8, rolloff="2 um", short_cutoff="250 nm", rms_height="20 nm", size="4 um", pixels="64")
    >>> body = {"contact_modulus": "1 GPa", "pressure": "10 MPa"}
    >>> found = setae.contact_comparison(made.scan, **body, shortest_wavelength="250 nm", pixels="128", realisations=2)
    >>> found.n, bool(abs(found["area_fraction_persson"][0] / found["area_fraction"][0] - 1) < 0.4)
    (2, True)
    """
    theory = filled(
        _setae.PerssonRequest(),
        contact_modulus=contact_modulus,
        pressure=pressure,
        layer_thickness=layer_thickness,
        bonded=bonded,
        frictionless=frictionless,
        poisson_ratio=poisson_ratio,
        energy_factor=energy_factor,
    )
    request = filled(
        _setae.ComparisonRequest(), theory=theory, pixels=pixels, cell=cell, realisations=realisations, seed=seed, tolerance=tolerance
    )
    shared = shared_options(instrument, tip_radius, resolution, trend, size, unit, keep_values)
    analysis = analysis_of(longest_wavelength, shortest_wavelength, window, contours)
    found: Any = _setae.contact_compare(items(measurements, shared), analysis, request, not skip_failed)
    return ContactComparison(found.columns, found.units, found.json)
