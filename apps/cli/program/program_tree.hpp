// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace setae::cli {

struct ProgramOption {
    std::vector<std::string> flags;  ///< "-o", "--output"
    std::string value;               ///< what it takes, as `--help` names it; empty for a switch
    bool takes_value = false;
    std::string description;
};

/// A verb of the program, or the program itself, and what may follow it.
struct ProgramVerb {
    std::string path;  ///< "jkr fit"; empty for the program
    std::string description;
    std::vector<ProgramOption> options;
    std::vector<std::string> positionals;              ///< as `--help` names them
    std::vector<std::string> positional_descriptions;  ///< likewise
    std::vector<std::string> verbs, verb_descriptions;
};

/// The program and all its verbs, parents before children: what the manual page, the page of verbs and the completions
/// are made from.
[[nodiscard]] std::vector<ProgramVerb> program_verbs();

}  // namespace setae::cli
