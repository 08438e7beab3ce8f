// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/command_line.hpp"

#include "setae/core/text.hpp"

namespace setae::cli {
namespace {

std::string& stored_command_line() {
    static std::string line;
    return line;
}

}  // namespace

void store_command_line(int argc, char** argv) {
    auto& line = stored_command_line();
    line = "setae";
    for (int i = 1; i < argc; ++i) line += " " + shell_word(argv[i]);
}

const std::string& command_line() { return stored_command_line(); }

}  // namespace setae::cli
