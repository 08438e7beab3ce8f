// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace setae::cli {

/// Keeps what the program was called with, its own name as "setae"; once, at its start.
void remember_command_line(int argc, char** argv);

/// What it was called with, as a shell takes it: what makes its results again.
[[nodiscard]] const std::string& command_line();

}  // namespace setae::cli
