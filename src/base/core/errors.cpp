// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/core/errors.hpp"

#include <new>
#include <system_error>

#include <fmt/format.h>

namespace setae {
namespace {

std::string located(const std::string& path, const FilePosition& position, const std::string& what) {
    if (position.line) return fmt::format("{}:{}: {}", path, *position.line, what);
    if (position.offset) return fmt::format("{}: at byte {}: {}", path, *position.offset, what);
    return fmt::format("{}: {}", path, what);
}

}  // namespace

FormatError::FormatError(const std::string& path, const FilePosition& position, const std::string& what)
    : Error(located(path, position, what)) {}

std::string reason_of(const std::exception& failure) {
    if (dynamic_cast<const Error*>(&failure)) return failure.what();
    if (dynamic_cast<const std::bad_alloc*>(&failure))
        return "memory does not suffice; use smaller data, fewer threads or a machine with more memory";
    if (const auto* system = dynamic_cast<const std::system_error*>(&failure))
        return fmt::format("the operating system refuses: {}", system->what());
    return fmt::format("internal error: {}; please report it with the file and the command", failure.what());
}

std::string reason_of(const std::exception& failure, const std::string& item) {
    const auto reason = reason_of(failure);
    return reason.find(item) != std::string::npos ? reason : item + ": " + reason;
}

}  // namespace setae
