# SPDX-License-Identifier: GPL-3.0-or-later
"""Containers of contact.engineering, and the supported formats."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, Union

from . import _setae
from ._given import Given, is_path, plain_name, saved
from ._names import renamed
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


@renamed("detrend")
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
    trend: Stated = None,
    layout: str | None = None,
    keep_values: bool = False,
    skip_failed: bool = False,
) -> Container:
    """Writes a container for contact.engineering. Measured files and scans become one surface; containers keep their surfaces.

    Scans and other heights in memory are written after all steps.

    Missing size, unit, channel and trend are given for all files, or by file: ``unit={"scan.npy": "nm"}``.

    Parameters
    ----------
    output : str or path
        container that is written, a ZIP archive
    files : Sequence[scan, str, path, array, table or a list of them], default ()
        measured files, scans and arrays, which become one surface
    taken_over : Sequence[str or path], default ()
        containers and studies (.toml) whose surfaces are taken over
    name : str, optional
        name of the surface that measured files become; default: that of the output
    description : str, optional
        description of the surface that measured files become
    size : str or int or Mapping, optional
        extent where files do not state it, of all files or of one as "FILE=1 mm x 1 mm", such as "1 mm x 1 mm"
    unit : str or int or Mapping, optional
        unit of lengths where files do not state it, of all files or of one as FILE=um, such as "um"
    channel : str or int or Mapping, optional
        channel by its number, counted from 0, or by its name, of all files or by file; default: the preferred channel
    trend : str or int or Mapping, optional
        trend that is to be removed, of all files or by file; default: mean; one of mean, tilt, parabola
    layout : str, optional
        layout of a text file: a narrow map (matrix), points x y z (columns), or the table of a spectrum (spectrum); default: from
        numbers and header; one of matrix, columns, spectrum
    keep_values : bool, default False
        values that mark missing heights (NO_DATA), such as -9999, stay heights; without it they become undefined
    skip_failed : bool, default False
        measurements that cannot be analysed are left out with a warning

    Returns
    -------
    Container
        surfaces and measurements of the written container

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
    >>> import pathlib, tempfile, setae
    >>> line = setae.scan([0.0, 2.0, 1.0, 0.0], size="3 um", unit="nm", name="line")
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     written = setae.write_container(pathlib.Path(folder) / "surface.zip", [line], name="wafer")
    ...     setae.check_container(pathlib.Path(folder) / "surface.zip")["containers"][0]["surfaces"][0]["name"]
    'wafer'
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
        trends=stated(trend),
        layout=layout,
        keep_values=keep_values,
        every_file=not skip_failed,
    )
    return Container(_setae.write_container(request))


def check_container(*files: Path) -> ContainerReport:
    """Content and problems of containers, and their differences after writing and reading.

    Parameters
    ----------
    *files : str or path
        containers: folders or ZIP archives

    Returns
    -------
    ContainerReport
        surfaces, measurements and problems of each container

    Raises
    ------
    FileError
        for a path that cannot be read
    FormatError
        for content of an unknown format, or damaged content

    Examples
    --------
    >>> import pathlib, tempfile, setae
    >>> line = setae.scan([0.0, 2.0, 1.0, 0.0], size="3 um", unit="nm")
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     written = setae.write_container(pathlib.Path(folder) / "surface.zip", [line])
    ...     len(setae.check_container(pathlib.Path(folder) / "surface.zip")["containers"])
    1
    """
    return ContainerReport(_setae.check_containers([path(file) for file in files]))


def formats() -> Formats:
    """All formats that are read or written.

    Returns
    -------
    Formats
        formats of topographies, force curves and micrographs

    Examples
    --------
    >>> "x3p" in [entry["identifier"] for entry in formats().data["formats"]]
    True
    """
    return Formats(_setae.formats())
