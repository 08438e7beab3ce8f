# SPDX-License-Identifier: GPL-3.0-or-later
"""From measured roughness to soft adhesion: the libraries of the program ``setae`` for Python.

>>> import setae
>>> scan = setae.read("afm.spm").level().despike()                              # doctest: +SKIP
>>> psd = setae.power_spectrum(scan, tip_radius="10 ± 2 nm")                    # doctest: +SKIP
>>> w = setae.work_of_adhesion(scan, youngs_modulus="1.9 MPa", W_int="37 mJ/m2", surface_energy="25 mJ/m2")   # doctest: +SKIP

Results are in SI with unit, standard error, band and source. Arguments with a unit are texts with the unit. The guide is docs/guides/python.md.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from . import models
from ._about import steps, version
from ._adhesion import WorkOfAdhesion, work_of_adhesion
from ._contact import (
    Contact,
    ContactComparison,
    ContactFront,
    ContactSweep,
    PerssonContact,
    contact,
    contact_comparison,
    contact_front,
    contact_sweep,
    persson,
)
from ._containers import Container, ContainerReport, Formats, check_container, formats, write_container
from ._diagnosis import Diagnosis, Finding, check
from ._errors import Error, FileError, FormatError, InternalError, InvalidArgument, UndefinedDataError
from ._fits import Fitted, SpectrumFit
from ._laboratory import (
    Camera,
    ContactLine,
    ContactRadii,
    Contour,
    ForceCurves,
    Lens,
    Replicates,
    camera,
    contact_line,
    contact_radii,
    contour,
    force_curves,
    lens,
    replicates,
)
from ._loops import Loop, LoopEnergy, LoopFit, MachineStiffness, loop
from ._names import former_function
from ._quantities import Alert, Band, Interval, Quantity, quantity
from ._results import Answer, Result
from ._scales import FunctionOfScale, autocorrelation, scale_dependent_roughness, variable_bandwidth
from ._schema import schema
from ._scan import Info, Processing, Scan, Step, channels, info, lengths, read, scan
from ._spectra import Parameters, PowerSpectrum, Surface, parameters, power_spectrum, surface
from ._study import Figure, PatchSurvey, StudyResult, patch_survey
from ._study_building import Study, study
from ._synthesis import Synthesis, Tip, synthesize, tip
from ._study_draft import StudyDraft, draft_study
from ._texture import Texture, texture
from ._threads import limit_threads
from ._together import ForceCurveSeries, SharedFit, fit_together, force_curve_series

__version__ = version().partition("+")[0]

if not TYPE_CHECKING:  # type checkers report former names as unknown

    def __getattr__(name: str) -> Any:
        return former_function(name, globals())


__all__ = [
    "Alert",
    "Answer",
    "Band",
    "Camera",
    "Contact",
    "ContactComparison",
    "ContactLine",
    "ContactRadii",
    "ContactFront",
    "ContactSweep",
    "Container",
    "ContainerReport",
    "Contour",
    "Diagnosis",
    "Error",
    "Figure",
    "FileError",
    "Finding",
    "Fitted",
    "ForceCurveSeries",
    "ForceCurves",
    "FormatError",
    "Formats",
    "FunctionOfScale",
    "Info",
    "InternalError",
    "Interval",
    "InvalidArgument",
    "Lens",
    "Loop",
    "LoopEnergy",
    "LoopFit",
    "MachineStiffness",
    "Parameters",
    "PatchSurvey",
    "PerssonContact",
    "PowerSpectrum",
    "Processing",
    "Quantity",
    "Replicates",
    "Result",
    "Scan",
    "SharedFit",
    "SpectrumFit",
    "Step",
    "Study",
    "StudyDraft",
    "StudyResult",
    "Surface",
    "Synthesis",
    "Texture",
    "Tip",
    "UndefinedDataError",
    "WorkOfAdhesion",
    "__version__",
    "autocorrelation",
    "camera",
    "channels",
    "check",
    "check_container",
    "contact",
    "contact_comparison",
    "contact_line",
    "contact_radii",
    "contact_front",
    "contact_sweep",
    "contour",
    "draft_study",
    "fit_together",
    "force_curve_series",
    "force_curves",
    "formats",
    "info",
    "lengths",
    "lens",
    "limit_threads",
    "loop",
    "models",
    "parameters",
    "patch_survey",
    "persson",
    "power_spectrum",
    "quantity",
    "read",
    "replicates",
    "scale_dependent_roughness",
    "scan",
    "schema",
    "steps",
    "study",
    "surface",
    "synthesize",
    "texture",
    "tip",
    "variable_bandwidth",
    "version",
    "work_of_adhesion",
    "write_container",
]
