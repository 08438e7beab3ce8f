// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "setae/core/errors.hpp"

namespace setae {

/// Parts of the message of an Error; empty if the message lacks the part.
struct ErrorParts {
    std::string file;
    FilePosition position;
    std::string got;       ///< found
    std::string expected;  ///< expected
};

/// The parts of a message of this project: "FILE:LINE: GOT; expected EXPECTED; REMEDY", or "at byte N" instead of the
/// line. of_file: the message is that of a FileError or FormatError, which begins with the path.
[[nodiscard]] ErrorParts error_parts(std::string_view message, bool of_file);

}  // namespace setae
