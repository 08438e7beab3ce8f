// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/core/errors.hpp"

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

}  // namespace setae
