// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "program/command.hpp"

namespace setae::cli {

/// Result of parsing a command line.
struct Parsed {
    Action action;      ///< runs the command; none if help, version or an error was printed
    int exit_code = 0;  ///< if there is no action
};

/// Parses a command line with the table of commands.
[[nodiscard]] Parsed parsed(int argc, char** argv);

}  // namespace setae::cli
