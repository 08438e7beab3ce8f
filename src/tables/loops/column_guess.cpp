// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/tables/column_guess.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "expression_text.hpp"
#include "setae/bytes/source.hpp"
#include "setae/bytes/text.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/number_text.hpp"
#include "setae/core/text.hpp"
#include "setae/tables/header.hpp"
#include "setae/tables/spreadsheet.hpp"

namespace setae::tables {
namespace {

constexpr const char* undefined_note = "all values undefined";
constexpr double sure = 0.95, phrase = 0.85, symbol = 0.7, by_unit = 0.5, derived = 0.6;

/// The words of one role; phrases hold one of the words beside others.
struct Vocabulary {
    const char* role;
    Dimension dimension;
    std::vector<std::string> names;    ///< whole names
    std::vector<std::string> words;    ///< within a name
    std::vector<std::string> symbols;  ///< whole names in the file's own case
};

const std::vector<Vocabulary>& vocabularies() {
    static const std::vector<Vocabulary> all{
        {"force",
         dimension::force,
         {"force", "load", "normal force", "normal load", "applied force", "applied load"},
         {"force", "load", "kraft", "last"},
         {"F", "P", "FN", "Fn", "F_N", "F_n", "Fz", "F_z"}},
        {"displacement",
         dimension::length,
         {"displacement", "indentation", "penetration", "indentation depth", "approach"},
         {"displacement", "displ", "disp", "indentation", "penetration", "depth", "stage", "piezo", "position",
          "travel", "extension", "weg", "zpiezo", "zsensor"},
         {"d", "z", "Z", "h", "δ", "delta", "Δ"}},
        {"contact_radius",
         dimension::length,
         {"contact radius", "radius of contact", "contact_radius"},
         {"radius", "radii", "kontaktradius"},
         {"a", "r_c", "rc", "a_c"}},
        {"time", dimension::time, {"time", "elapsed time"}, {"time", "zeit", "clock", "timestamp", "temps"}, {"t"}}};
    return all;
}

/// Words of a name in lower case: letters and digits between anything else.
std::vector<std::string> words_of(std::string_view name) {
    std::vector<std::string> words(1);
    for (const char c : bytes::lowered(name)) {
        const bool part = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || static_cast<unsigned char>(c) >= 0x80;
        if (part) words.back() += c;
        else if (!words.back().empty()) words.emplace_back();
    }
    if (words.back().empty()) words.pop_back();
    return words;
}

/// A word that makes a column something else than the quantity beside it.
const std::string* qualifier(const std::vector<std::string>& words, bool of_radius = false) {
    static const std::set<std::string> any{
        "std",      "stdev",    "sd",      "sem",      "sigma",    "error", "err", "uncertainty", "noise",
        "setpoint", "target",   "rate",    "speed",    "velocity", "slope", "max", "min",         "temperature",
        "temp",     "humidity", "lateral", "friction", "shear",    "x",     "y"};
    static const std::set<std::string> radius{"sphere", "lens", "tip", "probe", "bead", "curvature"};
    for (const auto& word : words)
        for (const auto* set : {&any, &radius})
            if (const auto found = set->find(word);
                found != set->end() && words.size() > 1 && (set == &any || of_radius))
                return &*found;
    return nullptr;
}

template <class Container, class Value>
bool contains(const Container& container, const Value& value) {
    return std::find(container.begin(), container.end(), value) != container.end();
}

struct Named {
    double confidence = 0.0;
    std::string reason;
};

/// How well a name fits a role; 0 where it does not.
Named by_name(const std::string& name, const Vocabulary& role) {
    const auto words = words_of(name);
    const auto plain = fmt::format("{}", fmt::join(words, " "));
    if (qualifier(words, role.role == std::string_view("contact_radius"))) return {};
    if (contains(role.names, plain)) return {sure, fmt::format("'{}' is a word for {}", name, role.role)};
    for (const auto& word : words)
        if (contains(role.words, word))
            return plain == word ? Named{sure, fmt::format("'{}' is a word for {}", name, role.role)}
                                 : Named{phrase, fmt::format("'{}' holds '{}', a word for {}", name, word, role.role)};
    if (contains(role.symbols, name)) return {symbol, fmt::format("'{}' is a symbol of {}", name, role.role)};
    return {};
}

bool is_area(const std::string& name) {
    const auto words = words_of(name);
    return name == "A" || name == "A_c" ||
           (contains(words, "area") && (words.size() == 1 || contains(words, "contact")) && !qualifier(words));
}

std::string with_unit(const std::string& reason, const std::string& unit) {
    return unit.empty() ? reason + "; it has no unit" : fmt::format("{}, {} its unit", reason, unit);
}

/// Words may be known of two roles ("contact radius" also as a radius): the best one counts.
RoleGuess candidates_of(const RawTable& table, const Vocabulary& role) {
    RoleGuess guess{role.role, {}};
    for (std::size_t k = 0; k < table.columns.size(); ++k) {
        const auto& column = table.columns[k];
        const auto unit = try_parse_unit(column.unit);
        if (!column.text.empty() || (!column.unit.empty() && (!unit || unit->dimension != role.dimension))) continue;
        const auto named = by_name(column.name, role);
        if (named.confidence == 0.0) continue;
        guess.candidates.push_back({k, column.unit.empty() ? 0.8 * named.confidence : named.confidence,
                                    with_unit(named.reason, column.unit), false});
    }
    return guess;
}

/// The only column with a unit of the role, where words say nothing.
void add_by_unit(const RawTable& table, const Vocabulary& role, RoleGuess& guess) {
    if (!guess.candidates.empty() || role.dimension == dimension::length) return;
    std::vector<std::size_t> found;
    for (std::size_t k = 0; k < table.columns.size(); ++k) {
        const auto unit = try_parse_unit(table.columns[k].unit);
        if (unit && unit->dimension == role.dimension && table.columns[k].text.empty() &&
            !qualifier(words_of(table.columns[k].name)))
            found.push_back(k);
    }
    for (const auto k : found)
        guess.candidates.push_back({k, by_unit,
                                    fmt::format("{} is a unit of {}{}", table.columns[k].unit, role.role,
                                                found.size() == 1 ? " and no other column has one" : ""),
                                    false});
}

void add_from_area(const RawTable& table, RoleGuess& radius) {
    if (!radius.candidates.empty()) return;
    for (std::size_t k = 0; k < table.columns.size(); ++k) {
        const auto& column = table.columns[k];
        const auto unit = try_parse_unit(column.unit);
        if (!column.text.empty() || !is_area(column.name) || !unit || unit->dimension != dimension::area) continue;
        radius.candidates.push_back(
            {k, derived,
             fmt::format("'{}' is an area, {} its unit: the radius of the circle with that area, sqrt(A/π)",
                         column.name, column.unit),
             true});
    }
}

/// A column serves one role: where two want it, the surer keeps it.
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
    else if (column.values.isNaN().all()) result.note = undefined_note;
    else if (column.unit.empty()) result.note = "no unit";
    else if (!try_parse_unit(column.unit)) result.note = "unknown unit";
    return result;
}

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

ColumnGuess guess_columns(const RawTable& table, const std::string& path, const TableOptions& file) {
    ColumnGuess guess{path, file, {}, {}};
    guess.file.separator = table.separator;
    guess.file.decimal_point = table.decimal_point;
    for (const auto& column : table.columns) guess.columns.push_back(shown(column));
    for (const auto& role : vocabularies()) {
        guess.roles.push_back(candidates_of(table, role));
        add_by_unit(table, role, guess.roles.back());
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
           "signs are taken as they are: force positive where it presses, displacement growing into the contact\n";
}

namespace {

/// Position of a column that a user names by header or number.
std::size_t column_named(const ColumnGuess& guess, const std::string& role, const std::string& wanted) {
    const auto position = spelled<std::size_t>(wanted).value_or(0);
    if (position >= 1 && position <= guess.columns.size()) return position - 1;
    std::vector<std::size_t> found;
    std::vector<std::string> names;
    const auto cell = parse_header_cell(wanted);
    for (std::size_t k = 0; k < guess.columns.size(); ++k) {
        const auto& column = guess.columns[k];
        names.push_back(label(guess, k));
        if (!column.name.empty() && bytes::lowered(column.name) == bytes::lowered(cell.name) &&
            (cell.unit.empty() || cell.unit == column.unit))
            found.push_back(k);
    }
    if (found.size() == 1) return found.front();
    throw FormatError(guess.path, {},
                      fmt::format("{} column '{}' was chosen for {}, the file has {}",
                                  found.empty() ? "no" : "more than one", wanted, role, fmt::join(names, ", ")));
}

/// The column that an expression names.
std::size_t column_in_expression(const ColumnGuess& guess, const std::string& role, const std::string& name) {
    std::vector<std::size_t> found;
    std::vector<std::string> names;
    for (std::size_t k = 0; k < guess.columns.size(); ++k) {
        const auto own = name_in_expressions(guess.columns[k].name), numbered = fmt::format("column{}", k + 1);
        if (name == own || name == numbered) return k;
        if (own.starts_with(bytes::lowered(name))) found.push_back(k);
        names.push_back(own.empty() ? numbered : own);
    }
    if (found.size() == 1) return found.front();
    throw FormatError(guess.path, {},
                      fmt::format("{} column '{}' of the expression for {}, the file has {}",
                                  found.empty() ? "no" : "more than one", name, role, fmt::join(names, ", ")));
}

bool names_column(const ColumnGuess& guess, const std::string& text) {
    const auto position = spelled<std::size_t>(text).value_or(0);
    return (position >= 1 && position <= guess.columns.size()) ||
           std::any_of(guess.columns.begin(), guess.columns.end(), [&](const ColumnGuess::Shown& column) {
               return !column.name.empty() &&
                      bytes::lowered(column.name) == bytes::lowered(parse_header_cell(text).name);
           });
}

/// Whether a choice is no column but an expression over columns.
bool is_expression(const ColumnGuess& guess, const std::string& text) {
    return text.find_first_of("+-*/^()") != std::string::npos && !names_column(guess, text);
}

/// The column of a role; nothing where there is none.
std::optional<RoleCandidate> decided(const ColumnGuess& guess, const RoleGuess& role,
                                     const std::map<std::string, std::string>& chosen) {
    if (const auto choice = chosen.find(role.role); choice != chosen.end()) {
        const auto column = column_named(guess, role.role, choice->second);
        const auto unit = try_parse_unit(guess.columns[column].unit);
        return RoleCandidate{column, 1.0, "chosen",
                             role.role == "contact_radius" && unit && unit->dimension == dimension::area};
    }
    if (role.candidates.empty()) return std::nullopt;
    if (role.candidates.size() > 1)
        throw FormatError(guess.path, {},
                          fmt::format("{} may be {}; choose one by its header or position, or in a mapping file",
                                      role.role, labels(guess, role)));
    return role.candidates.front();
}

void require_usable(const ColumnGuess& guess, const std::string& role, std::size_t column) {
    const auto& shown = guess.columns[column];
    const auto refuse = [&](const std::string& what) {
        throw FormatError(guess.path, {}, fmt::format("{} for {} {}", label(guess, column), role, what));
    };
    if (shown.note.starts_with("text")) refuse(fmt::format("holds {}, expected numbers", shown.note));
    if (shown.note == undefined_note) refuse("holds no number at all");
    if (shown.note == "no unit")
        refuse("has no unit; write it into the header, as in 'force [mN]', or into a mapping file");
    if (shown.note == "unknown unit") refuse("has a unit setae does not know; give it in a mapping file");
}

/// By header where that names one column, else by position.
MappedColumn mapped(const ColumnGuess& guess, const std::string& name, std::size_t column) {
    std::size_t same = 0;
    for (const auto& other : guess.columns)
        same += bytes::lowered(other.name) == bytes::lowered(guess.columns[column].name) ? 1 : 0;
    MappedColumn result{name, {}, {}, {}};
    if (same == 1 && !guess.columns[column].name.empty()) result.header = guess.columns[column].name;
    else result.position = static_cast<Index>(column) + 1;
    return result;
}

Dimension dimension_of_role(const std::string& role) {
    return role == "force" ? dimension::force : role == "time" ? dimension::time : dimension::length;
}

/// A role that is computed from columns.
void add_expression(const ColumnGuess& guess, const std::string& role, const std::string& text, Mapping& mapping) {
    const auto parts = expression_text(text, mapping.constants.size() + 1);
    for (const auto& name : parts.names) {
        const auto column = column_in_expression(guess, role, name);
        require_usable(guess, role, column);
        const auto known = std::any_of(mapping.columns.begin(), mapping.columns.end(),
                                       [&](const MappedColumn& other) { return other.name == name; });
        if (!known) mapping.columns.push_back(mapped(guess, name, column));
    }
    mapping.constants.insert(mapping.constants.end(), parts.constants.begin(), parts.constants.end());
    mapping.results.push_back({role, parts.expression, dimension_of_role(role)});
    mapping.notes.push_back(fmt::format("{}: {}, chosen", role, text));
}

void require_roles(const ColumnGuess& guess, const std::map<std::string, std::string>& chosen) {
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

}  // namespace

Mapping mapping_from(const ColumnGuess& guess, const std::map<std::string, std::string>& chosen, LoopColumns wanted) {
    require_roles(guess, chosen);
    Mapping mapping;
    mapping.file = guess.file;
    std::set<std::string> found;
    for (const auto& role : guess.roles) {
        if (const auto choice = chosen.find(role.role);
            choice != chosen.end() && is_expression(guess, choice->second)) {
            add_expression(guess, role.role, choice->second, mapping);
            found.insert(role.role);
            continue;
        }
        const auto candidate = decided(guess, role, chosen);
        if (!candidate) continue;
        if (guess.columns[candidate->column].note == undefined_note && !chosen.contains(role.role)) {
            mapping.notes.push_back(
                fmt::format("{}: {} left out, it holds no number at all", role.role, label(guess, candidate->column)));
            continue;
        }
        require_usable(guess, role.role, candidate->column);
        const std::string name = candidate->from_area ? "contact_area" : role.role + "_column";
        mapping.columns.push_back(mapped(guess, name, candidate->column));
        mapping.results.push_back(
            {role.role, candidate->from_area ? "sqrt(contact_area / _pi)" : name, dimension_of_role(role.role)});
        mapping.notes.push_back(
            fmt::format("{}: {}, {}", role.role, label(guess, candidate->column), candidate->reason));
        found.insert(role.role);
    }
    const bool enough =
        wanted == LoopColumns::force_record || found.contains("displacement") || found.contains("contact_radius");
    if (!found.contains("force") || !enough) {
        std::vector<std::string> names;
        for (std::size_t k = 0; k < guess.columns.size(); ++k)
            names.push_back(guess.columns[k].note == undefined_note
                                ? fmt::format("{} ({})", label(guess, k), undefined_note)
                                : label(guess, k));
        throw FormatError(
            guess.path, {},
            fmt::format("no column found for {}, the file has {}; name it by a mapping file",
                        found.contains("force") ? "displacement or contact_radius" : "force", fmt::join(names, ", ")));
    }
    return mapping;
}

}  // namespace setae::tables
