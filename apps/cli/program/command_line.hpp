// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace setae::cli {

/// Stores the command line of the program, with "setae" as its name. Called once at the start.
void store_command_line(int argc, char** argv);

/// The command line with quotes for a shell, to repeat the run.
[[nodiscard]] const std::string& command_line();

}  // namespace setae::cli
