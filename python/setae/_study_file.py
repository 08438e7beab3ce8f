# SPDX-License-Identifier: GPL-3.0-or-later
"""The content of a study as a study file, with files for the measurements, spectra and loops that are in memory."""

from __future__ import annotations

import dataclasses
import json
import os
import pathlib
from collections.abc import Iterator, Mapping
from typing import Any

from ._errors import InvalidArgument
from ._given import Given, as_file, is_path, plain_name
from ._loops import Loop
from ._options import path, text
from ._results import Result
from ._scan import Scan, lengths, scan

#: Keys of a study whose values are files; relative paths are relative to the current folder, in the study file to the study file.
FILES = ("file", "mapping", "output", "pipeline", "power_spectrum", "references", "tip_file")


def is_keys(value: Any) -> bool:
    """True for a dictionary of keys; False for results and datasets, which are mappings, too."""
    return isinstance(value, Mapping) and not isinstance(value, Result) and not hasattr(value, "data_vars")


def written(value: Any) -> str:
    """A value as TOML on one line.

    >>> written({"tip_radius": "10 nm", "references": ["a.csv"], "fringes": True})
    '{ tip_radius = "10 nm", references = ["a.csv"], fringes = true }'
    """
    value = value.item() if hasattr(value, "item") and getattr(value, "ndim", 1) == 0 and not hasattr(value, "magnitude") else value
    if isinstance(value, bool):
        return str(value).lower()
    if type(value) in (int, float):
        return repr(value)
    if is_keys(value):
        return "{ " + ", ".join(f"{key(name)} = {written(entry)}" for name, entry in value.items()) + " }"
    if isinstance(value, (list, tuple)) or getattr(value, "ndim", 0) == 1:
        return "[" + ", ".join(map(written, value)) + "]"
    return json.dumps(text(value), ensure_ascii=False).replace("\x7f", "\\u007f")


def key(name: str) -> str:
    is_bare = name.isascii() and name.replace("_", "").replace("-", "").isalnum()
    return name if is_bare else json.dumps(name, ensure_ascii=False)


def lines(content: Mapping[str, Any]) -> Iterator[str]:
    """Lines of a study file: single values first, then tables."""
    tables = {name: value for name, value in content.items() if is_table(value)}
    yield from (f"{key(name)} = {written(value)}" for name, value in content.items() if name not in tables)
    for name, value in tables.items():
        if isinstance(value, list):
            for entry in value:
                yield from table(f"[[{key(name)}]]", entry)
        elif value and all(isinstance(entry, Mapping) for entry in value.values()):
            for inner, entry in value.items():
                yield from table(f"[{key(name)}.{key(inner)}]", entry)
        else:
            yield from table(f"[{key(name)}]", value)


def is_table(value: Any) -> bool:
    return isinstance(value, Mapping) or (isinstance(value, list) and bool(value) and all(isinstance(entry, Mapping) for entry in value))


def table(title: str, content: Mapping[str, Any]) -> Iterator[str]:
    yield ""
    yield title
    for name, value in content.items():
        if is_table(value) and isinstance(value, list):
            yield f"{key(name)} = ["
            yield from (f"  {written(entry)}," for entry in value)
            yield "]"
        else:
            yield f"{key(name)} = {written(value)}"


class StudyFile:
    """Writes a study file, and beside it a folder with files for content in memory."""

    def __init__(self, file: pathlib.Path) -> None:
        self.file = file
        self.data = file.parent / f"{file.stem}_data"
        self.names: set[str] = set()

    def write(self, content: Mapping[str, Any]) -> None:
        self.file.parent.mkdir(parents=True, exist_ok=True)
        complete = {name: self.converted(name, value, name) for name, value in content.items() if value is not None}
        self.file.write_text("\n".join(lines(complete)) + "\n", encoding="utf-8")

    def converted(self, name: str, value: Any, label: str) -> Any:
        """A value with paths relative to the study file; content in memory is written. ``label`` names the files."""
        if name == "surfaces":
            return {surface: self.surface(entry, surface) for surface, entry in value.items()}
        if name == "experiments":
            return [self.experiment(entry) for entry in value]
        if name in ("inputs", "costs"):
            return {inner: entry for inner, entry in value.items() if entry is not None}
        if name in FILES:
            return self.reference(name, value, label)
        if is_keys(value):
            return {inner: self.converted(inner, entry, label) for inner, entry in value.items() if entry is not None}
        if isinstance(value, (list, tuple)):
            return [self.converted("", entry, label) for entry in value]
        return value

    def reference(self, name: str, value: Any, label: str) -> Any:
        if isinstance(value, (list, tuple)):
            return [self.reference(name, entry, label) for entry in value]
        if isinstance(value, Scan):
            return self.heights(value, label)
        if not is_path(value) or isinstance(value, Given):
            return self.content(as_file(value, name), label, ".txt")
        given = os.fspath(value)
        is_known_mapping = name == "mapping" and not os.path.exists(given)
        return given if is_known_mapping or os.path.isabs(given) else os.path.relpath(given, self.file.parent)

    def place(self, label: str, ending: str) -> pathlib.Path:
        """A new file in the folder of data."""
        stem, number = plain_name(label).replace(" ", "_"), 1
        while f"{stem}_{number}{ending}" in self.names:
            number += 1
        self.names.add(f"{stem}_{number}{ending}")
        self.data.mkdir(exist_ok=True)
        return self.data / f"{stem}_{number}{ending}"

    def beside(self, file: pathlib.Path) -> str:
        return file.relative_to(self.file.parent).as_posix()

    def content(self, given: str | Given, label: str, ending: str) -> str:
        file = self.place(label, ending)
        file.write_bytes(given.content if isinstance(given, Given) else pathlib.Path(given).read_bytes())
        return self.beside(file)

    def heights(self, measured: Scan, label: str) -> str:
        """The file of a scan before its steps, or a file with its heights."""
        if measured.source is not None:
            file = self.place(label, ".nc")
            dataclasses.replace(measured, steps=(), pipeline="").save(file)
            return self.beside(file)
        if isinstance(measured.file, Given):
            return self.content(measured.file, label, ".txt")
        found: str = self.reference("file", measured.file, label)
        return found

    def surface(self, given: Mapping[str, Any], label: str) -> dict[str, Any]:
        rest = {name: value for name, value in given.items() if name != "measurements"}
        surface = {name: self.converted(name, value, label) for name, value in rest.items() if value is not None}
        if "measurements" in given:
            surface["measurements"] = [self.measurement(entry, label) for entry in given["measurements"]]
        return surface

    def measurement(self, given: Any, label: str) -> dict[str, Any]:
        """The entry of a measurement; keys that are given have priority over those of a scan."""
        given = given if is_keys(given) else {"file": given}
        if "file" not in given:
            raise InvalidArgument(f"surface {label}: a measurement has no 'file'; expected a path, a scan or an array")
        measured = given["file"]
        is_file = is_path(measured) and not isinstance(measured, Given)
        own = {"file": self.reference("file", measured, label)} if is_file else self.of_scan(scan(measured), label)
        stated = {name: self.converted(name, value, label) for name, value in given.items() if name != "file"}
        return {name: value for name, value in {**own, **stated}.items() if value is not None}

    def of_scan(self, measured: Scan, label: str) -> dict[str, Any]:
        words = ("instrument", "tip_radius", "resolution", "trend", "layout")
        return {
            "file": self.heights(measured, label),
            "channel": measured.channel,
            **{name: getattr(measured, name) or None for name in words},
            "unit": measured.stated_unit or None,
            "size": [f"{length!r} m" for length in lengths(measured.stated_size)] if measured.stated_size else None,
            "keep_values": True if measured.keep_values or measured.source is not None else None,
            "pipeline": self.steps(measured, label),
        }

    def steps(self, measured: Scan, label: str) -> str | None:
        """The pipeline of a scan; its steps are written as one."""
        if measured.pipeline and measured.steps:
            raise InvalidArgument(f"surface {label}: a scan with a pipeline and further steps; expected one of them")
        if not measured.steps:
            return self.converted("pipeline", measured.pipeline, label) if measured.pipeline else None
        file = self.place(f"{label}_steps", ".toml")
        file.write_text(f"steps = {written(measured.steps)}\n", encoding="utf-8")
        return self.beside(file)

    def experiment(self, given: Mapping[str, Any]) -> dict[str, Any]:
        label = "_".join(str(given[name]) for name in ("surface", "elastomer", "role") if given.get(name) not in (None, "rough"))
        entry = dict(given)
        if isinstance(given.get("file"), Loop):
            entry = {**of_loop(given["file"]), **{name: value for name, value in given.items() if name != "file"}}
        return {name: self.converted(name, value, label) for name, value in entry.items() if value is not None}


def of_loop(loop: Loop) -> dict[str, Any]:
    """The keys of an experiment for a loop. Properties of the bodies other than the radius belong to elastomers."""
    files, bodies = dict(loop.files), dict(loop.bodies)
    foreign = [name for name, value in bodies.items() if value not in (None, "") and name != "radius"]
    if foreign:
        raise InvalidArgument(f"{loop.file}: {', '.join(foreign)} of a loop; expected these properties in the elastomer or the rough solid")
    if files.get("curve_number") is not None:
        raise InvalidArgument(f"{loop.file}: curve_number; expected a loop of a file with one curve, or loop.to_pandas()")
    camera = {"file": files.get("camera"), "mapping": files.get("camera_mapping"), "clock_offset": files.get("clock_offset"),
              "pixel_size": files.get("pixel_size"), "frame_rate": files.get("frame_rate") and f"{files['frame_rate']!r} 1/s",
              "fringes": files.get("fringes") or None}
    entry = {
        "file": loop.file,
        "mapping": files.get("mapping") or None,
        "spring_constant": files.get("spring_constant") or None,
        "sensitivity": files.get("sensitivity") or None,
        "columns": dict(column.split("=", 1) for column in files.get("columns", ())) or None,
        "camera": {name: value or None for name, value in camera.items()} if camera["file"] else None,
        "sphere_radius": bodies.get("radius") or None,
    }
    return entry


def write_study(file: str | os.PathLike[str], content: Mapping[str, Any]) -> str:
    """Writes a study file; returns its path."""
    target = path(file)
    StudyFile(pathlib.Path(target)).write(content)
    return target
