# SPDX-License-Identifier: GPL-3.0-or-later
"""Containers of contact.engineering, and the formats that are read and written."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Union

from . import _setae
from ._options import Path, Text, filled, path, text
from ._quantities import Answer

#: A value of all files, or of each by its name.
Stated = Union[Text, int, Mapping[str, Union[Text, int]], None]


class Container(Answer):
    """A container that was written, as ``setae container write --json`` says it."""


class ContainerReport(Answer):
    """What containers hold and what is wrong in them, as ``setae container check --json`` says it."""


class Formats(Answer):
    """Every format that is read or written: "formats" of topographies, "force_curves", "micrographs"."""


def stated(values: Stated) -> list[str]:
    if values is None:
        return []
    if isinstance(values, Mapping):
        return [f"{file}={text(value)}" for file, value in values.items()]
    return [text(values)]


def write_container(
    output: Path,
    files: Sequence[Path] = (),
    *,
    taken_over: Sequence[Path] = (),
    name: str | None = None,
    description: str | None = None,
    size: Stated = None,
    unit: Stated = None,
    channel: Stated = None,
    detrend: Stated = None,
    layout: str | None = None,
    keep_values: bool = False,
    skip_failed: bool = False,
) -> Container:
    """Writes a container that contact.engineering opens: measured files become one surface, containers among them keep theirs.

    taken_over: containers and studies (.toml) whose surfaces go in.  size, unit, channel, detrend: what files leave open, of all or by file:
    ``unit={"scan.npy": "nm"}``.  skip_failed: what cannot be read is left out; else its error is raised and nothing is written.
    """
    request = filled(
        _setae.ContainerRequest(),
        output=path(output),
        files=[path(file) for file in files],
        taken_over=[path(file) for file in taken_over],
        name=name,
        description=description,
        sizes=stated(size),
        units=stated(unit),
        channels=stated(channel),
        trends=stated(detrend),
        layout=layout,
        keep_values=keep_values,
        every_file=not skip_failed,
    )
    return Container(_setae.write_container(request))


def check_container(*files: Path) -> ContainerReport:
    """What containers hold, what is wrong in them, and whether they are the same after writing and reading."""
    return ContainerReport(_setae.check_containers([path(file) for file in files]))


def formats() -> Formats:
    """Every format that is read or written.

    >>> "x3p" in [entry["identifier"] for entry in formats().data["formats"]]
    True
    """
    return Formats(_setae.formats())
