// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/command_page.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "program/markdown.hpp"
#include "program/program_tree.hpp"

namespace setae::cli {
namespace {

/// "jkr-fit.md" of "jkr fit".
std::string file_of(std::string path) {
    std::replace(path.begin(), path.end(), ' ', '-');
    return path + ".md";
}

std::string flags_of(const ProgramOption& option) {
    const auto text = fmt::format("`{}`", fmt::join(option.flags, "`, `"));
    return option.takes_value ? text + " " + markdown_cell(option.value) : text;
}

std::string row(const std::string& left, const std::string& meaning) {
    return fmt::format("| {} | {} |\n", left, markdown_cell(meaning));
}

std::string options_part(const char* heading, const std::vector<ProgramOption>& options) {
    std::string text = options.empty() ? "" : fmt::format("\n## {0}\n\n| option | meaning |\n|---|---|\n", heading);
    for (const auto& option : options) text += row(flags_of(option), option.description);
    return text;
}

/// The options of files by name only.
std::string input_part(const ProgramCommand& command) {
    const auto flags = file_options(command);
    if (flags.empty()) return {};
    return fmt::format("\n## Input\n\n`{}`: see [options of files](input.md).\n", fmt::join(flags, "`, `"));
}

std::string page(const ProgramCommand& command) {
    std::string usage, arguments, examples;
    for (const auto& argument : command.positionals) {
        usage += " " + argument.flags.front();
        arguments += row("`" + argument.flags.front() + "`", argument.description);
    }
    for (const auto& example : command.examples)
        examples += fmt::format("    {}\n        {}\n", example.command, example.what);
    return fmt::format("# setae {}\n\n{}.\n\n    setae {} [options]{}\n", command.path, command.description,
                       command.path, usage) +
           (examples.empty() ? "" : "\n## Examples\n\n" + examples) +
           (arguments.empty() ? "" : "\n## Arguments\n\n| argument | meaning |\n|---|---|\n" + arguments) +
           options_part("Required options", options_in(OptionGroup::required, command)) +
           options_part("Options", options_in(OptionGroup::common, command)) + input_part(command) +
           options_part("Output options", options_in(OptionGroup::output, command)) +
           options_part("Advanced options", options_in(OptionGroup::advanced, command)) +
           "\n[All commands](README.md)\n";
}

std::string input_page(const std::vector<ProgramCommand>& commands) {
    std::string text = "# Options of files\n\nSeveral commands share these options. `setae help input` prints them.\n";
    for (const auto& [heading, takers, options] : file_options(commands)) {
        std::vector<std::string> links;
        for (const auto& taker : takers) links.push_back(fmt::format("[{}]({})", taker, file_of(taker)));
        text += options_part(heading.c_str(), options) + fmt::format("\nCommands: {}.\n", fmt::join(links, ", "));
    }
    return text + "\n[All commands](README.md)\n";
}

/// A command that only has commands below it has no page.
bool has_page(const ProgramCommand& command) { return command.subcommands.empty() || !command.positionals.empty(); }

/// Commands below the headings of their topics.
std::string index_page(const std::vector<ProgramCommand>& commands) {
    std::string text =
        "# Commands\n\n*Reference · [all documents](../../README.md)*\n\n"
        "`setae man --documentation docs/reference/commands` writes these pages from the commands of the program: edit the commands, not these\n"
        "pages. Arguments have units: `0.7MPa`, `37mJ/m2`, `\"8 nm\"`. Data go to standard output, messages to standard error. Exit code 0:\n"
        "done, 1: some items failed, 2: nothing done. [Options of files](input.md) are those that several commands share.\n";
    const auto& program = commands.front();
    std::string topic;
    for (const auto& command : commands) {
        if (!has_page(command)) continue;
        const auto name = command.path.substr(0, command.path.find(' '));
        const auto at = std::find(program.subcommands.begin(), program.subcommands.end(), name);
        const auto& of_this = program.topics[static_cast<std::size_t>(at - program.subcommands.begin())];
        if (of_this != topic) text += fmt::format("\n## {}\n\n| command | what it does |\n|---|---|\n", of_this);
        topic = of_this;
        text += row(fmt::format("[{}]({})", command.path, file_of(command.path)), command.description);
    }
    return text;
}

}  // namespace

std::map<std::string, std::string> command_pages() {
    const auto commands = program_commands();
    std::map<std::string, std::string> pages{{"README.md", index_page(commands)}, {"input.md", input_page(commands)}};
    for (const auto& command : commands)
        if (has_page(command)) pages[file_of(command.path)] = page(command);
    return pages;
}

}  // namespace setae::cli
