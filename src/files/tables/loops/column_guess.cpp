// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/tables/column_guess.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "loop_words.hpp"
#include "setae/bytes/source.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/tables/header.hpp"
#include "setae/tables/spreadsheet.hpp"

namespace setae::tables {
namespace {

constexpr double by_unit = 0.5, derived = 0.6;

std::string with_unit(const std::string& reason, const std::string& unit) {
    return unit.empty() ? reason + "; the column has no unit" : fmt::format("{}, {} its unit", reason, unit);
}

/// Words may belong to two roles ("contact radius" is also a radius): the best one is used.
RoleGuess candidates_of(const RawTable& table, const Vocabulary& role) {
    RoleGuess guess{role.role, {}};
    for (std::size_t k = 0; k < table.columns.size(); ++k) {
        const auto& column = table.columns[k];
        const auto unit = try_parse_unit(column.unit);
        if (!column.text.empty() || (!column.unit.empty() && (!unit || unit->dimension != role.dimension))) continue;
        const auto named = named_role(column.name, role);
        if (named.confidence == 0.0) continue;
        guess.candidates.push_back(
            {k, column.unit.empty() ? 0.8 * named.confidence : named.confidence, with_unit(named.reason, column.unit)});
    }
    return guess;
}

/// A gap decreases on approach: it is a displacement with opposite sign, if no other column is a displacement.
void add_from_gap(const RawTable& table, RoleGuess& displacement) {
    if (!displacement.candidates.empty()) return;
    for (std::size_t k = 0; k < table.columns.size(); ++k) {
        const auto& column = table.columns[k];
        const auto unit = try_parse_unit(column.unit);
        const auto named = named_gap(column.name);
        if (named.confidence == 0.0 || !column.text.empty() ||
            (!column.unit.empty() && (!unit || unit->dimension != dimension::length)))
            continue;
        displacement.candidates.push_back({k, derived,
                                           with_unit(named.reason, column.unit) + ": displacement is its negative",
                                           Derivation::negative});
    }
}

/// The only column with a unit of the role, if words do not decide.
void add_by_unit(const RawTable& table, const Vocabulary& role, RoleGuess& guess) {
    if (!guess.candidates.empty() || role.dimension == dimension::length) return;
    std::vector<std::size_t> found;
    for (std::size_t k = 0; k < table.columns.size(); ++k) {
        const auto unit = try_parse_unit(table.columns[k].unit);
        if (unit && unit->dimension == role.dimension && table.columns[k].text.empty() &&
            !is_qualified(table.columns[k].name))
            found.push_back(k);
    }
    for (const auto k : found)
        guess.candidates.push_back({k, by_unit,
                                    fmt::format("{} is a unit of {}{}", table.columns[k].unit, role.role,
                                                found.size() == 1 ? " and no other column has one" : "")});
}

void add_from_area(const RawTable& table, RoleGuess& radius) {
    if (!radius.candidates.empty()) return;
    for (std::size_t k = 0; k < table.columns.size(); ++k) {
        const auto& column = table.columns[k];
        const auto unit = try_parse_unit(column.unit);
        if (!column.text.empty() || !names_contact_area(column.name) || !unit || unit->dimension != dimension::area)
            continue;
        radius.candidates.push_back(
            {k, derived,
             fmt::format("'{}' is an area, {} its unit: the radius of the circle with that area, sqrt(A/π)",
                         column.name, column.unit),
             Derivation::radius_of_area});
    }
}

/// A column has one role: of two candidates the more probable one keeps it.
void settle(std::vector<RoleGuess>& roles) {
    for (auto& role : roles)
        std::erase_if(role.candidates, [&](const RoleCandidate& candidate) {
            for (const auto& other : roles)
                for (const auto& rival : other.candidates)
                    if (&other != &role && rival.column == candidate.column && rival.confidence > candidate.confidence)
                        return true;
            return false;
        });
    for (auto& role : roles)
        std::stable_sort(role.candidates.begin(), role.candidates.end(),
                         [](const auto& a, const auto& b) { return a.confidence > b.confidence; });
}

ColumnGuess::Shown shown(const RawTable::RawColumn& column) {
    ColumnGuess::Shown result{column.name, column.unit, {}, {}};
    for (Index i = 0; i < std::min<Index>(5, column.values.size()); ++i)
        result.first_values.push_back(column.values[i]);
    if (!column.text.empty()) result.note = fmt::format("text: {}", column.text);
    else if (column.values.isNaN().all()) result.note = ColumnGuess::undefined_note;
    else if (column.unit.empty()) result.note = "no unit";
    else if (!try_parse_unit(column.unit)) result.note = "unknown unit";
    return result;
}

std::string dialect_text(const TableOptions& file) {
    if (!file.separator) return file.sheet ? fmt::format("of the sheet '{}'", *file.sheet) : "of a sheet";
    const char separator = *file.separator;
    return fmt::format("between {}, decimal {}",
                       separator == '\t'  ? "tabs"
                       : separator == ' ' ? "blanks"
                       : separator == ';' ? "semicolons"
                                          : "commas",
                       file.decimal_point.value_or('.') == ',' ? "comma" : "point");
}

}  // namespace

std::string label(const ColumnGuess& guess, std::size_t column) {
    const auto& shown = guess.columns[column];
    const auto name = shown.name.empty() ? std::string("without a name") : fmt::format("'{}'", shown.name);
    return fmt::format("column {} {}{}", column + 1, name, shown.unit.empty() ? "" : fmt::format(" [{}]", shown.unit));
}

std::string labels(const ColumnGuess& guess, const RoleGuess& role) {
    std::string text;
    for (const auto& candidate : role.candidates)
        text += (text.empty() ? "" : " and ") + label(guess, candidate.column);
    return text;
}

ColumnGuess guess_columns(const RawTable& table, const std::string& path, const TableOptions& file) {
    ColumnGuess guess{path, file, {}, {}};
    guess.file.separator = table.separator;
    guess.file.decimal_point = table.decimal_point;
    for (const auto& column : table.columns) guess.columns.push_back(shown(column));
    for (const auto& role : loop_vocabularies()) {
        guess.roles.push_back(candidates_of(table, role));
        add_by_unit(table, role, guess.roles.back());
        if (guess.roles.back().role == "displacement") add_from_gap(table, guess.roles.back());
        if (guess.roles.back().role == "contact_radius") add_from_area(table, guess.roles.back());
    }
    settle(guess.roles);
    return guess;
}

ColumnGuess guess_columns(const std::string& path, const TableOptions& file) {
    const auto source = bytes::file_source(path);
    const auto table = read_raw_table(source, file);
    auto guess = guess_columns(table, path, file);
    if (!is_spreadsheet(source)) return guess;
    guess.file = file;
    if (const auto sheet = table.metadata.find("sheet"); sheet != table.metadata.end())
        guess.file.sheet = sheet->second;
    return guess;
}

std::string describe(const ColumnGuess& guess) {
    std::string text = fmt::format("{}: {} columns {}\n", guess.path, guess.columns.size(), dialect_text(guess.file));
    for (std::size_t k = 0; k < guess.columns.size(); ++k) {
        const auto& column = guess.columns[k];
        text +=
            fmt::format("  {}: {}", label(guess, k),
                        column.note.starts_with("text") ? "" : fmt::format("{}", fmt::join(column.first_values, ", ")));
        text += column.note.empty() ? "\n" : fmt::format(" ({})\n", column.note);
    }
    for (const auto& role : guess.roles) {
        if (role.candidates.empty()) text += fmt::format("{}: no column found\n", role.role);
        if (role.candidates.size() > 1)
            text += fmt::format("{}: undecided between {}; choose one\n", role.role, labels(guess, role));
        for (const auto& candidate : role.candidates)
            text += fmt::format("{}{}: {}, confidence {:.2f}: {}\n", role.candidates.size() > 1 ? "  " : "", role.role,
                                label(guess, candidate.column), candidate.confidence, candidate.reason);
    }
    return text +
           "signs are used as they are: force positive in compression, displacement increasing into the "
           "contact\n";
}

}  // namespace setae::tables
