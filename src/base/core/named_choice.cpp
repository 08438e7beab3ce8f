// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/core/named_choice.hpp"

#include <algorithm>
#include <cctype>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "setae/core/errors.hpp"
#include "setae/core/number_text.hpp"
#include "setae/core/text.hpp"

namespace setae {
namespace {

constexpr std::size_t max_names_shown = 12;

/// ASCII letters in lower case; others unchanged.
std::string lower_case(std::string_view text) {
    std::string lower(trimmed(text));
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return lower;
}

std::string shown_name(std::span<const std::string> names, std::size_t place) {
    return names[place].empty() ? fmt::format("{}", place) : fmt::format("{} '{}'", place, names[place]);
}

}  // namespace

std::string numbered_names(std::span<const std::string> names) {
    std::vector<std::string> shown;
    for (std::size_t i = 0; i < std::min(names.size(), max_names_shown); ++i) shown.push_back(shown_name(names, i));
    if (names.size() > max_names_shown) shown.push_back(fmt::format("… {}", names.size() - 1));
    return fmt::format("{}", fmt::join(shown, ", "));
}

std::size_t chosen_by_name(std::string_view wanted, std::span<const std::string> names, std::string_view thing) {
    const auto text = lower_case(wanted);
    const auto refuse = [&](const std::string& what) {
        throw InvalidArgument(
            fmt::format("no {} {}; there are {}, counted from 0", thing, what, numbered_names(names)));
    };
    const bool number =
        !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
    if (number) {
        const auto place = spelled<std::size_t>(text);
        if (!place || *place >= names.size()) refuse(text);
        return *place;
    }
    std::vector<std::size_t> whole, beginning;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto name = lower_case(names[i]);
        if (text.empty()) continue;
        if (name == text) whole.push_back(i);
        if (name.starts_with(text)) beginning.push_back(i);
    }
    const auto& found = whole.empty() ? beginning : whole;
    if (found.size() == 1) return found.front();
    if (found.empty()) {
        constexpr std::size_t shortest_slip = 3;  // shorter words have no near matches
        const auto nearest = wanted.size() < shortest_slip ? std::string() : nearest_match(wanted, names);
        refuse(fmt::format("'{}'{}", wanted, nearest.empty() ? "" : fmt::format(" (did you mean '{}'?)", nearest)));
    }
    std::vector<std::string> candidates;
    for (const auto place : found) candidates.push_back(shown_name(names, place));
    throw InvalidArgument(fmt::format("{} '{}' is ambiguous: {}; give the whole name or the number", thing, wanted,
                                      fmt::join(candidates, ", ")));
}

}  // namespace setae
