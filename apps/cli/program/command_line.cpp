// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/command_line.hpp"

#include "setae/core/text.hpp"

namespace setae::cli {
namespace {

std::string& remembered() {
    static std::string line;
    return line;
}

}  // namespace

void remember_command_line(int argc, char** argv) {
    auto& line = remembered();
    line = "setae";
    for (int i = 1; i < argc; ++i) line += " " + shell_word(argv[i]);
}

const std::string& command_line() { return remembered(); }

}  // namespace setae::cli
