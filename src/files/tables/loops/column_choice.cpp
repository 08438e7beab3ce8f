// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "expression_text.hpp"
#include "loop_words.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/number_text.hpp"
#include "setae/core/text.hpp"
#include "setae/tables/column_guess.hpp"
#include "setae/tables/header.hpp"

namespace setae::tables {
namespace {

Dimension dimension_of_role(const std::string& role) {
    return role == "force" ? dimension::force : role == "time" ? dimension::time : dimension::length;
}

/// A unit in which a column of the role may be, for an example.
const char* usual_unit(const std::string& role) { return role == "force" ? "mN" : role == "time" ? "s" : "um"; }

std::vector<std::string> all_labels(const ColumnGuess& guess) {
    std::vector<std::string> names;
    for (std::size_t k = 0; k < guess.columns.size(); ++k)
        names.push_back(guess.columns[k].note == ColumnGuess::undefined_note
                            ? fmt::format("{} ({})", label(guess, k), ColumnGuess::undefined_note)
                            : label(guess, k));
    return names;
}

/// Columns chosen by the text of a header or a position; a unit selects among columns with one name.
std::vector<std::size_t> columns_named(const ColumnGuess& guess, const HeaderCell& wanted) {
    const auto position = spelled<std::size_t>(wanted.name).value_or(0);
    if (position >= 1 && position <= guess.columns.size()) return {position - 1};
    std::vector<std::size_t> same_name, same_unit;
    for (std::size_t k = 0; k < guess.columns.size(); ++k) {
        const auto& column = guess.columns[k];
        const bool named = !column.name.empty() &&
                           (folded(column.name) == folded(wanted.name) || expression_name(guess, k) == wanted.name);
        if (!named) continue;
        same_name.push_back(k);
        if (column.unit == wanted.unit) same_unit.push_back(k);
    }
    return same_unit.empty() || wanted.unit.empty() ? same_name : same_unit;
}

/// The column chosen by the user for a role, with the unit that replaces that of the header.
RoleCandidate column_chosen(const ColumnGuess& guess, const std::string& role, const std::string& text) {
    const auto wanted = parse_header_cell(text);
    const auto found = columns_named(guess, wanted);
    if (found.size() != 1)
        throw FormatError(
            guess.path, {},
            fmt::format("{} column '{}' was chosen for {}; the file has {}", found.empty() ? "no" : "more than one",
                        text, role, fmt::join(all_labels(guess), ", ")));
    RoleCandidate candidate{found.front(), 1.0, "chosen"};
    const auto& column = guess.columns[found.front()];
    if (!wanted.unit.empty() && wanted.unit != column.unit) {
        candidate.unit = wanted.unit;
        candidate.reason +=
            fmt::format(" in {}{}", wanted.unit, column.unit.empty() ? "" : fmt::format(" instead of {}", column.unit));
    }
    const auto unit = try_parse_unit(candidate.unit.value_or(column.unit));
    if (role == "contact_radius" && unit && unit->dimension == dimension::area)
        candidate.derivation = Derivation::radius_of_area;
    return candidate;
}

/// Whether a choice is no column but an expression over columns.
bool is_expression(const ColumnGuess& guess, const std::string& text) {
    return text.find_first_of("+-*/^()") != std::string::npos && columns_named(guess, parse_header_cell(text)).empty();
}

/// The column of a role; empty if there is none.
std::optional<RoleCandidate> decided(const ColumnGuess& guess, const RoleGuess& role, const ChosenColumns& chosen) {
    if (const auto choice = chosen.find(role.role); choice != chosen.end())
        return column_chosen(guess, role.role, choice->second);
    if (role.candidates.empty()) return std::nullopt;
    if (role.candidates.size() > 1)
        throw FormatError(
            guess.path, {},
            fmt::format("{} may be {}; choose one: {}", role.role, labels(guess, role),
                        column_option({{role.role, expression_name(guess, role.candidates.front().column)}})));
    return role.candidates.front();
}

[[noreturn]] void refuse(const ColumnGuess& guess, const std::string& role, std::size_t column,
                         const std::string& what) {
    throw FormatError(guess.path, {}, fmt::format("{} for {} {}", label(guess, column), role, what));
}

/// @throws FormatError for a column that holds no numbers.
void require_numbers(const ColumnGuess& guess, const std::string& role, std::size_t column) {
    const auto& shown = guess.columns[column];
    if (shown.note.starts_with("text"))
        refuse(guess, role, column, fmt::format("has {}, expected numbers", shown.note));
    if (shown.note == ColumnGuess::undefined_note) refuse(guess, role, column, "has no numbers");
}

/// The problem of a unit of another dimension: "is in g, a unit of mass; …".
std::string misfit(const ColumnGuess& guess, const std::string& role, std::size_t column, const std::string& unit) {
    if (role == "force" && !weight_unit(unit).empty())
        return fmt::format(
            "is in {}, a unit of mass; expected a force: if a balance measured it, the force is its weight: "
            "{}",
            unit, column_option({{role, fmt::format("{}[{}]", expression_name(guess, column), weight_unit(unit))}}));
    return fmt::format("is in {}, expected a unit of {} such as {}", unit, si_unit(dimension_of_role(role)),
                       usual_unit(role));
}

/// @throws FormatError for a unit that does not fit the role; a missing unit is reported elsewhere.
void require_unit(const ColumnGuess& guess, const std::string& role, const RoleCandidate& candidate) {
    const auto text = candidate.unit.value_or(guess.columns[candidate.column].unit);
    if (text.empty()) return;
    const auto unit = try_parse_unit(text);
    if (!unit)
        refuse(guess, role, candidate.column,
               fmt::format("has the unknown unit '{}'; give a known one: {}", text,
                           column_option({{role, fmt::format("{}[{}]", expression_name(guess, candidate.column),
                                                             usual_unit(role))}})));
    const bool area = candidate.derivation == Derivation::radius_of_area && unit->dimension == dimension::area;
    if (area || unit->dimension == dimension_of_role(role)) return;
    refuse(guess, role, candidate.column, misfit(guess, role, candidate.column, text));
}

/// By header if that is unique, otherwise by position.
MappedColumn mapped(const ColumnGuess& guess, const std::string& name, const RoleCandidate& candidate) {
    const auto& header = guess.columns[candidate.column].name;
    const auto same = std::count_if(guess.columns.begin(), guess.columns.end(),
                                    [&](const auto& other) { return folded(other.name) == folded(header); });
    MappedColumn result{name, {}, {}, candidate.unit};
    if (same == 1 && !header.empty()) result.header = header;
    else result.position = static_cast<Index>(candidate.column) + 1;
    return result;
}

/// The column of a name in an expression.
std::size_t column_in_expression(const ColumnGuess& guess, const std::string& role, const std::string& name) {
    std::vector<std::size_t> found;
    std::vector<std::string> names;
    for (std::size_t k = 0; k < guess.columns.size(); ++k) {
        const auto own = name_in_expressions(guess.columns[k].name), numbered = fmt::format("column{}", k + 1);
        if (name == own || name == numbered) return k;
        if (own.starts_with(folded(name))) found.push_back(k);
        names.push_back(own.empty() ? numbered : own);
    }
    if (found.size() == 1) return found.front();
    throw FormatError(guess.path, {},
                      fmt::format("{} column '{}' of the expression for {}; the file has {}",
                                  found.empty() ? "no" : "more than one", name, role, fmt::join(names, ", ")));
}

/// A role that is computed from columns. One without a unit is a plain number.
void add_expression(const ColumnGuess& guess, const std::string& role, const std::string& text, Mapping& mapping) {
    const auto parts = expression_text(text, mapping.constants.size() + 1);
    for (const auto& name : parts.names) {
        RoleCandidate candidate{column_in_expression(guess, role, name), 1.0, "chosen"};
        require_numbers(guess, role, candidate.column);
        const auto& shown = guess.columns[candidate.column];
        if (const auto unit = parts.units.find(name); unit != parts.units.end()) candidate.unit = unit->second;
        else if (shown.unit.empty()) candidate.unit = "1";
        if (const auto unit = candidate.unit.value_or(shown.unit); !try_parse_unit(unit))
            refuse(guess, role, candidate.column,
                   fmt::format("has the unknown unit '{}'; give a known one: {}[{}]", unit, name, usual_unit(role)));
        const auto column = mapped(guess, name, candidate);
        const auto known = std::find_if(mapping.columns.begin(), mapping.columns.end(),
                                        [&](const MappedColumn& other) { return other.name == name; });
        if (known == mapping.columns.end()) mapping.columns.push_back(column);
        else if (*known != column)
            refuse(guess, role, candidate.column, "has two units; give one unit in all expressions");
    }
    mapping.constants.insert(mapping.constants.end(), parts.constants.begin(), parts.constants.end());
    mapping.results.push_back({role, parts.expression, dimension_of_role(role)});
    mapping.notes.push_back(fmt::format("{}: {}, chosen", role, text));
}

std::string derived_name(const RoleCandidate& candidate, const std::string& role) {
    switch (candidate.derivation) {
        case Derivation::none: return role + "_column";
        case Derivation::negative: return "gap";
        case Derivation::radius_of_area: return "contact_area";
    }
    throw InternalError("a derivation without a name");
}

void add_column(const ColumnGuess& guess, const std::string& role, const RoleCandidate& candidate, Mapping& mapping) {
    const auto name = derived_name(candidate, role);
    mapping.columns.push_back(mapped(guess, name, candidate));
    mapping.results.push_back({role,
                               candidate.derivation == Derivation::radius_of_area ? "sqrt(contact_area / _pi)"
                               : candidate.derivation == Derivation::negative     ? "-1 * " + name
                                                                                  : name,
                               dimension_of_role(role)});
    mapping.notes.push_back(fmt::format("{}: {}, {}", role, label(guess, candidate.column), candidate.reason));
}

void require_roles(const ColumnGuess& guess, const ChosenColumns& chosen) {
    for (const auto& [role, column] : chosen) {
        const bool known = std::any_of(guess.roles.begin(), guess.roles.end(),
                                       [&](const RoleGuess& guessed) { return guessed.role == role; });
        if (!known)
            throw FormatError(
                guess.path, {},
                fmt::format("column '{}' was chosen for '{}', expected force, displacement, contact_radius or time",
                            column, role));
    }
}

/// A role and the column that lacks its unit.
using WithoutUnit = std::pair<std::string, std::size_t>;

void add_checked(const ColumnGuess& guess, const std::string& role, const RoleCandidate& candidate, Mapping& mapping,
                 std::vector<WithoutUnit>& without_unit) {
    require_numbers(guess, role, candidate.column);
    require_unit(guess, role, candidate);
    if (guess.columns[candidate.column].unit.empty() && !candidate.unit)
        without_unit.emplace_back(role, candidate.column);
    add_column(guess, role, candidate, mapping);
}

[[noreturn]] void refuse_without_units(const ColumnGuess& guess, const std::vector<WithoutUnit>& columns) {
    std::vector<std::string> names;
    ChosenColumns stated;
    for (const auto& [role, column] : columns) {
        names.push_back(fmt::format("{} for {}", label(guess, column), role));
        stated[role] = fmt::format("{}[{}]", expression_name(guess, column), usual_unit(role));
    }
    throw FormatError(
        guess.path, {},
        fmt::format("{} {} no unit; write it into the header, as in 'force [mN]', or give the unit of the numbers: "
                    "{}",
                    fmt::join(names, " and "), columns.size() == 1 ? "has" : "have", column_option(stated)));
}

/// A column with the name of a role whose unit has another dimension; empty if there is none.
std::string misfit_among(const ColumnGuess& guess, const std::string& role) {
    for (const auto& vocabulary : loop_vocabularies())
        for (std::size_t k = 0; k < guess.columns.size() && vocabulary.role == role; ++k) {
            const auto& column = guess.columns[k];
            const auto unit = try_parse_unit(column.unit);
            if (unit && unit->dimension != vocabulary.dimension && named_role(column.name, vocabulary).confidence > 0.0)
                return fmt::format("; {} {}", label(guess, k), misfit(guess, role, k, column.unit));
        }
    return "";
}

/// The position of a column that may be that of a role: the first with a unit of the role and of no other role.
std::string likely_position(const ColumnGuess& guess, const std::string& role) {
    for (std::size_t k = 0; k < guess.columns.size(); ++k)
        if (is_unit_of(guess.columns[k].unit, dimension_of_role(role))) return fmt::format("{}", k + 1);
    return "2";
}

[[noreturn]] void refuse_missing(const ColumnGuess& guess, bool force) {
    const std::string role = force ? "displacement" : "force";
    const auto wrong = misfit_among(guess, role);
    throw FormatError(
        guess.path, {},
        fmt::format("no column is found for {}; the file has {}{}", force ? "displacement or contact_radius" : "force",
                    fmt::join(all_labels(guess), ", "),
                    wrong.empty() ? fmt::format("; name it by its header or position: {}",
                                                column_option({{role, likely_position(guess, role)}}))
                                  : wrong));
}

/// A column of the role, its best candidate if none is chosen; empty if it has none.
std::optional<RoleCandidate> best_candidate(const ColumnGuess& guess, const RoleGuess& role,
                                            const ChosenColumns& chosen) {
    if (chosen.contains(role.role)) return decided(guess, role, chosen);
    return role.candidates.empty() ? std::nullopt : std::optional(role.candidates.front());
}

}  // namespace

std::string weight_unit(const std::string& unit) {
    const auto mass = try_parse_unit(unit);
    const auto weight = try_parse_unit(unit + "f");
    const Dimension of_mass = dimension::force / (dimension::length / (dimension::time * dimension::time));
    return mass && mass->dimension == of_mass && weight && weight->dimension == dimension::force ? unit + "f" : "";
}

std::string expression_name(const ColumnGuess& guess, std::size_t column) {
    const auto name = name_in_expressions(guess.columns[column].name);
    const auto same = std::count_if(guess.columns.begin(), guess.columns.end(),
                                    [&](const auto& other) { return name_in_expressions(other.name) == name; });
    const bool usable = !name.empty() && !(name.front() >= '0' && name.front() <= '9') && same == 1;
    return usable ? name : fmt::format("column{}", column + 1);
}

std::string column_option(const ChosenColumns& chosen) {
    std::string options, keys;
    for (const auto& [role, text] : chosen) {
        options += fmt::format("{}--column {}={}", options.empty() ? "" : " ", role,
                               shell_word(text) == text ? text : fmt::format("\"{}\"", text));
        keys += fmt::format("{}{} = \"{}\"", keys.empty() ? "" : ", ", role, text);
    }
    return fmt::format("{} (in a study columns = {{ {} }})", options, keys);
}

Mapping mapping_from(const ColumnGuess& guess, const ChosenColumns& chosen, LoopColumns wanted) {
    require_roles(guess, chosen);
    Mapping mapping;
    mapping.file = guess.file;
    std::set<std::string> found;
    std::vector<WithoutUnit> without_unit;
    for (const auto& role : guess.roles) {
        if (const auto choice = chosen.find(role.role);
            choice != chosen.end() && is_expression(guess, choice->second)) {
            add_expression(guess, role.role, choice->second, mapping);
            found.insert(role.role);
            continue;
        }
        const auto candidate = decided(guess, role, chosen);
        if (!candidate) continue;
        if (guess.columns[candidate->column].note == ColumnGuess::undefined_note && !chosen.contains(role.role)) {
            mapping.notes.push_back(fmt::format("{}: {} was left out, since it has no numbers", role.role,
                                                label(guess, candidate->column)));
            continue;
        }
        add_checked(guess, role.role, *candidate, mapping, without_unit);
        found.insert(role.role);
    }
    const bool enough =
        wanted == LoopColumns::force_record || found.contains("displacement") || found.contains("contact_radius");
    if (!found.contains("force") || !enough) refuse_missing(guess, found.contains("force"));
    if (!without_unit.empty()) refuse_without_units(guess, without_unit);
    return mapping;
}

Mapping mapping_of_chosen(const ColumnGuess& guess, const ChosenColumns& chosen) {
    require_roles(guess, chosen);
    Mapping mapping;
    std::vector<WithoutUnit> without_unit;
    for (const auto& [role, text] : chosen)
        if (is_expression(guess, text)) add_expression(guess, role, text, mapping);
        else add_checked(guess, role, column_chosen(guess, role, text), mapping, without_unit);
    if (!without_unit.empty()) refuse_without_units(guess, without_unit);
    return mapping;
}

ChannelName channel_name(const ColumnGuess& guess, const RoleCandidate& candidate) {
    const auto column = expression_name(guess, candidate.column);
    const auto plain = candidate.unit ? fmt::format("{}[{}]", column, *candidate.unit) : column;
    return {column, candidate.unit.value_or(guess.columns[candidate.column].unit),
            candidate.derivation == Derivation::negative ? "-1 * " + plain : plain};
}

ChannelName channel_chosen(const ColumnGuess& guess, const std::string& role, const std::string& text) {
    return is_expression(guess, text) ? ChannelName{"", "", text}
                                      : channel_name(guess, column_chosen(guess, role, text));
}

std::string mapping_template(const ColumnGuess& guess, const ChosenColumns& chosen, LoopColumns wanted) {
    require_roles(guess, chosen);
    constexpr const char* question = "?";
    Mapping mapping;
    mapping.file = guess.file;
    mapping.notes.emplace_back("A \"?\" marks information that the file does not contain: replace it by the answer.");
    mapping.notes.push_back(fmt::format("The file has {}.", fmt::join(all_labels(guess), ", ")));
    for (const auto& role : guess.roles) {
        if (const auto choice = chosen.find(role.role);
            choice != chosen.end() && is_expression(guess, choice->second)) {
            add_expression(guess, role.role, choice->second, mapping);
            continue;
        }
        auto candidate = best_candidate(guess, role, chosen);
        const bool needed = role.role == "force" || (role.role == "displacement" && wanted == LoopColumns::complete);
        if (!candidate && !needed) continue;
        if (!candidate) {
            mapping.columns.push_back({role.role + "_column", question, {}, question});
            mapping.results.push_back({role.role, role.role + "_column", dimension_of_role(role.role)});
            mapping.notes.push_back(role.role + ": no column is found");
            continue;
        }
        const auto unit = candidate->unit.value_or(guess.columns[candidate->column].unit);
        if (!try_parse_unit(unit)) candidate->unit = question;
        add_column(guess, role.role, *candidate, mapping);
        if (role.candidates.size() > 1 && !chosen.contains(role.role))
            mapping.notes.back() += "; other candidates: " + labels(guess, role);
    }
    return as_toml(mapping);
}

}  // namespace setae::tables
