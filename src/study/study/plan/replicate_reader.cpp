// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/study/replicate_reader.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include <fmt/format.h>

#include "setae/bytes/text.hpp"
#include "setae/bytes/toml_reader.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/core/units.hpp"
#include "setae/tables/text_table.hpp"

namespace setae::study {
namespace {

namespace fs = std::filesystem;

/// Names of columns of a quantity, in the order of the search.
std::vector<std::string> names_of(const std::string& quantity) {
    static const std::vector<std::vector<std::string>> known{
        {"W", "work_of_adhesion", "W_app", "w"},
        {"E*", "E_star", "contact_modulus"},
        {"E_loss", "energy_loss", "loop_energy"},
        {"F_po", "F_pull_off", "pull_off_force", "F_pulloff"},
    };
    for (const auto& names : known)
        if (std::find(names.begin(), names.end(), quantity) != names.end()) {
            std::vector<std::string> list{quantity};
            list.insert(list.end(), names.begin(), names.end());
            return list;
        }
    return {quantity};
}

std::vector<std::string> error_names(const std::string& value) {
    return {value + " standard_error", value + "_standard_error",   value + "_se", value + " se", value + " stderr",
            "standard_error " + value, "standard_error of " + value};
}

/// Columns of one table.
struct Places {
    std::size_t value = 0;
    std::optional<std::size_t> error, method, branch, elastomer, file, primary, cycle, reason;
    std::vector<std::size_t> groups;
    double factor = 1.0, error_factor = 1.0;
    std::string unit;  ///< SI
};

[[noreturn]] void fail(const tables::TextTable& table, const std::string& what) {
    throw FormatError(table.path, {}, what + "; the columns are " + table.names());
}

std::size_t required(const tables::TextTable& table, const std::string& name, const std::string& remedy) {
    const auto place = table.find({name});
    if (!place) fail(table, fmt::format("no column '{}'{}", name, remedy));
    return *place;
}

Places places_of(const tables::TextTable& table, const ReplicateColumns& wanted,
                 const std::vector<std::string>& levels) {
    Places places;
    if (!wanted.value_column.empty()) places.value = required(table, wanted.value_column, "");
    else if (const auto found = table.find(names_of(wanted.quantity))) places.value = *found;
    else fail(table, fmt::format("no column of '{}'; name it in `value`", wanted.quantity));
    const auto& value = table.columns[places.value];
    if (!wanted.error_column.empty()) places.error = required(table, wanted.error_column, "");
    else places.error = table.find(error_names(value.name));
    for (const auto& level : levels) {
        const auto found = level == "lens" ? table.find({"lens", "hemisphere"}) : table.find({level});
        if (!found) fail(table, fmt::format("no column '{}' to group by", level));
        places.groups.push_back(*found);
    }
    places.method = table.find({"method"});
    places.branch = table.find({"branch"});
    if (std::find(levels.begin(), levels.end(), "elastomer") == levels.end())
        places.elastomer = table.find({"elastomer"});
    places.primary = table.find({"primary"});
    if (table.find({"contact"})) places.cycle = table.find({"cycle"});
    places.reason = table.find({"reason"});
    places.file = table.find({"file"});
    const auto& unit = value.unit.empty() ? wanted.unit : value.unit;
    if (unit.empty())
        throw FormatError(
            table.path, {},
            fmt::format("column '{}' has no unit; write it as \"{} [mJ/m2]\" or give `unit`", value.name, value.name));
    const auto parsed = parse_unit(unit);
    places.factor = places.error_factor = parsed.factor;
    places.unit = si_unit(parsed.dimension);
    if (places.error && !table.columns[*places.error].unit.empty())
        places.error_factor = unit_factor(table.columns[*places.error].unit, parsed.dimension);
    return places;
}

/// NaN where the cell holds no number.
double number_in(std::string cell, char separator) {
    if (separator != ',') std::replace(cell.begin(), cell.end(), ',', '.');
    double value = undefined;
    return bytes::parse_cell(cell, '.', value) ? value : undefined;
}

/// Levels of the tables, where the user names none: those of surface, lens and spot that every table has.
std::vector<std::string> levels_of(const std::vector<tables::TextTable>& tables, const ReplicateColumns& wanted) {
    if (!wanted.group_by.empty()) return wanted.group_by;
    std::vector<std::string> levels;
    for (const char* name : {"surface", "lens", "spot"}) {
        const auto has = [&](const tables::TextTable& table) {
            return table
                .find(std::string(name) == "lens" ? std::vector<std::string>{"lens", "hemisphere"}
                                                  : std::vector<std::string>{name})
                .has_value();
        };
        if (std::all_of(tables.begin(), tables.end(), has)) levels.emplace_back(name);
        else if (levels.empty()) break;
    }
    if (levels.empty()) fail(tables.front(), "no column 'surface'; name the groups in `group_by`, outermost first");
    return levels;
}

/// A row of a table with the requested values, with its columns for exclusions.
struct Candidate {
    const tables::TextTable* table;
    const tables::TextTable::Row* row;
    const Places* places;

    [[nodiscard]] std::string place() const { return fmt::format("{}:{}", table->path, row->line); }
    [[nodiscard]] bool meets(const ExclusionRule& rule) const {
        return std::all_of(rule.conditions.begin(), rule.conditions.end(), [&](const auto& condition) {
            if (condition.first == "line") return std::to_string(row->line) == condition.second;
            const auto column = table->find({condition.first});
            if (!column)
                fail(*table,
                     fmt::format("no column '{}', which the exclusion '{}' names", condition.first, rule.where));
            const auto& cell = row->cells[*column];
            return cell == condition.second ||
                   (condition.first == "file" && fs::path(cell).filename() == condition.second);
        });
    }
};

/// Rows of one method and branch.
std::vector<Candidate> chosen_rows(const std::vector<tables::TextTable>& tables, const std::vector<Places>& places,
                                   const ReplicateColumns& wanted) {
    std::vector<Candidate> rows;
    for (std::size_t t = 0; t < tables.size(); ++t)
        for (const auto& row : tables[t].rows) rows.push_back({&tables[t], &row, &places[t]});
    using Column = std::optional<std::size_t> Places::*;
    const auto kinds = [&](Column column) {
        std::set<std::string> seen;
        for (const auto& row : rows)
            if (row.places->*column && !row.row->cells[row.places->value].empty())
                seen.insert(row.row->cells[*(row.places->*column)]);
        return seen;
    };
    const bool by_primary = wanted.method.empty() || wanted.method == "primary";
    struct Choice {
        Column column;
        std::string wanted;
        const char* what;
    };
    const std::vector<Choice> choices{{&Places::elastomer, wanted.elastomer, "elastomer"},
                                      {&Places::branch, wanted.branch, "branch"},
                                      {&Places::method, by_primary ? "" : wanted.method, "method"}};
    for (const auto& choice : choices) {
        if (choice.wanted.empty()) continue;
        const auto seen = kinds(choice.column);
        std::erase_if(rows, [&](const Candidate& row) {
            return row.places->*choice.column && row.row->cells[*(row.places->*choice.column)] != choice.wanted;
        });
        if (rows.empty())
            throw UndefinedDataError(
                fmt::format("no row of {} '{}'; there are {}", choice.what, choice.wanted, fmt::join(seen, ", ")));
    }
    const bool named_primary =
        by_primary && std::all_of(places.begin(), places.end(), [](const Places& p) { return p.primary.has_value(); });
    if (named_primary)  // a row without method gives the reason for a missing fit of a branch
        std::erase_if(rows, [](const Candidate& row) {
            return row.row->cells[*row.places->primary] != "yes" &&
                   !(row.places->method && row.row->cells[*row.places->method].empty());
        });
    for (const auto& choice : choices) {
        if (!choice.wanted.empty() || (named_primary && choice.column == &Places::method)) continue;
        if (const auto seen = kinds(choice.column); seen.size() > 1)
            throw InvalidArgument(
                fmt::format("several kinds of '{}': {}; one loop would count several times; choose one with `{}`",
                            choice.what, fmt::join(seen, ", "), choice.what));
    }
    // a contact's whole loop and its cycles are the same energy twice
    const auto whole = [](const Candidate& row) {
        return row.places->cycle && !row.places->branch && row.row->cells[*row.places->cycle].empty();
    };
    if (std::any_of(rows.begin(), rows.end(), whole))
        std::erase_if(rows, [&](const Candidate& row) { return row.places->cycle && !whole(row); });
    return rows;
}

void require_complete(const ExclusionRule& rule) {
    if (rule.reason.empty())
        throw InvalidArgument(fmt::format("exclusion '{}' without a reason; add reason=…", rule.where));
    if (rule.conditions.empty())
        throw InvalidArgument(
            fmt::format("exclusion '{}' names no row; expected for instance file=loop.csv", rule.where));
}

}  // namespace

ExclusionRule parse_exclusion(const std::string& text) {
    ExclusionRule rule{.where = text};
    for (std::size_t at = 0; at <= text.size();) {
        const auto end = std::min(text.find(';', at), text.size());
        const auto part = std::string(trimmed(std::string_view(text).substr(at, end - at)));
        at = end + 1;
        if (part.empty()) continue;
        const auto equals = part.find('=');
        if (equals == std::string::npos)
            throw InvalidArgument(
                fmt::format("exclusion '{}': '{}' has no '='; expected \"file=loop.csv;reason=why\"", text, part));
        const auto key = std::string(trimmed(part.substr(0, equals))),
                   value = std::string(trimmed(part.substr(equals + 1)));
        if (key == "reason") rule.reason = value;
        else rule.conditions[key] = value;
    }
    require_complete(rule);
    return rule;
}

std::vector<ExclusionRule> read_exclusions(const std::string& path) {
    std::vector<ExclusionRule> rules;
    const auto add = [&](ExclusionRule rule, std::size_t line) {
        try {
            require_complete(rule);
        } catch (const InvalidArgument& error) {
            throw FormatError(path, {.line = line}, error.what());
        }
        rules.push_back(std::move(rule));
    };
    if (fs::path(path).extension() == ".toml") {
        const auto document = bytes::parse_toml_file(path);
        bytes::TomlReader reader(document, path, "");
        reader.each_table("exclude", [&](bytes::TomlReader entry) {
            ExclusionRule rule{.where = path};
            for (const auto& key : entry.keys()) {
                const auto value = entry.is_number(key.c_str()) ? std::to_string(*entry.integer(key.c_str()))
                                                                : entry.required_text(key.c_str());
                if (key == "reason") rule.reason = value;
                else rule.conditions[key] = value;
            }
            if (rule.reason.empty()) entry.fail("reason", "an exclusion without a reason");
            if (rule.conditions.empty())
                entry.fail("file", "an exclusion names no row; expected for instance file = \"loop.csv\"");
            rules.push_back(std::move(rule));
        });
        reader.finish();
        return rules;
    }
    const auto table = tables::read_text_table(path);
    const auto reason = table.find({"reason"});
    if (!reason) fail(table, "no column 'reason'");
    for (const auto& row : table.rows) {
        ExclusionRule rule{.where = fmt::format("{}:{}", path, row.line)};
        for (std::size_t i = 0; i < row.cells.size(); ++i) {
            if (i == *reason) rule.reason = row.cells[i];
            else if (!row.cells[i].empty()) rule.conditions[table.columns[i].name] = row.cells[i];
        }
        add(std::move(rule), row.line);
    }
    return rules;
}

ReplicateTables read_replicates(const std::vector<std::string>& paths, const ReplicateColumns& columns,
                                const std::vector<ExclusionRule>& exclusions) {
    if (paths.empty()) throw InvalidArgument("no table is given; expected CSV files with one row per fit");
    std::vector<tables::TextTable> tables;
    for (const auto& path : paths) tables.push_back(tables::read_text_table(path));
    ReplicateTables result;
    auto& data = result.data;
    data.levels = levels_of(tables, columns);
    data.quantity = columns.value_column.empty() ? columns.quantity : columns.value_column;
    std::vector<Places> places;
    for (const auto& table : tables) {
        places.push_back(places_of(table, columns, data.levels));
        if (places.back().unit != places.front().unit)
            throw FormatError(table.path, {},
                              fmt::format("'{}' in {}, but in {} the unit is {}", data.quantity, places.back().unit,
                                          tables.front().path, places.front().unit));
    }
    data.unit = places.front().unit;
    std::vector<int> met(exclusions.size());
    const auto chosen = chosen_rows(tables, places, columns);
    // a level that no row names is missing as a whole; the surface never is
    std::vector<bool> named(data.levels.size());
    for (std::size_t level = 0; level < data.levels.size(); ++level)
        named[level] = level == 0 || std::any_of(chosen.begin(), chosen.end(), [&](const Candidate& row) {
                           return !row.row->cells[row.places->groups[level]].empty();
                       });
    for (const auto& row : chosen) {
        const auto bad = [&](const std::string& reason) { result.bad_rows.push_back({row.place(), reason}); };
        const auto& cells = row.row->cells;
        const auto& at = *row.places;
        statistics::Replicate replicate{.value = at.factor * number_in(cells[at.value], row.table->separator),
                                        .name = at.file ? cells[*at.file] : row.place()};
        const ExclusionRule* excluded = nullptr;
        for (std::size_t i = 0; i < exclusions.size(); ++i) {
            if (!row.meets(exclusions[i])) continue;
            ++met[i];
            if (excluded)
                throw InvalidArgument(fmt::format("{} is excluded twice: '{}' and '{}'; keep one", row.place(),
                                                  excluded->where, exclusions[i].where));
            excluded = &exclusions[i];
        }
        if (!std::isfinite(replicate.value)) {
            bad(cells[at.value].empty()
                    ? fmt::format("no {}{}", data.quantity,
                                  at.reason && !cells[*at.reason].empty() ? ": " + cells[*at.reason] : "")
                    : fmt::format("{} is '{}'; expected a number", data.quantity, cells[at.value]));
            continue;
        }
        if (at.error) {
            replicate.standard_error = at.error_factor * number_in(cells[*at.error], row.table->separator);
            if (replicate.standard_error < 0.0 || std::isinf(replicate.standard_error)) {
                bad(fmt::format("standard error '{}'; expected a number >= 0, or none", cells[*at.error]));
                continue;
            }
        }
        std::string missing;
        for (std::size_t level = 0; level < at.groups.size(); ++level) {
            replicate.groups.push_back(cells[at.groups[level]]);
            if (replicate.groups.back().empty() && named[level]) missing = data.levels[level];
        }
        if (!missing.empty()) {
            bad(fmt::format("no {}", missing));
            continue;
        }
        data.rows.push_back(std::move(replicate));
        if (excluded) data.exclusions.push_back({data.rows.size() - 1, excluded->reason});
    }
    if (data.rows.empty())
        throw UndefinedDataError(fmt::format(
            "{}: no row with a number in '{}'{}", paths.front(), data.quantity,
            result.bad_rows.empty() ? ""
                                    : "; " + result.bad_rows.front().place + ": " + result.bad_rows.front().reason));
    for (std::size_t i = 0; i < exclusions.size(); ++i)
        if (met[i] == 0)
            throw InvalidArgument(
                fmt::format("no row meets the exclusion '{}'; check its columns and texts", exclusions[i].where));
    return result;
}

}  // namespace setae::study
