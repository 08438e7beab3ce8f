// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "program/program_tree.hpp"

namespace setae::cli {

/// What `--help` prints of a command, or of the program: what it does, its arguments, options, commands and examples.
///
/// Lines of at most `width` characters, no word broken; command lines and words that are longer stand as they are.
[[nodiscard]] std::string help_text(const ProgramCommand& command, std::size_t width);

}  // namespace setae::cli
