# SPDX-License-Identifier: GPL-3.0-or-later
"""Studies: surfaces, elastomers and loops of one study file, and their results."""

from __future__ import annotations

import pathlib
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Any

from . import _setae
from ._errors import InvalidArgument
from ._given import shown
from ._names import former_method, renamed
from ._options import MAPPINGS, Path, filled, require
from ._quantities import Quantity
from ._results import Answer

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._generated import PatchSurveyRequest


@dataclass(frozen=True)
class Figure:
    """A figure of a study, which notebooks display."""

    study: StudyResult = field(repr=False)
    identifier: str

    @property
    def handle(self) -> _setae.StudyFigure:
        return self.study._drawings[self.identifier]

    @property
    def title(self) -> str:
        return self.handle.title

    @property
    def caption(self) -> str:
        return self.handle.caption

    @property
    def reason(self) -> str:
        """Reason why the figure cannot be drawn; empty if it can be drawn."""
        return self.handle.reason

    def _repr_svg_(self) -> str | None:
        return None if self.reason else self.handle.drawn("svg").decode()

    def csv(self) -> str:
        """The numbers of the figure as CSV."""
        return self.handle.drawn("csv").decode()

    def save(self, file: Path) -> pathlib.Path:
        """Writes the figure; the ending gives the format: .svg, .pdf, .png or .csv. Drawing needs gnuplot."""
        target = pathlib.Path(file)
        target.write_bytes(self.handle.drawn(target.suffix.lstrip(".")))
        return target

    def __repr__(self) -> str:
        return f"Figure({self.identifier}: {self.title}{'; ' + self.reason if self.reason else ''})"


class Figures(Mapping[str, Figure]):
    """Figures of a study by the identifiers of ``setae plot --figure``."""

    def __init__(self, study: StudyResult) -> None:
        self._figures = {identifier: Figure(study, identifier) for identifier in study._drawings}

    def __getitem__(self, identifier: str) -> Figure:
        return self._figures[identifier]

    def __iter__(self) -> Iterator[str]:
        return iter(self._figures)

    def __len__(self) -> int:
        return len(self._figures)

    def _ipython_key_completions_(self) -> list[str]:
        return list(self)


class StudyResult(Answer):
    """Results of a study, as in study.json: "surfaces", "pairs", "fits", "experiments" …, with figures and report."""

    file: str
    _options: tuple[str, str | None]  #: folder of outputs, and folder of kept results, for the same run in another process

    @classmethod
    def of(cls, file: str, output: str, cache: str | None) -> StudyResult:
        """Runs a study file; ``cache``: folder of kept results, "" for that of the user, None for no kept results."""
        run = _setae.run_study(file, output, cache, MAPPINGS)
        result = cls(run.json())
        result.__dict__.update(file=file, _options=(output, cache), handle=run)
        return result

    def __getstate__(self) -> dict[str, Any]:
        return {"text": self.text, "file": self.file, "_options": self._options}

    @cached_property
    def handle(self) -> _setae.StudyRun:
        """The results in the library. Another process takes them from the kept results, or runs the study again.

        :raises InvalidArgument: if the study file or a file of a measurement has changed
        """
        run = _setae.run_study(self.file, *self._options, MAPPINGS)
        if shown(run.json()) != self.text:
            raise InvalidArgument(f"{self.file}: the study has other results than those that were pickled; expected unchanged files, or a new run")
        return run

    @cached_property
    def _drawings(self) -> dict[str, _setae.StudyFigure]:
        return {figure.identifier: figure for figure in _setae.figures_of(self.handle)}

    @property
    def work_of_adhesion(self) -> Quantity | None:
        """Fitted W_int; None without a fit."""
        found: Quantity | None = self.get("work_of_adhesion")
        return found

    @property
    def figures(self) -> Figures:
        return Figures(self)

    def summary(self, width: int = 100) -> str:
        """Every table as text, the verdict first."""
        require("a whole number", width=width)
        return self.handle.summary(width)

    def budget(self, width: int = 100) -> str:
        """Contributions of the inputs to each standard error, as text."""
        require("a whole number", width=width)
        return self.handle.budget(width)

    def next_measurements(self, target: str = "W_int") -> Answer:
        """Standard error of ``target`` after one further measurement, as printed by ``setae study --next --json``."""
        require("a text", target=target)
        return Answer(self.handle.next_measurements(target))

    def predict(self, *, trials: int = 0, seed: int = 1, threads: int = 0) -> Answer:
        """W_ret, pull-off force and loss of every pair, with the retraction models, as printed by ``setae predict --json``."""
        require("a whole number", trials=trials, seed=seed, threads=threads)
        return Answer(self.handle.predict(trials, seed, threads))

    def patch_survey(self, **patches: Unpack[PatchSurveyRequest]) -> PatchSurvey:
        """Random patches with the spectra and U_el/(A W) of the pairs of the study; ``patches``: arguments of :func:`patch_survey`."""
        options: Any = patches
        return patch_survey(self, **options)

    conform = former_method("conform", patch_survey)

    def report(self, file: Path | None = None) -> str:
        """The report, one HTML page that works offline; written to ``file`` if it is given."""
        page = self.handle.report(f"setae study {self.file}")
        if file is not None:
            pathlib.Path(file).write_text(page, encoding="utf-8")
        return page

    def write(self) -> tuple[str, ...]:
        """Writes study.json and the tables to the output folder of the study; returns the names of the files."""
        return tuple(self.handle.write_tables())

    def __repr__(self) -> str:
        return self.summary()

    def _repr_html_(self) -> str:
        import html

        return f"<pre>{html.escape(self.summary())}</pre>"


class PatchSurvey(Answer):
    """Contact of random patches, as printed by ``setae lab conform --json``; ``rows``: one entry per kind of patch."""

    tables = ("rows",)


@renamed("seeds")
def patch_survey(
    of: StudyResult | None = None,
    *,
    energy_shares: Sequence[float] | None = None,
    points: Sequence[int] | None = None,
    points_per_wave: Sequence[float] | None = None,
    squared_ratios: Sequence[float] | None = None,
    waves_per_side: float | None = None,
    hurst_exponent: float | None = None,
    law: str | None = None,
    realisations: int | None = None,
    seed: int | None = None,
    loops: bool = False,
) -> PatchSurvey:
    """Contact of random patches with adhesion, as ``setae lab conform --json``: full contact or partial contact.

    With a study, the patches have the spectra and U_el/(A W) of its pairs. Without a study, energy_shares gives U_el/(A W).

    Parameters
    ----------
    of : StudyResult, optional
        result of a study, whose pairs give the spectra and energies of the patches
    energy_shares : Sequence[float], optional
        ratio U_el/(A W) of stored to gained energy of the patches
    points : Sequence[int], optional
        number of points along each side of a patch
    points_per_wave : Sequence[float], optional
        number of points per shortest wavelength
    squared_ratios : Sequence[float], optional
        ratio w dx/(E* ρ²) of the grid, at most 1, which sets the range of the attraction
    waves_per_side : float, optional
        number of longest wavelengths along each side of a patch
    hurst_exponent : float, optional
        Hurst exponent of patches, where no study gives the spectrum
    law : str, optional
        decay of the attraction with the gap; one of exponential, cubic, dugdale, lennard_jones
    realisations : int, optional
        number of patches of each kind
    seed : int, optional
        seed of the first patch; further patches use the next numbers
    loops : bool, default False
        whole loops as well, which take minutes instead of seconds

    Returns
    -------
    PatchSurvey
        one entry per kind of patch

    Raises
    ------
    InvalidArgument
        for a value outside its domain, with another dimension or without its unit

    Examples
    --------
    >>> import setae
    >>> found = setae.patch_survey(energy_shares=[0.05], points=[64], points_per_wave=[8], realisations=2)
    >>> found["rows"][0]["area_from_far"]["value"]
    1.0
    """
    request = filled(
        _setae.PatchSurveyRequest(),
        energy_shares=energy_shares,
        points=points,
        points_per_wave=points_per_wave,
        squared_ratios=squared_ratios,
        waves_per_side=waves_per_side,
        hurst_exponent=hurst_exponent,
        law=law,
        realisations=realisations,
        seed=seed,
        loops=loops,
    )
    return PatchSurvey(_setae.conform(None if of is None else of.handle, request))
