// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <exception>
#include <optional>
#include <stdexcept>
#include <string>

namespace setae {

/// Base class of all exceptions of setae. A message states what happened, where, what was found, what was expected and
/// the remedy; lower case, no full stop.
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

/// A file that violates its format, or whose format is unknown. The message begins with "path:line" or "path: at byte
/// N".
class FormatError : public Error {
public:
    FormatError(const std::string& path, const FilePosition& position, const std::string& what);
};

/// Too few defined values for the requested quantity.
class UndefinedDataError : public Error {
public:
    using Error::Error;
};

/// The caller requested a stop before the work was complete.
class Cancelled : public Error {
public:
    using Error::Error;
};

/// A state that should be impossible: a defect of setae, to be reported.
class InternalError : public Error {
public:
    using Error::Error;
};

/// Reason of a failure for messages: the message of an Error; for other exceptions the exhausted resource, or that the
/// failure is a defect of setae. The failure of one item of many is caught as std::exception and reported by this
/// function. Cancelled is passed on.
[[nodiscard]] std::string reason_of(const std::exception& failure);
/// Reason of the failure of one item, with the name of the item.
[[nodiscard]] std::string reason_of(const std::exception& failure, const std::string& item);

}  // namespace setae
