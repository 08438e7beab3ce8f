# SPDX-License-Identifier: GPL-3.0-or-later
"""Exceptions of setae."""

from __future__ import annotations


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

    file: str | None = None
    line: int | None = None
    offset: int | None = None
    got: str | None = None
    expected: str | None = None


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
