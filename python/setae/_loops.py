# SPDX-License-Identifier: GPL-3.0-or-later
"""Contact experiments: force, displacement and contact radius of a soft sphere pressed on and pulled off."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Any

from . import _setae
from ._options import MAPPINGS, Path, Text, filled, path, text, texts
from ._quantities import Alert, Answer, Quantity, alerts_from

if TYPE_CHECKING:
    from ._columns import Array


class LoopFit(Answer):
    """Everything that is fitted to a loop, as ``setae jkr fit --json`` prints it: ``fit["loading"]["fits"]["joint"]``, ``fit["pull_off"]`` …"""

    @property
    def E_star(self) -> Quantity:
        """Contact modulus of loading [Pa], by the fit that counts."""
        found: Quantity = self["loading"]["contact_modulus"]
        return found

    @property
    def W(self) -> Quantity:
        """Work of adhesion of loading [J/m²], by the fit that counts."""
        found: Quantity = self["loading"]["work_of_adhesion"]
        return found

    @property
    def loss(self) -> Quantity | None:
        """Energy of the closed loop [J]; None where it could not be had, which ``fit["loop_reason"]`` says."""
        loop = self["loop"]
        return None if loop is None else loop["energy"]

    def __repr__(self) -> str:
        lost = "" if self.loss is None else f", E_loss = {self.loss}"
        return f"LoopFit(E* = {self.E_star}, W = {self.W}{lost})"


class MachineStiffness(Answer):
    """Stiffness of the machine, as ``setae jkr stiffness --json`` prints it."""

    @property
    def stiffness(self) -> Quantity:
        """[N/m]"""
        found: Quantity = self["machine_stiffness"]
        return found


class LoopEnergy(Answer):
    """Where the energy of a loop goes, as ``setae jkr energy --json`` prints it."""


@dataclass(frozen=True, eq=False)
class Loop:
    """A loop as it was read, in SI, and what is known of the bodies."""

    file: str
    files: tuple[tuple[str, Any], ...] = field(default=(), repr=False)
    bodies: tuple[tuple[str, Any], ...] = field(default=(), repr=False)

    @cached_property
    def _opened(self) -> _setae.Loop:
        return _setae.open_loop(self.file, filled(_setae.LoopFiles(), **dict(self.files)))

    def __getstate__(self) -> dict[str, Any]:
        return {"file": self.file, "files": self.files, "bodies": self.bodies}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state)

    @property
    def columns(self) -> dict[str, Array]:
        """"force" [N], "displacement" [m], "contact_radius" [m], "time" [s], as far as the file has them."""
        return self._opened.columns

    @property
    def units(self) -> dict[str, str]:
        return self._opened.units

    @property
    def metadata(self) -> dict[str, str]:
        return self._opened.metadata

    @property
    def alerts(self) -> tuple[Alert, ...]:
        return alerts_from(json.loads(self._opened.alerts))

    def __getitem__(self, name: str) -> Any:
        return self.columns[name]

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
        **settings: Any,
    ) -> LoopFit:
        """E*, W, pull-off and loss by every route, with their ±; ``models``: "hertz", "dmt", "maugis_dugdale" … or "all" beside them.

        settings: ``machine_stiffness``, ``contact_point``, ``segments``, ``relaxation``, ``area_ratio``, ``samples_dropped``, ``unweighted``,
        ``drift``, ``no_drift``, ``force_zero``, ``whole_retraction`` … as the options of ``setae jkr fit``.
        """
        wanted = {
            "models": texts(models),
            "branch": branch,
            "errors": errors,
            "contact_point": text(model_contact_point),
            "cohesive_stress": text(cohesive_stress),
            "profile": profile,
            "crack_speed": crack_speed,
            "exponent": exponent,
        }
        return LoopFit(self._answer(wanted, settings).fit)

    def energy(self, **settings: Any) -> LoopEnergy:
        """Where the energy goes: work in and out, jumps, the smooth sphere's own loss, loss per area."""
        return LoopEnergy(self._answer({}, settings).energy)

    def machine_stiffness(self) -> MachineStiffness:
        """Of a loop on something rigid: slope of force against the stage's position."""
        return MachineStiffness(_setae.machine_stiffness(self._opened))

    def plot(self, ax: Any = None) -> Any:
        """Force against displacement, or contact radius, on axes of matplotlib."""
        from ._plot import plot_loop

        return plot_loop(self, ax)


def files_of(*, frame_rate: float | None = None, fringes: bool = False, curve_number: int | None = None,
             columns: Mapping[str, str] | None = None, **texts: Text | None) -> dict[str, Any]:
    """Attributes of LoopFiles; what is not named is left open."""
    names = ("mapping", "camera", "camera_mapping", "clock_offset", "pixel", "spring_constant", "sensitivity")
    return {
        **{name: text(texts.get(name)) for name in names},
        "mapping_folder": MAPPINGS,
        "frame_rate": frame_rate,
        "fringes": fringes,
        "curve_number": curve_number,
        "columns": [f"{role}={chosen}" for role, chosen in (columns or {}).items()],
    }


def bodies_of(*, radius: Text | None = None, lens_height: Text | None = None, layer_thickness: Text | None = None, nu: float | None = None,
              counter_E: Text | None = None, counter_nu: float | None = None) -> dict[str, Any]:
    """Attributes of LoopBodies."""
    return {
        "radius": text(radius),
        "lens_height": text(lens_height),
        "layer_thickness": text(layer_thickness),
        "nu": nu,
        "counter_E": text(counter_E),
        "counter_nu": counter_nu,
    }


def checked_bodies(given: Mapping[str, Any]) -> _setae.LoopBodies:
    """The bodies; what is wrong with them is raised."""
    bodies = filled(_setae.LoopBodies(), **given)
    bodies.check()
    return bodies


def loop(
    file: Path,
    *,
    radius: Text | None = None,
    nu: float | None = None,
    counter_E: Text | None = None,
    counter_nu: float | None = None,
    lens_height: Text | None = None,
    layer_thickness: Text | None = None,
    mapping: str | None = None,
    camera: Path | None = None,
    camera_mapping: str | None = None,
    clock_offset: Text | None = None,
    pixel: Text | None = None,
    frame_rate: float | None = None,
    fringes: bool = False,
    spring_constant: Text | None = None,
    sensitivity: Text | None = None,
    curve_number: int | None = None,
    columns: Mapping[str, str] | None = None,
) -> Loop:
    """A loop: a table with units in the header, setae's loop file, a workbook, a force curve.

    radius: of the sphere, where the file does not say it.  mapping: names the columns of a foreign table, by its file or its name.
    columns: overrules what names and units say: ``{"force": "Load"}``, ``{"force": "Kraft[uN]"}`` with a unit that the header lacks, or an
    expression, ``{"force": "-1 * load"}``.  camera: its own table of times and contact radii, or its pictures.
    """
    files = files_of(
        mapping=mapping,
        camera="" if camera is None else path(camera),
        camera_mapping=camera_mapping,
        clock_offset=clock_offset,
        pixel=pixel,
        frame_rate=frame_rate,
        fringes=fringes,
        spring_constant=spring_constant,
        sensitivity=sensitivity,
        curve_number=curve_number,
        columns=columns,
    )
    bodies = bodies_of(radius=radius, lens_height=lens_height, layer_thickness=layer_thickness, nu=nu, counter_E=counter_E,
                       counter_nu=counter_nu)
    checked_bodies(bodies)
    opened = Loop(path(file), tuple(files.items()), tuple(bodies.items()))
    opened._opened  # noqa: B018
    return opened
