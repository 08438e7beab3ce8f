# SPDX-License-Identifier: GPL-3.0-or-later
"""From measured roughness to soft adhesion: the libraries of the program ``setae`` for Python.

>>> import setae
>>> scan = setae.read("afm.spm").level().despike()                              # doctest: +SKIP
>>> psd = setae.power_spectrum(scan, tip_radius="10 ± 2 nm")                    # doctest: +SKIP
>>> w = setae.work_of_adhesion(scan, E="1.9 MPa", W_int="37 mJ/m2", gamma="25 mJ/m2")   # doctest: +SKIP

Numbers are SI and carry unit, ±, band and source; what has a unit goes in as a text with it. docs/guides/python.md is the guide.
"""

from __future__ import annotations

from ._adhesion import WorkOfAdhesion, work_of_adhesion
from ._diagnosis import Diagnosis, Finding, check
from ._errors import Error, FileError, FormatError, InternalError, InvalidArgument, UndefinedDataError
from ._loops import Loop, LoopEnergy, LoopFit, loop
from ._quantities import Alert, Answer, Band, Interval, Quantity
from ._scales import FunctionOfScale, autocorrelation, scale_dependent, variable_bandwidth
from ._scan import Info, Processing, Scan, Step, channels, info, lengths, read, scan
from ._setae import limit_threads, steps, version
from ._spectra import Parameters, PowerSpectrum, Surface, parameters, power_spectrum, surface
from ._study import Figure, Study, StudyResult, study

__version__ = version().partition("+")[0]

__all__ = [
    "Alert",
    "Answer",
    "Band",
    "Diagnosis",
    "Error",
    "Figure",
    "FileError",
    "Finding",
    "FormatError",
    "FunctionOfScale",
    "Info",
    "InternalError",
    "Interval",
    "InvalidArgument",
    "Loop",
    "LoopEnergy",
    "LoopFit",
    "Parameters",
    "PowerSpectrum",
    "Processing",
    "Quantity",
    "Scan",
    "Step",
    "Study",
    "StudyResult",
    "Surface",
    "UndefinedDataError",
    "WorkOfAdhesion",
    "__version__",
    "autocorrelation",
    "channels",
    "check",
    "info",
    "lengths",
    "limit_threads",
    "loop",
    "parameters",
    "power_spectrum",
    "read",
    "scale_dependent",
    "scan",
    "steps",
    "study",
    "surface",
    "variable_bandwidth",
    "version",
    "work_of_adhesion",
]
