// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/tables/header.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/tables/dialect.hpp"

namespace setae::tables {
namespace {

bool is_length(std::string_view text) {
    const auto unit = try_parse_unit(text);
    return unit && unit->dimension == dimension::length;
}

std::string_view without_underscore(std::string_view name) {
    while (name.ends_with('_')) name.remove_suffix(1);
    return trimmed(name);
}

/// The text inside [] or () around a whole cell, otherwise empty.
std::optional<std::string_view> bracketed(std::string_view cell) {
    const bool square = cell.starts_with('[') && cell.ends_with(']');
    const bool round = cell.starts_with('(') && cell.ends_with(')');
    if (cell.size() < 2 || !(square || round)) return std::nullopt;
    return trimmed(cell.substr(1, cell.size() - 2));
}

std::optional<HeaderCell> with_brackets(std::string_view cell) {
    if (cell.empty()) return std::nullopt;
    const bool square = cell.back() == ']', round = cell.back() == ')';
    const auto open = square ? cell.rfind('[') : round ? cell.rfind('(') : std::string_view::npos;
    if (open == std::string_view::npos) return std::nullopt;
    auto unit = trimmed(cell.substr(open + 1, cell.size() - open - 2));
    constexpr std::string_view in = "in ";  // "(in mN)"
    if (unit.starts_with(in) && try_parse_unit(unit.substr(in.size()))) unit = trimmed(unit.substr(in.size()));
    // round brackets can also contain comments, such as "height (retrace)"
    if (round && !try_parse_unit(unit)) return std::nullopt;
    return HeaderCell{std::string(without_underscore(trimmed(cell.substr(0, open)))), std::string(unit)};
}

std::optional<HeaderCell> with_word(std::string_view cell, std::string_view word) {
    const auto at = cell.rfind(word);
    if (at == std::string_view::npos) return std::nullopt;
    const auto unit = trimmed(cell.substr(at + word.size()));
    if (!try_parse_unit(unit)) return std::nullopt;
    return HeaderCell{std::string(trimmed(cell.substr(0, at))), std::string(unit)};
}

/// Units that are not words of a name, for spellings without brackets: of length, force, area and time.
bool is_plain_unit(std::string_view text) {
    static constexpr std::array<std::string_view, 6> words{"min", "h", "A", "in", "mil", "hr"};
    if (std::find(words.begin(), words.end(), text) != words.end()) return false;
    const auto unit = try_parse_unit(text);
    return unit && (unit->dimension == dimension::length || unit->dimension == dimension::force ||
                    unit->dimension == dimension::area || unit->dimension == dimension::time);
}

std::optional<HeaderCell> with_trailing_unit(std::string_view cell) {
    const auto at = cell.rfind(' ');
    if (at == std::string_view::npos || cell.size() - at < 3 || !is_plain_unit(cell.substr(at + 1)))
        return std::nullopt;
    return HeaderCell{std::string(trimmed(cell.substr(0, at))), std::string(cell.substr(at + 1))};
}

/// "force_mN"; a single letter only after a word: "force_N", not "x_m".
std::optional<HeaderCell> with_underscore(std::string_view cell) {
    const auto at = cell.rfind('_');
    if (at == std::string_view::npos || at == 0 || !is_plain_unit(cell.substr(at + 1))) return std::nullopt;
    if (cell.size() - at == 2 && at < 3) return std::nullopt;
    return HeaderCell{std::string(without_underscore(cell.substr(0, at))), std::string(cell.substr(at + 1))};
}

/// "Kraft/mN" as in DIN 1313; "N/mm" and "1/um" are units themselves.
std::optional<HeaderCell> with_slash(std::string_view cell) {
    static constexpr std::array<std::string_view, 4> quantities{"F", "s", "t", "h"};
    const auto at = cell.rfind('/');
    if (at == std::string_view::npos || at == 0 || !is_plain_unit(cell.substr(at + 1))) return std::nullopt;
    const auto name = trimmed(cell.substr(0, at));
    const bool quantity = std::find(quantities.begin(), quantities.end(), name) != quantities.end();
    if (!quantity && try_parse_unit(name)) return std::nullopt;
    return HeaderCell{std::string(name), std::string(cell.substr(at + 1))};
}

/// "cycles per um": a number per length.
HeaderCell with_unit_of_rate(HeaderCell cell) {
    constexpr std::string_view per = " per";
    if (!cell.name.ends_with(per) || cell.unit.empty()) return cell;
    cell.name.resize(cell.name.size() - per.size());
    cell.unit = "1/" + cell.unit;
    return cell;
}

/// Units of a row with nothing else: each cell in brackets, or each a unit below a row of names, or each a length.
std::vector<std::string> unit_row(const std::vector<std::string>& cells, bool below_names) {
    std::vector<std::string> units;
    bool all_bracketed = true, all_units = true, all_lengths = true, any_unit = false;
    for (const auto& cell : cells) {
        const auto inside = bracketed(cell);
        const std::string_view unit = inside ? *inside : std::string_view(cell);
        const bool known = try_parse_unit(unit).has_value();
        any_unit |= known;
        all_bracketed &= inside.has_value();
        all_units &= known || cell.empty() || cell == "-";
        all_lengths &= is_length(unit);
        units.emplace_back(cell == "-" ? std::string_view("1") : unit);
    }
    return any_unit && (all_bracketed || (all_units && below_names) || all_lengths) ? units
                                                                                    : std::vector<std::string>{};
}

std::vector<HeaderCell> name_row(const std::vector<std::string>& cells) {
    std::vector<HeaderCell> names;
    for (const auto& cell : cells) names.push_back(parse_header_cell(cell));
    return names;
}

}  // namespace

std::optional<Unit> try_parse_unit(std::string_view text) {
    if (trimmed(text).empty()) return std::nullopt;
    try {
        return parse_unit(text);
    } catch (const InvalidArgument&) {
        return std::nullopt;
    }
}

bool is_unit_of(std::string_view text, const Dimension& dimension) {
    const auto unit = try_parse_unit(text);
    return unit && unit->dimension == dimension;
}

HeaderCell parse_header_cell(std::string_view cell) {
    cell = trimmed(cell);
    if (auto found = with_brackets(cell)) return *found;
    if (auto found = with_word(cell, " / ")) return *found;
    if (auto found = with_word(cell, " in ")) return *found;
    if (auto found = with_word(cell, ", ")) return *found;
    if (auto found = with_trailing_unit(cell)) return with_unit_of_rate(*found);
    if (auto found = with_slash(cell)) return *found;
    if (auto found = with_underscore(cell)) return *found;
    return {std::string(cell), {}};
}

std::vector<HeaderCell> parse_header(const std::vector<std::string>& header, char separator, std::size_t least,
                                     std::size_t most) {
    auto line = header.rbegin();
    std::vector<std::string> last;
    for (; line != header.rend() && last.empty(); ++line) last = header_cells(*line, separator, least, most);
    if (last.empty()) return {};
    const auto above =
        line == header.rend() ? std::vector<std::string>{} : header_cells(*line, separator, last.size(), last.size());
    const auto units = unit_row(last, !above.empty());
    if (units.empty()) return name_row(last);
    auto names = above.empty() ? std::vector<HeaderCell>(units.size()) : name_row(above);
    for (std::size_t i = 0; i < units.size(); ++i) {
        if (!names[i].unit.empty() && names[i].unit != units[i])
            throw InvalidArgument(
                fmt::format("mixed units: column '{}' is in {} according to its name and in {} according to the row of "
                            "units; correct one of them",
                            names[i].name, names[i].unit, units[i].empty() ? "no unit" : units[i]));
        names[i].unit = units[i];
    }
    return names;
}

}  // namespace setae::tables
