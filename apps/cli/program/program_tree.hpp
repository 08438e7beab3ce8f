// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "program/options.hpp"

namespace setae::cli {

/// An option or a positional argument.
struct ProgramOption {
    std::vector<std::string> flags;  ///< "-o", "--output"; for an argument only its name
    std::string value;               ///< kind of value in `--help`; empty for a switch
    bool takes_value = false;
    std::string description;
    std::vector<std::string> choices;  ///< the words it accepts; empty if it accepts other words, too
    OptionGroup group = OptionGroup::common;
};

/// A command of the program, or the program itself, with its subcommands, arguments and options.
struct ProgramCommand {
    std::string path;  ///< "jkr fit"; empty for the program
    std::string description;
    std::vector<ProgramOption> options;
    std::vector<ProgramOption> positionals;
    std::vector<std::string> subcommands, subcommand_descriptions;
    std::vector<std::string> topics;  ///< of the program's subcommands, one each
    std::vector<Example> examples;
};

/// The program and all its commands, parents before children; source of the manual page, the page of commands and the
/// completions.
[[nodiscard]] std::vector<ProgramCommand> program_commands();

/// Options of a group in their order.
[[nodiscard]] std::vector<ProgramOption> options_in(OptionGroup group, const ProgramCommand& command);

/// Long names of the options of files that a command takes.
[[nodiscard]] std::vector<std::string> file_options(const ProgramCommand& command);

/// Options of files of one kind, and the commands that take them.
struct FileOptions {
    std::string heading;  ///< "Files of heights"
    std::vector<std::string> commands;
    std::vector<ProgramOption> options;
};

/// What `setae help input` lists.
[[nodiscard]] std::vector<FileOptions> file_options(const std::vector<ProgramCommand>& commands);

}  // namespace setae::cli
