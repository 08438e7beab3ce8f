// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "program/program_tree.hpp"

namespace setae::cli {

/// Text of `--help` of a command, or of the program: description, examples, arguments, commands, options in groups.
///
/// Lines have at most `width` characters and whole words. Longer command lines and words are not broken.
[[nodiscard]] std::string help_text(const ProgramCommand& command, std::size_t width);

/// Text of `setae help input`: the options of files that several commands take.
[[nodiscard]] std::string input_help(const std::vector<ProgramCommand>& commands, std::size_t width);

}  // namespace setae::cli
