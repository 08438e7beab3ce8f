// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/help.hpp"

#include <algorithm>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace setae::cli {
namespace {

constexpr std::size_t text_column = 26;

/// Characters of UTF-8.
std::size_t characters(const std::string& text) {
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](unsigned char c) { return (c & 0xC0) != 0x80; }));
}

/// Text from a column on, in lines of whole words; the first line begins in this column.
std::string wrapped(const std::string& text, std::size_t column, std::size_t width) {
    std::string result;
    std::size_t at = column;
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        const auto length = characters(word);
        if (at > column && at + 1 + length > width) {
            result += "\n" + std::string(column, ' ');
            at = column;
        }
        if (at > column) {
            result += ' ';
            ++at;
        }
        result += word;
        at += length;
    }
    return result + "\n";
}

/// A name with its meaning in the next column, or below a long name.
std::string entry(const std::string& name, const std::string& meaning, std::size_t width) {
    const auto left = "  " + name;
    const auto length = characters(left);
    const auto gap =
        length + 2 > text_column ? "\n" + std::string(text_column, ' ') : std::string(text_column - length, ' ');
    return left + gap + wrapped(meaning, text_column, width);
}

std::string name_of(const ProgramOption& option) {
    return fmt::format("{}{}", fmt::join(option.flags, ", "), option.takes_value ? " " + option.value : "");
}

std::string usage(const ProgramCommand& command) {
    if (command.path.empty()) return "Usage: setae COMMAND [options] [files]\n";
    std::string text = "Usage: setae " + command.path;
    if (!command.subcommands.empty()) text += " COMMAND";
    text += " [options]";
    for (const auto& argument : command.positionals) text += " " + argument.flags.front();
    return text + "\n";
}

/// Three commands for the first use.
std::string start_here() {
    return "\nStart here:\n"
           "  setae info scan.ibw                      content of a file\n"
           "  setae psd scan.ibw -o spectrum.svg       power spectral density as a figure\n"
           "  setae study init data -o study.toml      draft of a study; then: setae study study.toml\n";
}

/// Subcommands below the headings of their topics, in the order of their table.
std::string subcommands_part(const ProgramCommand& command, std::size_t width) {
    std::string text, topic;
    for (std::size_t i = 0; i < command.subcommands.size(); ++i) {
        const auto of_this = command.topics.empty() ? "Commands" : command.topics[i];
        if (of_this != topic) text += "\n" + of_this + ":\n";
        topic = of_this;
        text += entry(command.subcommands[i], command.subcommand_descriptions[i], width);
    }
    return text;
}

std::string examples_part(const ProgramCommand& command, std::size_t width) {
    std::string text = command.examples.empty() ? "" : "\nExamples:\n";
    for (const auto& example : command.examples)
        text += fmt::format("  {}\n      {}", example.command, wrapped(example.what, 6, width));
    return text;
}

std::string options_part(const char* heading, const std::vector<ProgramOption>& options, std::size_t width) {
    std::string text = options.empty() ? "" : fmt::format("\n{}:\n", heading);
    for (const auto& option : options) text += entry(name_of(option), option.description, width);
    return text;
}

/// The options of files by name only.
std::string input_part(const ProgramCommand& command, std::size_t width) {
    const auto flags = file_options(command);
    if (flags.empty()) return {};
    return "\nInput: " + wrapped(fmt::format("{}; see `setae help input`", fmt::join(flags, ", ")), 7, width);
}

}  // namespace

std::string help_text(const ProgramCommand& command, std::size_t width) {
    auto text =
        wrapped("setae" + (command.path.empty() ? "" : " " + command.path) + ": " + command.description, 0, width) +
        "\n" + usage(command) + examples_part(command, width);
    if (!command.positionals.empty()) text += "\nArguments:\n";
    for (const auto& argument : command.positionals)
        text += entry(argument.flags.front() + " " + argument.value, argument.description, width);
    if (command.path.empty()) text += start_here();
    text += subcommands_part(command, width);
    text += options_part("Required options", options_in(OptionGroup::required, command), width) +
            options_part("Options", options_in(OptionGroup::common, command), width) + input_part(command, width) +
            options_part("Output options", options_in(OptionGroup::output, command), width) +
            options_part("Advanced options", options_in(OptionGroup::advanced, command), width);
    if (!command.path.empty()) return text;
    return text + "\n" +
           wrapped(
               "`setae help COMMAND` lists arguments, options and examples of a command, `setae help input` the options of "
               "files. Data go to standard output, messages to standard error. Exit code 0: done, 1: some items failed, "
               "2: nothing done.",
               0, width);
}

std::string input_help(const std::vector<ProgramCommand>& commands, std::size_t width) {
    std::string text = "setae help input: options of files, shared by several commands\n";
    for (const auto& [heading, takers, options] : file_options(commands))
        text += options_part(heading.c_str(), options, width) + "\n  " +
                wrapped(fmt::format("taken by {}", fmt::join(takers, ", ")), 2, width);
    return text;
}

}  // namespace setae::cli
