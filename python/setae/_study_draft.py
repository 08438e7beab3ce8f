# SPDX-License-Identifier: GPL-3.0-or-later
"""Drafts of studies from folders of files."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass, field

from . import _setae
from ._errors import InvalidArgument
from ._options import MAPPINGS, Path, path
from ._results import Answer


@dataclass(frozen=True, repr=False)
class StudyDraft(Answer):
    """Draft of a study, as printed by ``setae study init --json``: numbers of surfaces, measurements and loops, and the files left out."""

    tables = ("left_out",)

    toml: str = field(default="", compare=False)  #: text of the study file, in which comments with "?" mark missing metadata

    def save(self, *, replace: bool = False) -> str:
        """Writes the study file, and returns its path. An existing file is replaced only with ``replace``."""
        file = str(self._data["study"])
        try:
            with open(file, "w" if replace else "x", encoding="utf-8") as written:
                written.write(self.toml)
        except FileExistsError:
            raise InvalidArgument(f"{file}: file exists; expected another file of the draft, or save(replace=True)") from None
        return file

    def __repr__(self) -> str:
        counts = {name: self._data[name] for name in ("surfaces", "measurements", "loops", "micrographs")}
        return f"StudyDraft({', '.join(f'{count} {name}' for name, count in counts.items())}, {len(self._data['left_out'])} files left out)"


def draft_study(folders: Path | Sequence[Path], *, file: Path = "study.toml") -> StudyDraft:
    """A draft of a study from folders of measurements, micrographs and loops, as ``setae study init``. :meth:`StudyDraft.save` writes it.

    Parameters
    ----------
    folders : str or path or Sequence[str or path]
        folders, or files; the files of one folder are measurements of one surface
    file : str or path, default 'study.toml'
        study file; paths in the draft are relative to its folder

    Returns
    -------
    StudyDraft
        text of the study file and what it contains; :meth:`StudyDraft.save` writes it

    Raises
    ------
    FileError
        for a folder that cannot be read
    InvalidArgument
        where no measurement, loop, spectrum or micrograph is found

    Examples
    --------
    >>> import setae
    >>> draft = setae.draft_study("line_two_waves.csv")
    >>> draft["measurements"]
    1
    """
    listed = [folders] if isinstance(folders, (str, os.PathLike)) else list(folders)
    toml, entry = _setae.draft_study(list(map(path, listed)), path(file), MAPPINGS)
    draft = StudyDraft(entry, toml)
    if not any(draft[name] for name in ("surfaces", "loops", "micrographs")):
        reasons = "; ".join(left["reason"] for left in draft.data["left_out"])
        raise InvalidArgument(f"no measurement, loop, spectrum or micrograph found{': ' if reasons else ''}{reasons}")
    return draft
