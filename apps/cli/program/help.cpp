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

/// Text from a column on, in lines of whole words; the first line begins behind what stands there.
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

/// A name with its meaning beside it, or below where it is long.
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

std::string usage(const ProgramVerb& verb) {
    if (verb.path.empty()) return "Usage: setae VERB [options] [files]\n";
    std::string text = "Usage: setae " + verb.path;
    if (!verb.verbs.empty()) text += " VERB";
    text += " [options]";
    for (const auto& argument : verb.positionals) text += " " + argument.flags.front();
    return text + "\n";
}

}  // namespace

std::string help_text(const ProgramVerb& verb, std::size_t width) {
    auto text = wrapped("setae" + (verb.path.empty() ? "" : " " + verb.path) + ": " + verb.description, 0, width) +
                "\n" + usage(verb);
    if (!verb.positionals.empty()) text += "\nArguments:\n";
    for (const auto& argument : verb.positionals)
        text += entry(argument.flags.front() + " " + argument.value, argument.description, width);
    if (!verb.verbs.empty()) text += "\nVerbs:\n";
    for (std::size_t i = 0; i < verb.verbs.size(); ++i) text += entry(verb.verbs[i], verb.verb_descriptions[i], width);
    text += "\nOptions:\n";
    for (const auto& option : verb.options) text += entry(name_of(option), option.description, width);
    if (!verb.examples.empty()) text += "\nExamples:\n";
    for (const auto& example : verb.examples)
        text += fmt::format("  {}\n      {}", example.command, wrapped(example.what, 6, width));
    if (!verb.path.empty()) return text;
    return text + "\n" +
           wrapped(
               "`setae help VERB` says what a verb takes, with examples. Standard output carries data, standard "
               "error messages. Exit code 0: done, 1: some items failed, 2: nothing done.",
               0, width);
}

}  // namespace setae::cli
