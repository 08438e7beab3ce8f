// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

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

/// Columns that words tell to be force, displacement, contact radius or time, where no column has that name itself. A
/// role that two columns may play is left open.
void take_guessed(LoopTable& loop, const ColumnGuess& guess, LoopColumns wanted) {
    for (const auto& role : guess.roles) {
        if (wanted == LoopColumns::force_record && role.role == "contact_radius") continue;  // the camera's
        if (loop.table.find(role.role) || role.candidates.size() != 1) continue;
        const RoleCandidate& candidate = role.candidates.front();
        const auto& column = guess.columns[candidate.column];
        if (!column.note.empty() || is_loop_column(loop.table.columns[candidate.column].name)) continue;
        Column& taken = loop.table.columns[candidate.column];
        if (candidate.from_area) {
            taken.values = (taken.values / pi).sqrt();
            taken.unit = "m";
        }
        taken.name = role.role;
        loop.taken.push_back(
            fmt::format("{} from '{}': {}", role.role, shown(column.name, column.unit), candidate.reason));
    }
}

}  // namespace

void require_loop_columns(const Table& table, const std::string& path, LoopColumns wanted) {
    const auto missing = [&](const char* what) {
        throw FormatError(
            path, {},
            fmt::format("no column {}; a loop needs 'force' and 'displacement' or 'contact_radius', the table has: {}; "
                        "name the columns by a mapping file, which `setae jkr import` makes",
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

LoopTable read_loop_table(const std::string& path, LoopColumns wanted) {
    LoopTable loop{.table = read_table(path)};
    bool others = false;
    for (auto& column : loop.table.columns) {
        const std::string name = bytes::lowered(column.name);
        if (is_loop_column(name)) column.name = name;
        else others = true;
    }
    if (others) {
        const ColumnGuess guess = guess_columns(path);
        take_guessed(loop, guess, wanted);
        for (std::size_t k = 0; k < guess.columns.size(); ++k)
            if (!is_loop_column(loop.table.columns[k].name))
                loop.unused.push_back(shown(guess.columns[k].name, guess.columns[k].unit));
    }
    require_loop_columns(loop.table, path, wanted);
    return loop;
}

}  // namespace setae::tables
