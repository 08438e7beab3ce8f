// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <exception>
#include <optional>
#include <stdexcept>
#include <string>

namespace setae {

/// Root of everything setae throws. A message says what, where, got, expected and the remedy; lower case, no full stop.
class Error : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// An argument outside the domain its documentation states.
class InvalidArgument : public Error {
public:
    using Error::Error;
};

/// A file that cannot be opened, read or written. The message begins with the path.
class FileError : public Error {
public:
    using Error::Error;
};

/// A position inside a file: a byte offset for binary files, a line for text.
struct FilePosition {
    std::optional<std::uint64_t> offset;
    std::optional<std::uint64_t> line;
};

/// A file whose content breaks its format, or whose format nobody knows. The message begins with "path:line" or
/// "path: at byte N".
class FormatError : public Error {
public:
    FormatError(const std::string& path, const FilePosition& position, const std::string& what);
};

/// Too few defined values for the quantity asked for.
class UndefinedDataError : public Error {
public:
    using Error::Error;
};

/// The caller asked to stop before all was done.
class Cancelled : public Error {
public:
    using Error::Error;
};

/// A state setae promised could not happen: please report it.
class InternalError : public Error {
public:
    using Error::Error;
};

/// What to say of a failure, whatever threw it: the message of an Error; for others what ran out, or that it is ours to
/// mend. What fails an item of many is caught as std::exception and said so; Cancelled is none of them and passes on.
[[nodiscard]] std::string reason_of(const std::exception& failure);
/// The same of one item, which it names.
[[nodiscard]] std::string reason_of(const std::exception& failure, const std::string& item);

}  // namespace setae
