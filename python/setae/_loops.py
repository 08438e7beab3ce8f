# SPDX-License-Identifier: GPL-3.0-or-later
"""Contact experiments: force, displacement and contact radius of a soft sphere pressed on and pulled off."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Any

from . import _setae
from ._columns import Named
from ._given import Given, Source, as_file, shown
from ._names import renamed
from ._options import MAPPINGS, Path, Text, filled, path, text, texts, texts_of
from ._quantities import Alert, Quantity, alerts_from
from ._results import Answer

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._columns import Array
    from ._fits import Fitted
    from ._generated import LoopSettings


@dataclass(frozen=True, repr=False)
class LoopFit(Answer):
    """All fits to a loop, as printed by ``setae jkr fit --json``: ``fit["loading"]["fits"]["joint"]``, ``fit["pull_off"]`` …"""

    samples: Mapping[str, Mapping[str, Any]] = field(default_factory=dict, compare=False)  #: columns of "record", "loading" and "unloading"

    def points(self, *, branch: str = "loading", route: str | None = None, model: str | None = None) -> Fitted:
        """The fitted samples with the model at these samples, for the primary fit of a branch, for another route, or for an additional model.

        Parameters
        ----------
        branch : str, default 'loading'
            loading or unloading
        route : str
            name in ``fit["loading"]["fits"]``, such as "joint"; default: the primary fit
        model : str
            model of ``fit(models=…)``, such as "dmt", on the branch to which it was fitted
        """
        from ._fits import loop_curve, model_curve

        return model_curve(self._data, self.samples, model) if model else loop_curve(self._data, self.samples, branch, route)

    @property
    def best_fit(self) -> Array:
        """The model of the primary fit at the samples of loading, in the unit of :attr:`residuals`."""
        return self.points().best_fit

    @property
    def residuals(self) -> Array:
        """Measured minus fitted values of the primary fit of loading: contact radius [m], displacement [m] or force [N]."""
        return self.points().residuals

    def plot(self, ax: Any = None, *, branch: str = "loading", route: str | None = None, model: str | None = None, **style: Any) -> Any:
        """Plots the record, the fitted samples and the model on axes of matplotlib, with a panel of residuals; arguments of :meth:`points`."""
        return self.points(branch=branch, route=route, model=model).plot(ax, **style)

    @property
    def E_star(self) -> Quantity:
        """Contact modulus of loading [Pa] from the primary fit."""
        found: Quantity = self["loading"]["contact_modulus"]
        return found

    @property
    def W(self) -> Quantity:
        """Work of adhesion of loading [J/m²] from the primary fit."""
        found: Quantity = self["loading"]["work_of_adhesion"]
        return found

    @property
    def loss(self) -> Quantity | None:
        """Energy of the closed loop [J]; None if it is unknown, with the reason in ``fit["loop_reason"]``."""
        loop = self["loop"]
        return None if loop is None else loop["energy"]

    @property
    def quantities(self) -> tuple[Quantity, ...]:
        """E* and W of loading, pull-off force and energy loss, then the quantities at the top level."""
        pull_off = self["pull_off"]
        own = (self.E_star, self.W, None if pull_off is None else pull_off["force"], self.loss)
        return (*(quantity for quantity in own if quantity is not None), *super().quantities)

    def __repr__(self) -> str:
        loss = "" if self.loss is None else f", E_loss = {self.loss}"
        return f"LoopFit(E* = {self.E_star}, W = {self.W}{loss})"


class MachineStiffness(Answer):
    """Stiffness of the testing machine, as printed by ``setae jkr stiffness --json``."""

    @property
    def stiffness(self) -> Quantity:
        """[N/m]"""
        found: Quantity = self["machine_stiffness"]
        return found


class LoopEnergy(Answer):
    """Energy budget of a loop, as printed by ``setae jkr energy --json``."""

    @property
    def quantities(self) -> tuple[Quantity, ...]:
        """Energy of the closed loop and loss per area."""
        loop, ledger = self._entry("loop"), self._entry("ledger")
        return (*(loop.quantities if loop else ()), *(ledger.quantities if ledger else ()))


@dataclass(frozen=True, eq=False)
class Loop:
    """A loop in SI, and the properties of its bodies."""

    file: str | Given
    files: tuple[tuple[str, Any], ...] = field(default=(), repr=False)
    bodies: tuple[tuple[str, Any], ...] = field(default=(), repr=False)

    @cached_property
    def _opened(self) -> _setae.Loop:
        return _setae.open_loop(path(self.file), loop_files(dict(self.files)))

    def __getstate__(self) -> dict[str, Any]:
        return {"file": self.file, "files": self.files, "bodies": self.bodies}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state)

    @property
    def columns(self) -> Named:
        """"force" [N], "displacement" [m], "contact_radius" [m], "time" [s], if the file contains them."""
        return Named(self._opened.columns, self.units)

    @property
    def units(self) -> dict[str, str]:
        return self._opened.units

    @property
    def metadata(self) -> dict[str, str]:
        return {key: shown(value) for key, value in self._opened.metadata.items()}

    @property
    def alerts(self) -> tuple[Alert, ...]:
        return alerts_from(json.loads(shown(self._opened.alerts)))

    def __getitem__(self, name: str) -> Any:
        return self.columns[name]

    def _ipython_key_completions_(self) -> list[str]:
        return list(self.units)

    def _answer(self, models: dict[str, Any], settings: dict[str, Any]) -> _setae.LoopAnswer:
        asked, wanted = filled(_setae.LoopSettings(), **settings), filled(_setae.LoopModels(), **models)
        return _setae.fit_loop(self._opened, checked_bodies(dict(self.bodies)), asked, wanted)

    def fit(
        self,
        *,
        models: Sequence[str] | str = (),
        branch: str = "loading",
        errors: str = "orthogonal_distance",
        model_contact_point: Text | None = None,
        cohesive_stress: Text | None = None,
        profile: bool = False,
        crack_speed: bool = False,
        exponent: float | None = None,
        **settings: Unpack[LoopSettings],
    ) -> LoopFit:
        """E*, W, pull-off force and loss by every route, with their standard errors.

        Parameters
        ----------
        models : Sequence[str] or str, default ()
            additional model: hertz, dmt, jkr, maugis_dugdale, transition, layer, large_strain; all compares every model
        branch : str, default 'loading'
            branch of additional models, profile likelihood and common fits; one of loading, unloading
        errors : str, default 'orthogonal_distance'
            treatment of measurement errors in additional models and common fits; one of effective_variance, orthogonal_distance,
            force_only
        model_contact_point : str or Quantity, optional
            contact point that is held fixed in additional models, such as "1.2 um"; default: fitted
        cohesive_stress : str or Quantity, optional
            cohesive stress that is held fixed in the model maugis_dugdale, such as "5 MPa"; default: fitted
        profile : bool, default False
            intervals of E* and W by profile likelihood
        crack_speed : bool, default False
            fit of G(v) = G0 (1 + (v/v0)^n) to the edge during retraction
        exponent : float, optional
            exponent n that is held fixed in the fit of G(v); default: fitted
        machine_stiffness : str or Quantity, optional
            stiffness of the testing machine, where the displacement is that of the stage, such as "30 ± 1 N/m"
        rigid_contact : str or Quantity, optional
            file of a loop on a rigid body that gives the stiffness of the testing machine
        contact_point : str or Quantity, default 'auto'
            contact point of force-displacement fits: auto, fit, a method such as jump_in, or a displacement
        segments : Sequence[str] or str, optional
            range of samples or times that replaces a segment found; also cut=400 for cycles, "ignore=30:35 (slip)" for excluded data,
            such as "loading=120:900"
        baseline_share : float, optional
            share of the record, from the start, that is free flight; default: found from the record
        drift : str or Quantity, default 'auto'
            drift of the force zero in time: auto, none, linear, quadratic, cubic, or extrapolate (only the free flight before contact)
        force_zero : str or Quantity, optional
            zero of force for a record without free flight; no drift is removed, such as "0 N"
        displacement_drift : str or Quantity, optional
            drift rate of the displacement, where known, such as "0.1 nm/s"
        area_ratio : float, default 1.0
            ratio of true to apparent area of the hard surface, for losses per true area
        samples_dropped : int, default 3
            number of samples left out after the jump into contact
        relaxation : Sequence[str] or str, optional
            term SHARE:TIME of the bulk's relaxation E(t)/E∞ = 1 + Σ g e^(−t/τ), which is removed from the force first, such as
            "0.1:20s"
        unweighted : bool, default False
            ordinary least squares in radius or depth, without errors of force
        no_drift : bool, default False
            constant zero of force, from the free flight before contact: drift none
        whole_retraction : bool, default False
            fit of the retraction from the largest force on, pinned stretch included
        retraction_modulus_free : bool, default False
            E* as a free parameter of the retraction fit (Eq. S2)

        Returns
        -------
        LoopFit
            fits of every route by name, with E*, W, pull-off force and loss

        Raises
        ------
        InvalidArgument
            for a value outside its domain, with another dimension or without its unit
        UndefinedDataError
            for too few defined values

        Examples
        --------
        >>> import setae
        >>> import setae
        >>> fit = setae.loop("loop_laboratory.csv", radius="1 mm").fit()
        >>> f"E* = {fit.E_star.to('MPa').value:.3f} MPa, W = {fit.W.to('mJ/m2').value:.2f} mJ/m2"
        'E* = 1.000 MPa, W = 50.01 mJ/m2'
        """
        wanted = {
            "models": texts(models),
            "branch": branch,
            "errors": errors,
            "model_contact_point": model_contact_point,
            "cohesive_stress": cohesive_stress,
            "profile": profile,
            "crack_speed": crack_speed,
            "exponent": exponent,
        }
        answer = self._answer(wanted, dict(settings))
        return LoopFit(answer.fit, {"record": answer.record, "loading": answer.loading, "unloading": answer.unloading})

    def energy(self, **settings: Unpack[LoopSettings]) -> LoopEnergy:
        """Energy budget: work in and out, jumps, loss of a smooth sphere, loss per area."""
        return LoopEnergy(self._answer({}, dict(settings)).energy)

    def machine_stiffness(self) -> MachineStiffness:
        """Stiffness from a loop on a rigid body: slope of force against the position of the stage."""
        return MachineStiffness(_setae.machine_stiffness(self._opened))

    def save(self, file: Path, **metadata: Text) -> None:
        """Writes a loop file in SI, its columns in their order, with metadata such as ``sphere_radius="1.25 mm"`` or ``surface="UNCD"``."""
        self._opened.save(path(file), {name: text(value, name) for name, value in metadata.items()})

    def to_pandas(self) -> Any:
        """As a DataFrame of pandas; units and metadata are in ``attrs``. :func:`loop` takes it."""
        import pandas

        frame = pandas.DataFrame(dict(self.columns))
        frame.attrs.update({"units": dict(self.units), **self._header})
        return frame

    def to_xarray(self) -> Any:
        """As a Dataset of xarray along the samples; metadata are in ``attrs``. :func:`loop` takes it."""
        import xarray

        columns = {name: ("sample", values, {"units": self.units[name]}) for name, values in self.columns.items()}
        return xarray.Dataset(columns, attrs=self._header)

    @property
    def _header(self) -> dict[str, str]:
        """Metadata that a table of the loop can contain: not those of the file itself."""
        own = ("file", "format", "header", "mapping", "version")
        return {key: value for key, value in self.metadata.items() if key not in own}

    def plot(self, ax: Any = None, **style: Any) -> Any:
        """Plots force against displacement, or contact radius, on axes of matplotlib; ``style``: keywords of matplotlib."""
        from ._plot import plot_loop

        return plot_loop(self, ax, **style)


def curve_file(source: Source | Loop, name: str, units: Mapping[str, str] | None) -> str | Given:
    """A path, or the table of a loop or a table in memory as a file."""
    return as_file(source.to_xarray() if isinstance(source, Loop) else source, name, units)


def files_of(*, camera: Source | None = None, frame_rate: float | None = None, fringes: bool = False, curve_number: int | None = None,
             columns: Mapping[str, str] | None = None, **texts: Text | None) -> dict[str, Any]:
    """Attributes of LoopFiles; arguments that are not given keep their defaults."""
    names = ("mapping", "camera_mapping", "clock_offset", "pixel_size", "spring_constant", "sensitivity")
    return {
        **texts_of(_setae.LoopFiles, **{name: texts.get(name) for name in names}),
        "camera": "" if camera is None else as_file(camera, "camera"),
        "mapping_folder": MAPPINGS,
        "frame_rate": frame_rate,
        "fringes": fringes,
        "curve_number": curve_number,
        "columns": [f"{role}={chosen}" for role, chosen in (columns or {}).items()],
    }


def loop_files(given: Mapping[str, Any]) -> _setae.LoopFiles:
    """The request of the library for :func:`files_of`, which keeps tables in memory."""
    return filled(_setae.LoopFiles(), **{**given, "camera": path(given["camera"])})


def bodies_of(*, radius: Text | None = None, lens_height: Text | None = None, layer_thickness: Text | None = None,
              poisson_ratio: float | None = None, counter_youngs_modulus: Text | None = None,
              counter_poisson_ratio: float | None = None) -> dict[str, Any]:
    """Attributes of LoopBodies."""
    return {
        **texts_of(_setae.LoopBodies, radius=radius, lens_height=lens_height, layer_thickness=layer_thickness,
                   counter_youngs_modulus=counter_youngs_modulus),
        "poisson_ratio": poisson_ratio,
        "counter_poisson_ratio": counter_poisson_ratio,
    }


def checked_bodies(given: Mapping[str, Any]) -> _setae.LoopBodies:
    """The bodies. Raises an error for wrong values."""
    bodies = filled(_setae.LoopBodies(), **given)
    bodies.check()
    return bodies


@renamed("nu", "counter_E", "counter_nu", "pixel")
def loop(
    file: Source | Loop,
    *,
    units: Mapping[str, str] | None = None,
    radius: Text | None = None,
    poisson_ratio: float | None = None,
    counter_youngs_modulus: Text | None = None,
    counter_poisson_ratio: float | None = None,
    lens_height: Text | None = None,
    layer_thickness: Text | None = None,
    mapping: str | None = None,
    camera: Source | None = None,
    camera_mapping: str | None = None,
    clock_offset: Text | None = None,
    pixel_size: Text | None = None,
    frame_rate: float | None = None,
    fringes: bool = False,
    spring_constant: Text | None = None,
    sensitivity: Text | None = None,
    curve_number: int | None = None,
    columns: Mapping[str, str] | None = None,
) -> Loop:
    """A loop from a table with units in the header, a loop file, a workbook, a force curve, or a table in memory.

    A table in memory is a DataFrame of pandas, a Dataset of xarray, a dictionary of arrays, also of pint, or a structured array. Its units
    are in names of columns ("force [mN]"), in ``attrs["units"]``, in arrays of pint, or in ``units``. The camera's table may be in memory,
    too, such as the result of :func:`contact_radii`.

    Parameters
    ----------
    file : str or path or table or Loop
        path of a file, or a table in memory
    units : Mapping[str, str], optional
        units of columns of a table in memory, where neither names nor attributes state them, such as {'force': 'mN'}
    radius : str or Quantity, optional
        radius of the sphere; fits of loops include a given ±, such as "7.5 um"; default: as the file states
    poisson_ratio : float, optional
        Poisson ratio of the soft body, from 0 to 0.5; default: 0.5
    counter_youngs_modulus : str or Quantity, optional
        Young's modulus of the counter-body, such as "70 GPa"; default: rigid
    counter_poisson_ratio : float, optional
        Poisson ratio of the counter-body, from 0 to 0.5; default: 0
    lens_height : str or Quantity, optional
        height of the soft sphere above the mount; fits are corrected for the finite height, such as "3 ± 0.1 mm"
    layer_thickness : str or Quantity, optional
        thickness of a soft layer on a rigid base; fits are corrected for the finite thickness, such as "0.5 mm"
    mapping : str, optional
        mapping (TOML) that names the columns of a foreign table: a file or a known name, such as "eoh"
    camera : str or path or table, optional
        camera record with a separate clock: a table of time and contact_radius, a TIFF stack, an AVI or a folder of pictures
    camera_mapping : str, optional
        mapping (TOML) of the camera's table
    clock_offset : str or Quantity, optional
        time that is added to the camera's times, such as "0.12 s"; default: found from the records
    pixel_size : str or Quantity, optional
        size of a pixel in the camera's pictures, such as "1.82 um"
    frame_rate : float, optional
        frames per second of the camera
    fringes : bool, default False
        pictures show Newton's rings around the contact; the innermost ring is the edge
    spring_constant : str or Quantity, optional
        spring constant of the cantilever of a force curve, such as "0.05 N/m"
    sensitivity : str or Quantity, optional
        deflection sensitivity of the cantilever of a force curve, such as "55 nm/V"
    curve_number : int, optional
        number of one force curve in a file of many, as the file counts them, from 0; default: `setae jkr fit` fits every curve
    columns : Mapping[str, str], optional
        columns of the file by their role (force, displacement, contact_radius, time), such as {'force': 'Load'}, with a missing unit as
        in {'force': 'Kraft[uN]'}, or an expression over columns; default: guessed from names and units

    Returns
    -------
    Loop
        columns in SI, with the properties of the bodies; its methods fit them

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
    >>> depth = numpy.concatenate([numpy.linspace(-1e-6, 1e-6, 101), numpy.linspace(1e-6, -1e-6, 101)])
    >>> force = setae.models.hertz(depth, radius=1e-3, contact_modulus=1e6, zero_outside=True)
    >>> loop = setae.loop({"force [N]": force, "displacement [m]": depth, "time [s]": numpy.arange(202.0)}, radius="1 mm")
    >>> loop["force"].size, loop.units["displacement"]
    (202, 'm')
    """
    files = files_of(
        mapping=mapping,
        camera=camera,
        camera_mapping=camera_mapping,
        clock_offset=clock_offset,
        pixel_size=pixel_size,
        frame_rate=frame_rate,
        fringes=fringes,
        spring_constant=spring_constant,
        sensitivity=sensitivity,
        curve_number=curve_number,
        columns=columns,
    )
    bodies = bodies_of(radius=radius, lens_height=lens_height, layer_thickness=layer_thickness, poisson_ratio=poisson_ratio,
                       counter_youngs_modulus=counter_youngs_modulus, counter_poisson_ratio=counter_poisson_ratio)
    checked_bodies(bodies)
    opened = Loop(curve_file(file, "loop", units), tuple(files.items()), tuple(bodies.items()))
    opened._opened  # noqa: B018
    return opened
