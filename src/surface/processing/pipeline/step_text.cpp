// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/processing/step_text.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "text_visitor.hpp"

namespace setae::processing {
namespace {

/// Words of a line, separated by blanks outside quotes, single or double; \ escapes " and \ in double quotes.
std::vector<std::string> words_of(std::string_view line) {
    std::vector<std::string> words;
    char quote = '\0';  // the open quote
    bool in_word = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (!quote && std::string_view(" \t\r\n").find(c) != std::string_view::npos) {
            in_word = false;
            continue;
        }
        if (!in_word) words.emplace_back();
        in_word = true;
        if (quote ? c == quote : c == '"' || c == '\'') quote = quote ? '\0' : c;
        else if (quote == '"' && c == '\\' && i + 1 < line.size()) words.back() += line[++i];
        else words.back() += c;
    }
    if (quote) throw InvalidArgument(fmt::format("step '{}': a quote is not closed", line));
    return words;
}

std::string quoted(const std::string& value) {
    if (!value.empty() && value.find_first_of(" \t\r\n\"'\\") == std::string::npos) return value;
    std::string text = "\"";
    for (const char c : value) {
        if (c == '"' || c == '\\') text += '\\';
        text += c;
    }
    return text + "\"";
}

}  // namespace

void set_parameter(Step& step, const ParameterText& parameter) {
    std::vector<std::string> names;
    bool found = false;
    TextVisitor visitor{
        [&](std::string_view name, std::string_view, const std::string&, std::string_view, const auto& set) {
            names.emplace_back(name);
            if (name != parameter.name) return;
            found = true;
            try {
                set(parameter.value);
            } catch (const InvalidArgument& error) {
                throw InvalidArgument(fmt::format("{}: {}", parameter.name, error.what()));
            }
        }};
    std::visit([&](auto& known) { visit_parameters(known, visitor); }, step);
    if (found) return;
    const auto nearest = nearest_match(parameter.name, names);
    throw InvalidArgument(fmt::format(
        "unknown parameter '{}' of {}{}; {}", parameter.name, name(step),
        nearest.empty() ? "" : "; did you mean '" + nearest + "'?",
        names.empty() ? "this step has no parameters" : fmt::format("expected one of {}", fmt::join(names, ", "))));
}

std::vector<ParameterText> parameters(const Step& step) {
    std::vector<ParameterText> texts;
    TextVisitor visitor{
        [&](std::string_view name, std::string_view, const std::string& value, std::string_view, const auto&) {
            if (!value.empty()) texts.push_back({std::string(name), value});
        }};
    std::visit([&](auto known) { visit_parameters(known, visitor); }, step);
    return texts;
}

std::vector<ParameterText> changed_parameters(const Step& step) {
    const auto defaults = parameters(step_named(name(step)));
    auto texts = parameters(step);
    std::erase_if(texts, [&](const ParameterText& text) {
        return std::find(defaults.begin(), defaults.end(), text) != defaults.end();
    });
    return texts;
}

Step step_from_text(std::string_view text) {
    const auto words = words_of(text);
    if (words.empty()) throw InvalidArgument("empty step; expected a name, such as level_plane");
    auto step = step_named(words.front());
    for (std::size_t k = 1; k < words.size(); ++k) {
        const auto equals = words[k].find('=');
        if (equals == std::string::npos)
            throw InvalidArgument(fmt::format("step '{}': '{}' is no parameter; expected NAME=VALUE", text, words[k]));
        set_parameter(step, {words[k].substr(0, equals), words[k].substr(equals + 1)});
    }
    return step;
}

std::string text(const Step& step) {
    std::string line = name(step);
    for (const auto& parameter : changed_parameters(step))
        line += fmt::format(" {}={}", parameter.name, quoted(parameter.value));
    return line;
}

}  // namespace setae::processing
