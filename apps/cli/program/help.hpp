// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "program/program_tree.hpp"

namespace setae::cli {

/// Text of `--help` of a command, or of the program: description, arguments, options, commands and examples.
///
/// Lines have at most `width` characters and whole words. Longer command lines and words are not broken.
[[nodiscard]] std::string help_text(const ProgramCommand& command, std::size_t width);

}  // namespace setae::cli
