# SPDX-License-Identifier: GPL-3.0-or-later
"""What setae raises."""

from __future__ import annotations


class Error(Exception):
    """Root of everything setae raises: what, where, got, expected and the remedy, in one line.

    Its parts, where the message has them: ``file``, ``line`` or ``offset`` (bytes) in it, ``got`` and ``expected``.

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
    """An argument outside the domain its documentation states."""


class FileError(Error, OSError):
    """A file that cannot be opened, read or written."""


class FormatError(Error, ValueError):
    """A file whose content breaks its format, or whose format nobody knows."""


class UndefinedDataError(Error, ArithmeticError):
    """Too few defined values for the quantity asked for."""


class InternalError(Error):
    """A state setae promised could not happen: please report it."""
