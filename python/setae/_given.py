# SPDX-License-Identifier: GPL-3.0-or-later
"""Content in memory as files for the readers of the library."""

from __future__ import annotations

import os
import pathlib
import re
import shutil
import tempfile
import weakref
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

#: A table in memory: a dictionary of arrays, a DataFrame of pandas, a Dataset of xarray, a structured array, or a result of setae with columns.
#: Units are in the names of columns ("force [mN]"), in ``attrs``, in arrays of pint, or in an argument.
TableLike = Any
#: A file by its path, or a table in memory.
Source = Any

PREFIX = "setae-given-"
_FOLDERS = re.compile(re.escape(os.path.join(tempfile.gettempdir(), PREFIX)) + r"[^/\\]+[/\\]")


def shown(text: str) -> str:
    """A text of the library with the names of given content in place of the paths of its temporary files."""
    return _FOLDERS.sub("", text) if PREFIX in text else text


@dataclass(frozen=True)
class Given:
    """Content in memory that the library reads as a file. Results and messages show its name in place of a path.

    The file exists in a temporary folder from the first use until the object is released.

    >>> import os, pathlib
    >>> table = Given("force.csv", b"force [mN],displacement [um]")
    >>> pathlib.Path(os.fspath(table)).read_bytes() == table.content, shown(os.fspath(table))
    (True, 'force.csv')
    """

    name: str
    content: bytes = field(repr=False)

    @cached_property
    def _file(self) -> pathlib.Path:
        folder = tempfile.mkdtemp(prefix=PREFIX)
        weakref.finalize(self, remove_own, folder, os.getpid())
        file = pathlib.Path(folder) / self.name
        file.write_bytes(self.content)
        return file

    def __fspath__(self) -> str:
        return str(self._file)

    def __str__(self) -> str:
        return self.name

    def save(self, file: str) -> None:
        """Writes the content."""
        pathlib.Path(file).write_bytes(self.content)

    def __getstate__(self) -> dict[str, Any]:
        return {"name": self.name, "content": self.content}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state)


def remove_own(folder: str, process: int) -> None:
    """Removes a folder in the process that made it, not in processes forked later."""
    if os.getpid() == process:
        shutil.rmtree(folder, ignore_errors=True)


def plain_name(name: str) -> str:
    """A name for a file without separators of paths.

    >>> plain_name("rougher/afm 1.txt")
    'rougher_afm 1.txt'
    """
    return re.sub(r'[/\\:*?"<>|\x00-\x1f]', "_", name).strip(". ") or "given"


def is_path(value: Any) -> bool:
    return isinstance(value, str) or hasattr(value, "__fspath__")


def as_file(source: Source, name: str, units: Mapping[str, str] | None = None) -> str | Given:
    """A path as text, or a table in memory as a file that exists as long as the result.

    >>> as_file("loop.csv", "loop"), as_file({"force [mN]": [1.0]}, "loop")
    ('loop.csv', Given(name='loop'))
    """
    if is_path(source):
        if units:
            raise TypeError("units: units of a table in memory; a file states its own units")
        return source if isinstance(source, Given) else os.fspath(source)
    if getattr(source, "handle", None) is not None and hasattr(source, "save"):
        return saved(source.save, name)
    from ._tables import is_table, table_of

    if not is_table(source):
        raise TypeError(f"{type(source).__name__}; expected a path or a table in memory, such as a DataFrame")
    return Given(name, table_of(source, units).text_with_metadata())


def saved(save: Callable[[str], None], name: str) -> Given:
    """The file that a result writes, with its header, as content in memory."""
    with tempfile.TemporaryDirectory(prefix=PREFIX) as folder:
        file = pathlib.Path(folder) / plain_name(name)
        save(str(file))
        return Given(name, file.read_bytes())
