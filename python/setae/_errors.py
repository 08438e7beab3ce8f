# SPDX-License-Identifier: GPL-3.0-or-later
"""Exceptions of setae."""

from __future__ import annotations

from ._given import shown


class Error(Exception):
    """Base class of all exceptions of setae. The message states in one line what happened, where, the value, the expected value and the remedy.

    Attributes, if the message contains them: ``file``, ``line`` or ``offset`` (bytes) in the file, ``got`` and ``expected``.

    >>> import setae
    >>> try:
    ...     setae.lengths("5 kg")
    ... except setae.InvalidArgument as error:
    ...     print(isinstance(error, ValueError), error.file, "kg" in error.got)
    True None True
    """

    _file: str | None = None
    line: int | None = None
    offset: int | None = None
    got: str | None = None
    expected: str | None = None

    def __init__(self, *arguments: object) -> None:
        super().__init__(*(shown(argument) if isinstance(argument, str) else argument for argument in arguments))

    @property
    def file(self) -> str | None:
        return self._file

    @file.setter
    def file(self, file: str | None) -> None:
        self._file = None if file is None else shown(file)


class InvalidArgument(Error, ValueError):
    """An argument outside its documented domain."""


class FileError(Error, OSError):
    """A file that cannot be opened, read or written."""


class FormatError(Error, ValueError):
    """A file with content that violates its format, or with an unknown format."""


class UndefinedDataError(Error, ArithmeticError):
    """Too few defined values for a quantity."""


class InternalError(Error):
    """An impossible state, caused by an error in setae: please report it."""
