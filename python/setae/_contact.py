# SPDX-License-Identifier: GPL-3.0-or-later
"""Contact of rough surfaces: pressed on an elastic body without and with adhesion, and Persson's theory of it."""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from . import _setae
from ._columns import Columns
from ._errors import InvalidArgument
from ._options import Path, Text, filled, path
from ._quantities import Answer, Quantity, quantity_from
from ._scan import Measured, items
from ._spectra import analysis_of, shared_options
from ._synthesis import one

if TYPE_CHECKING:
    from collections.abc import Mapping

    from ._columns import Array


@dataclass(frozen=True, repr=False)
class Contact(Answer):
    """A rigid rough surface pressed on an elastic body, as ``setae contact solve --json`` says it.

    ``pressures`` [Pa], below 0 where it is drawn, and ``gaps`` [m]: maps, first index x; of a line one row.
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


def made_surface(pixels: int | str | None, cell: Text | None, surface: str | None, seed: int) -> Any:
    """What a surface that is made from a spectrum is told."""
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
    size: Text | None = None,
    unit: str | None = None,
    keep_values: bool = False,
) -> Contact:
    """A rigid rough surface pressed on an elastic half-space without friction: p ≥ 0, g ≥ 0, p g = 0 [Johnson 1985, ch. 13].

    contact_modulus: E* = E/(1 − ν²).  One of pressure, displacement (from first touch) and mean_gap.  free: nothing touches beyond the map.
    layer: its thickness on a rigid base, with ``nu`` and ``bonded`` or ``frictionless``.  hardness: the body flows there.
    W_int, range: both bodies attract each other, V(0) = −W_int and V'(0) = W_int/range; ``law`` says how that falls with the gap,
    "exponential", "cubic", "dugdale" or "lennard_jones". The equilibrium is the one met coming from far; no hardness, nothing free.
    stage_stiffness: "10 N/m" of a stage that is moved by the displacement, with adhesion.

    A file that is the table of a spectrum, or a study, has a surface made from it: ``pixels`` "512" or "1024x512", ``cell`` its extent,
    ``surface`` which of a study's, ``seed``. Its waves are those of the spectrum that the grid holds.

    Measured heights are levelled as before a spectrum (``trend``), unless they repeat themselves.  edges: "automatic", "periodic" for heights
    that repeat themselves, or "windowed", which takes them to their mean within a tenth of either edge. A map that does not repeat itself and is
    repeated raises the warning MAP_NOT_PERIODIC.

    Full contact of a wave needs p = E* q A/2:

    >>> import numpy, setae
    >>> wave = setae.scan(1e-9 * numpy.cos(2 * numpy.pi * numpy.arange(64) / 64), size="1 um", unit="m", periodic=True)
    >>> setae.contact(wave, contact_modulus="1 MPa", pressure="3.2 kPa")["area_fraction"]
    1.0
    """
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
        poisson_ratio=nu,
        hardness=hardness,
        tolerance=tolerance,
    )
    attraction = filled(_setae.InteractionRequest(), work_of_adhesion=W_int, range=range, law=law)
    solved: Any = _setae.contact(one(measurement, size, unit, keep_values, trend), request, attraction, made_surface(pixels, cell, surface, seed), edges)
    return Contact(solved.json, solved.pressures, solved.gaps, tuple(map(quantity_from, json.loads(solved.quantities()))))


@dataclass(frozen=True, eq=False, repr=False)
class _ContactLoop(Columns):
    """Steps of a contact that comes and goes."""

    quantities: tuple[Quantity, ...] = field(default=())

    @property
    def n(self) -> int:
        """Steps."""
        return len(self["position"])

    @property
    def complete(self) -> bool:
        """It came to its end, and every step converged."""
        return bool(self.data["status"] == "complete")

    def __repr__(self) -> str:
        return f"{type(self).__name__}({self.n} steps, {', '.join(f'{q.symbol} = {q}' for q in self.quantities)})"


@dataclass(frozen=True, eq=False, repr=False)
class ContactSweep(_ContactLoop):
    """A loop from far into contact and back, a row a step, as ``setae contact sweep --json`` says it; ``quantities``: works and losses.

    ``maps``: by name of a state its pressures [Pa], below 0 where it is drawn, and gaps [m], where they were asked for.
    """

    maps: Mapping[str, tuple[Array, Array]] = field(default_factory=dict)


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
    size: Text | None = None,
    unit: str | None = None,
    keep_values: bool = False,
) -> ContactSweep:
    """A rigid rough surface and an elastic body that attract each other, brought together and parted; the cell repeats itself.

    W_int, range, law, the body, trend and edges, and what a surface is made from: as of :func:`contact`.  stage_stiffness: of a stage that is moved, "10 N/m"; else the mean gap is.
    to_gap, to_pressure: where it turns; without them at full contact.  A cell has a loss of its own, even a flat one.
    largest_move: of any gap in a step, in ranges: 2 takes two thirds of the time, works change by up to 1 %.
    maps: keep the states point by point where it is first pressed, "approach_zero_load", turns, "turn", is first drawn, "separation_zero_load",
    and is drawn most, "greatest_tension".

    >>> import numpy, setae
    >>> flat = setae.scan(numpy.zeros((8, 8)), size="80 nm x 80 nm", unit="m", periodic=True)
    >>> sweep = setae.contact_sweep(flat, contact_modulus="1 GPa", W_int="50 mJ/m2", range="10 nm")
    >>> sweep.complete, sweep.units["tension"]
    (True, 'Pa')
    """
    request = filled(
        _setae.SweepRequest(),
        contact_modulus=contact_modulus,
        work_of_adhesion=W_int,
        range=range,
        law=law,
        stage_stiffness=stage_stiffness,
        to_gap=to_gap,
        to_pressure=to_pressure,
        largest_move=largest_move,
        maps=maps,
        layer=layer,
        bonded=bonded,
        frictionless=frictionless,
        poisson_ratio=nu,
    )
    swept: Any = _setae.contact_sweep(one(measurement, size, unit, keep_values, trend), request, made_surface(pixels, cell, surface, seed), edges)
    return ContactSweep(swept.columns, swept.units, swept.json, tuple(map(quantity_from, json.loads(swept.quantities()))), swept.maps)


@dataclass(frozen=True, eq=False, repr=False)
class ContactFront(_ContactLoop):
    """A soft sphere on a rough surface and back, a row a step, as ``setae contact front --json`` says it; ``quantities``: works, jumps, losses.

    ``edge``: where a duration was given "time", "frame", "displacement", "force", "radius_1" … while it touches; ``save_edge("edge.csv")`` writes
    what :func:`contact_line` reads.
    """

    edge: Mapping[str, Array] = field(default_factory=dict)
    handle: Any = None

    def save_edge(self, file: Path) -> None:
        """Writes the edge as a table."""
        if not self.edge:
            raise InvalidArgument("no edge was kept; expected a duration")
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
    size: Text | None = None,
    unit: str | None = None,
    keep_values: bool = False,
) -> ContactFront:
    """A soft sphere pressed on a rough surface and pulled off, the edge of the contact as a crack front.

    W_int: what conforming gains, an area.  to_force or to_displacement: where the loop turns.  stage_stiffness: of a stage that is moved; dead_load: the force is; else the
    sphere's displacement is held.  shortest_wavelength: that counts, four pixels without it.  pixels, cell, surface, seed: a surface made from a spectrum or a study, as of
    :func:`contact`; of ``realisations`` such surfaces, seeds one after the other, ``quantities`` are means with ±.
    duration: of the way there, "100 s", keeps the edge at every step.  trend, edges: as of :func:`contact`; the contact ends within a measured map.

    >>> import numpy, setae
    >>> x = numpy.arange(64) / 64
    >>> wave = setae.scan(2e-9 * numpy.sin(8 * numpy.pi * x)[:, None] * numpy.ones(64), size="64 um x 64 um", unit="m", periodic=True)
    >>> front = setae.contact_front(wave, radius="1 mm", contact_modulus="1 MPa", W_int="50 mJ/m2", to_displacement="0.2 um", steps=40)
    >>> front.complete, front.units["force"]
    (True, 'N')
    """
    request = filled(
        _setae.FrontRequest(),
        radius=radius,
        contact_modulus=contact_modulus,
        work_of_adhesion=W_int,
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
    found: Any = _setae.contact_front(one(measurement, size, unit, keep_values, trend), request, made_surface(pixels, cell, surface, seed), edges, realisations)
    return ContactFront(found.columns, found.units, found.json, tuple(map(quantity_from, json.loads(found.quantities()))), found.edge, found)


class PerssonContact(Columns):
    """Contact by Persson's theory: against pressure or, of one pressure, against the waves up to q alone."""

    def __repr__(self) -> str:
        return f"PerssonContact({', '.join(self.columns)})"


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
    size: Text | None = None,
    unit: str | None = None,
    keep_values: bool = False,
    longest: Text | None = None,
    shortest: Text | None = None,
    window: str | None = None,
    contours: str | None = None,
    skip_failed: bool = False,
) -> PerssonContact:
    """Area, gap and stiffness of a rough contact from its spectrum [Persson 2001], with adhesion where W_int is given [Persson 2002].

    pressure: one, several as "1MPa,10MPa", or ten a decade as "1MPa:100MPa".  layer: thickness of the soft body on a rigid base, with bonded or
    frictionless and nu, its Poisson ratio.
    measurements …: as of :func:`power_spectrum`, or the table of a spectrum.
    """
    request = filled(
        _setae.PerssonRequest(),
        contact_modulus=contact_modulus,
        pressure=pressure,
        work_of_adhesion=W_int,
        layer=layer,
        bonded=bonded,
        frictionless=frictionless,
        poisson_ratio=nu,
        energy_factor=energy_factor,
    )
    shared = shared_options(instrument, tip_radius, resolution, trend, size, unit, keep_values)
    analysis = analysis_of(longest, shortest, window, contours)
    found: Any = _setae.persson(items(measurements, shared), analysis, request, not skip_failed)
    return PerssonContact(found.columns, found.units, found.json)


class ContactComparison(Columns):
    """Solved contacts of surfaces with a spectrum and Persson's theory of it, against pressure: "mean_gap" is the mean over surfaces,
    "mean_gap_standard_error" its error, "mean_gap_persson" the theory's; likewise of "area_fraction", "contact_stiffness", "stored_energy".
    """

    @property
    def n(self) -> int:
        """Surfaces behind every mean."""
        return int(self.data["surfaces"])

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
    size: Text | None = None,
    unit: str | None = None,
    keep_values: bool = False,
    longest: Text | None = None,
    shortest: Text | None = None,
    window: str | None = None,
    contours: str | None = None,
    skip_failed: bool = False,
) -> ContactComparison:
    """How far Persson's theory is from the solved contacts of surfaces with the same spectrum.

    pixels, cell: of every surface, "1024x512" and its extent, twice the longest wave where none is given; the shortest wave needs four pixels.
    surfaces, seed: as many are made, and the first one's seed.  tolerance: of each contact's duality gap.  The rest: as of :func:`persson`.

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
        poisson_ratio=nu,
        energy_factor=energy_factor,
    )
    request = filled(
        _setae.ComparisonRequest(), theory=theory, pixels=pixels, cell=cell, surfaces=surfaces, seed=seed, tolerance=tolerance
    )
    shared = shared_options(instrument, tip_radius, resolution, trend, size, unit, keep_values)
    analysis = analysis_of(longest, shortest, window, contours)
    found: Any = _setae.contact_compare(items(measurements, shared), analysis, request, not skip_failed)
    return ContactComparison(found.columns, found.units, found.json)
