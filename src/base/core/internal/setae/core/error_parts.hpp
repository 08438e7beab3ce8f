// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "setae/core/errors.hpp"

namespace setae {

/// What the message of an Error says, part by part; empty where it does not say it.
struct ErrorParts {
    std::string file;
    FilePosition position;
    std::string got;       ///< what there was in place of …
    std::string expected;  ///< … what was expected
};

/// The parts of a message as this project writes them: "FILE:LINE: GOT; expected EXPECTED; REMEDY", in place of the
/// line "at byte N". of_file: the message is of a FileError or FormatError, which begins with the path.
[[nodiscard]] ErrorParts error_parts(std::string_view message, bool of_file);

}  // namespace setae
