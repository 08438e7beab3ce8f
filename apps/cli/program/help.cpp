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

}  // namespace

std::string help_text(const ProgramCommand& command, std::size_t width) {
    auto text =
        wrapped("setae" + (command.path.empty() ? "" : " " + command.path) + ": " + command.description, 0, width) +
        "\n" + usage(command);
    if (!command.positionals.empty()) text += "\nArguments:\n";
    for (const auto& argument : command.positionals)
        text += entry(argument.flags.front() + " " + argument.value, argument.description, width);
    if (command.path.empty()) text += start_here();
    text += subcommands_part(command, width);
    text += "\nOptions:\n";
    for (const auto& option : command.options) text += entry(name_of(option), option.description, width);
    if (!command.examples.empty()) text += "\nExamples:\n";
    for (const auto& example : command.examples)
        text += fmt::format("  {}\n      {}", example.command, wrapped(example.what, 6, width));
    if (!command.path.empty()) return text;
    return text + "\n" +
           wrapped(
               "`setae help COMMAND` lists arguments, options and examples of a command. Data go to standard output, messages to "
               "standard error. Exit code 0: done, 1: some items failed, 2: nothing done.",
               0, width);
}

}  // namespace setae::cli
