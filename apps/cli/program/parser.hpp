// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "program/command.hpp"

namespace setae::cli {

/// What a command line asks for.
struct Parsed {
    Action action;      ///< of the command named; none where help, the version or what is wrong was printed
    int exit_code = 0;  ///< then
};

/// Reads a command line by the table of commands.
[[nodiscard]] Parsed parsed(int argc, char** argv);

}  // namespace setae::cli
