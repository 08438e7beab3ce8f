# SPDX-License-Identifier: GPL-3.0-or-later
"""Containers of contact.engineering, and the supported formats."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, Union

from . import _setae
from ._given import Given, is_path, plain_name, saved
from ._options import Path, Text, filled, path, text
from ._results import Answer
from ._scan import Measured, scan

#: One value for all files, or a value per file by its name.
Stated = Union[Text, int, Mapping[str, Union[Text, int]], None]


class Container(Answer):
    """A written container, as printed by ``setae container write --json``."""


class ContainerReport(Answer):
    """Content and problems of containers, as printed by ``setae container check --json``."""

    tables = ("containers",)


class Formats(Answer):
    """All supported formats: "formats" of topographies, "force_curves", "micrographs"."""

    tables = ("formats",)


def stated(values: Stated, argument: str = "") -> list[str]:
    if values is None:
        return []
    if isinstance(values, Mapping):
        return [f"{file}={text(value, argument)}" for file, value in values.items()]
    return [text(values, argument)]


def heights_of(measurement: Measured) -> Given:
    """The heights of a scan, or of other content in memory, as a file; a traced curve with the errors that it has."""
    measured = scan(measurement)
    ending = ".nc" if measured.positions is None else ".csv"
    return saved(measured.save, plain_name(str(measured.file)) + ending)


def write_container(
    output: Path,
    files: Sequence[Measured] = (),
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
    """Writes a container for contact.engineering. Measured files and scans become one surface; containers keep their surfaces.

    Scans and other heights in memory are written after all steps.

    Missing size, unit, channel and detrend are given for all files, or by file: ``unit={"scan.npy": "nm"}``.

    Parameters
    ----------
    taken_over : Sequence[str or path], default ()
        containers and studies (.toml) whose surfaces are taken over
    name : str
        name of the surface that measured files become; default: that of the output
    description : str
        description of the surface that measured files become
    size : Stated
        extent where files do not state it, of all files or of one as "FILE=1 mm x 1 mm", such as "1 mm x 1 mm"
    unit : Stated
        unit of lengths where files do not state it, of all files or of one as FILE=um, such as "um"
    channel : Stated
        channel by its number, counted from 0, or by its name, of all files or of one as FILE=1; default: the preferred channel
    detrend : Stated
        trend to be removed: mean, tilt or parabola, of all files or of one as FILE=tilt; default: mean
    layout : str
        layout of a text file: a narrow map (matrix), points x y z (columns), or the table of a spectrum (spectrum); default: from
        numbers and header; one of matrix, columns, spectrum
    keep_values : bool, default False
        values that mark missing heights (NO_DATA), such as -9999, stay heights; without it they become undefined
    skip_failed : bool, default False
        measurements that cannot be analysed are left out with a warning
    """
    measured: list[Any] = [file if is_path(file) else heights_of(file) for file in files]
    request = filled(
        _setae.ContainerRequest(),
        output=path(output),
        files=[path(file) for file in measured],
        taken_over=[path(file) for file in taken_over],
        name=name,
        description=description,
        sizes=stated(size, "size"),
        units=stated(unit),
        channels=stated(channel),
        trends=stated(detrend),
        layout=layout,
        keep_values=keep_values,
        every_file=not skip_failed,
    )
    return Container(_setae.write_container(request))


def check_container(*files: Path) -> ContainerReport:
    """Content and problems of containers, and their differences after writing and reading."""
    return ContainerReport(_setae.check_containers([path(file) for file in files]))


def formats() -> Formats:
    """All formats that are read or written.

    >>> "x3p" in [entry["identifier"] for entry in formats().data["formats"]]
    True
    """
    return Formats(_setae.formats())
