// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/command_page.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "program/markdown.hpp"
#include "program/program_tree.hpp"

namespace setae::cli {
namespace {

/// The anchor of the heading "setae jkr fit".
std::string anchor(const ProgramCommand& command) {
    std::string text = "setae-" + command.path;
    std::replace(text.begin(), text.end(), ' ', '-');
    return text;
}

std::string flags_of(const ProgramOption& option) {
    std::string text;
    for (const auto& flag : option.flags) text += fmt::format("{}`{}`", text.empty() ? "" : ", ", flag);
    return option.takes_value ? text + " " + markdown_cell(option.value) : text;
}

/// True for options of every command, which the page lists once.
bool is_common_option(const ProgramOption& option) {
    const auto& flag = option.flags.back();
    return flag == "--help" || flag == "--json" || flag == "--explain" || flag == "--threads";
}

std::string row(const std::string& left, const std::string& meaning) {
    return fmt::format("| {} | {} |\n", left, markdown_cell(meaning));
}

std::string section(const ProgramCommand& command) {
    std::string usage = "setae " + command.path, rows;
    for (const auto& argument : command.positionals) {
        usage += " " + argument.flags.front();
        rows += row("`" + argument.flags.front() + "`", argument.description);
    }
    for (const auto& option : command.options)
        if (!is_common_option(option)) rows += row(flags_of(option), option.description);
    std::string examples = command.examples.empty() ? "" : "\nExamples:\n\n";
    for (const auto& example : command.examples)
        examples += fmt::format("    {}\n        {}\n", example.command, example.what);
    return fmt::format("\n## setae {}\n\n{}.\n\n    {} [options]\n", command.path, command.description, usage) +
           examples + (rows.empty() ? "" : "\n| argument or option | meaning |\n|---|---|\n" + rows);
}

}  // namespace

std::string command_page() {
    std::string text =
        "# Commands\n\n*Reference · [all documents](../README.md)*\n\n"
        "Made from the program's own table of commands by `setae man --documentation docs/reference/commands.md`: edit the table, not this page.\n"
        "Arguments have units: `0.7MPa`, `37mJ/m2`, `\"8 nm\"`. Data go to standard output, messages to standard error. Exit code 0: done,\n"
        "1: some items failed, 2: nothing done.\n\n| command | function |\n|---|---|\n";
    std::string sections;
    ProgramCommand any;
    for (const auto& command : program_commands()) {
        if (!command.subcommands.empty() && command.positionals.empty())
            continue;  // the program, or a group of commands
        text += row(fmt::format("[{}](#{})", command.path, anchor(command)), command.description);
        sections += section(command);
        any = command;
    }
    text += "\nOptions of every command:\n\n| option | meaning |\n|---|---|\n";
    for (const auto& option : any.options)
        if (is_common_option(option)) text += row(flags_of(option), option.description);
    return text + sections;
}

}  // namespace setae::cli
