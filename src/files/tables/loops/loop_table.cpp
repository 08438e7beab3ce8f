// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "setae/bytes/source.hpp"
#include "setae/bytes/text.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/tables/column_guess.hpp"
#include "setae/tables/table_file.hpp"

namespace setae::tables {
namespace {

struct LoopColumn {
    const char* name;
    const char* unit;
};
constexpr LoopColumn loop_columns[] = {{"force", "N"}, {"displacement", "m"}, {"contact_radius", "m"}, {"time", "s"}};

std::string shown(const std::string& name, const std::string& unit) {
    return unit.empty() ? name : fmt::format("{} [{}]", name, unit);
}

std::string column_list(const Table& table) {
    std::vector<std::string> names;
    for (const auto& column : table.columns) names.push_back(shown(column.name, column.unit));
    return fmt::format("{}", fmt::join(names, ", "));
}

bool is_loop_column(const std::string& name) {
    return std::any_of(std::begin(loop_columns), std::end(loop_columns),
                       [&](const LoopColumn& known) { return known.name == name; });
}

/// Positions of the columns of the file in a mapping.
std::set<std::size_t> columns_in(const Mapping& mapping, const ColumnGuess& guess) {
    std::set<std::size_t> positions;
    for (const auto& column : mapping.columns)
        for (std::size_t k = 0; k < guess.columns.size(); ++k)
            if (column.position ? static_cast<std::size_t>(*column.position) == k + 1
                                : column.header == guess.columns[k].name)
                positions.insert(k);
    return positions;
}

/// Columns recognised by words as force, displacement, contact radius or time, if no column has that name. A role with
/// two candidates remains open.
void take_guessed(LoopTable& loop, const ColumnGuess& guess, LoopColumns wanted,
                  const std::set<std::size_t>& of_chosen) {
    for (const auto& role : guess.roles) {
        if (wanted == LoopColumns::force_record && role.role == "contact_radius") continue;  // that of the camera
        if (loop.table.find(role.role) || role.candidates.size() != 1) continue;
        const RoleCandidate& candidate = role.candidates.front();
        const auto& column = guess.columns[candidate.column];
        if (!column.note.empty() || of_chosen.contains(candidate.column) ||
            is_loop_column(loop.table.columns[candidate.column].name))
            continue;
        Column& taken = loop.table.columns[candidate.column];
        if (candidate.derivation == Derivation::radius_of_area) {
            taken.values = (taken.values / pi).sqrt();
            taken.unit = "m";
        }
        if (candidate.derivation == Derivation::negative) taken.values = -taken.values;
        taken.name = role.role;
        loop.channels[role.role] = channel_name(guess, candidate);
        loop.taken.push_back(
            fmt::format("{} from '{}': {}", role.role, shown(column.name, column.unit), candidate.reason));
    }
}

/// Columns of a table in the form of a file, in SI.
RawTable raw_table_of(const Table& table) {
    RawTable raw;
    for (const auto& column : table.columns) raw.columns.push_back({column.name, column.unit, column.values, {}});
    return raw;
}

void put_column(Table& table, const Column& column) {
    std::erase_if(table.columns, [&](const Column& other) { return other.name == column.name; });
    table.columns.push_back(column);
}

}  // namespace

void require_loop_columns(const Table& table, const std::string& path, LoopColumns wanted) {
    const auto missing = [&](const char* what) {
        throw FormatError(
            path, {},
            fmt::format("no column {}; a loop needs 'force' and 'displacement' or 'contact_radius', and the table has: "
                        "{}; name the columns in a mapping file, which `setae jkr import --save-map` writes",
                        what, column_list(table)));
    };
    if (!table.find("force")) missing("'force'");
    if (wanted == LoopColumns::complete && !table.find("displacement") && !table.find("contact_radius"))
        missing("'displacement' or 'contact_radius'");
    for (const auto& [name, unit] : loop_columns) {
        const auto* column = table.find(name);
        if (column && column->unit != unit)
            throw FormatError(path, {},
                              fmt::format("column '{}' has {}, expected a unit of {} as in '{} [{}]'", name,
                                          column->unit.empty() ? "no unit" : fmt::format("the unit '{}'", column->unit),
                                          unit, name, unit));
    }
}

LoopTable read_loop_table(const std::string& path, LoopColumns wanted, const ChosenColumns& chosen) {
    const auto raw = read_raw_table(bytes::file_source(path));
    const auto guess = guess_columns(raw, path);
    const auto mapping = mapping_of_chosen(guess, chosen);
    const auto of_chosen = columns_in(mapping, guess);
    LoopTable loop{.table = table_in_si(raw, path)};
    for (std::size_t k = 0; k < guess.columns.size(); ++k) {
        auto& column = loop.table.columns[k];
        const auto name = bytes::lowered(column.name);
        if (!is_loop_column(name)) continue;
        column.name = name;
        loop.channels[name] = channel_name(guess, {.column = k});
    }
    take_guessed(loop, guess, wanted, of_chosen);
    for (std::size_t k = 0; k < guess.columns.size(); ++k)
        if (!is_loop_column(loop.table.columns[k].name) && !of_chosen.contains(k))
            loop.unused.push_back(shown(guess.columns[k].name, guess.columns[k].unit));
    if (!chosen.empty())
        for (const auto& column : mapped_table(raw, path, mapping).columns) {
            put_column(loop.table, column);
            loop.channels[column.name] = channel_chosen(guess, column.name, chosen.at(column.name));
        }
    try {
        require_loop_columns(loop.table, path, wanted);
    } catch (const FormatError&) {
        (void)mapping_from(guess, chosen, wanted);  // reports the column, its problem and the option
        throw;
    }
    return loop;
}

ChannelNames channels_of(const Table& loop) {
    ChannelNames channels;
    for (const auto& [name, unit] : loop_columns)
        if (loop.find(name)) channels[name] = {name, unit, name};
    return channels;
}

ChannelNames choose_columns(Table& loop, const std::string& path, const ChosenColumns& chosen) {
    auto channels = channels_of(loop);
    if (chosen.empty()) return channels;
    const auto raw = raw_table_of(loop);
    const auto guess = guess_columns(raw, path);
    for (const auto& column : mapped_table(raw, path, mapping_of_chosen(guess, chosen)).columns) {
        put_column(loop, column);
        channels[column.name] = channel_chosen(guess, column.name, chosen.at(column.name));
    }
    return channels;
}

}  // namespace setae::tables
