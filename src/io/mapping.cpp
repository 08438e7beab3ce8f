// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/io/mapping.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "expression.hpp"
#include "header.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/io/whole_file.hpp"
#include "text.hpp"

namespace setae::io {
namespace {

std::uint64_t line_of(const toml::node& node) { return node.source().begin.line; }

[[noreturn]] void broken(const std::string& path, const toml::node& node, const std::string& what) {
    throw FormatError(path, {.line = line_of(node)}, what);
}

void require_known_keys(const toml::table& table, std::span<const std::string> known, const std::string& path) {
    for (const auto& [key, node] : table) {
        const std::string name(key.str());
        if (std::find(known.begin(), known.end(), name) != known.end()) continue;
        const auto nearest = nearest_match(name, known);
        broken(path, node,
               nearest.empty() ? fmt::format("unknown key '{}'; expected one of {}", name, fmt::join(known, ", "))
                               : fmt::format("unknown key '{}'; did you mean '{}'?", name, nearest));
    }
}

std::string text(const toml::node& node, std::string_view key, const std::string& path) {
    if (const auto value = node.value<std::string>()) return *value;
    broken(path, node, fmt::format("'{}' is no text in quotes", key));
}

const toml::table& table_of(const toml::node& node, std::string_view key, const std::string& path) {
    if (const auto* table = node.as_table()) return *table;
    broken(path, node, fmt::format("'{}' is no table", key));
}

/// The value a word stands for. @throws FormatError that lists the words.
template <class Value, std::size_t n>
Value choice(const toml::node& node, std::string_view key, const std::array<std::pair<const char*, Value>, n>& choices,
             const std::string& path) {
    const auto word = text(node, key, path);
    std::vector<std::string> words;
    for (const auto& [name, value] : choices) {
        if (word == name) return value;
        words.emplace_back(name);
    }
    broken(path, node, fmt::format("{} '{}', expected one of {}", key, word, fmt::join(words, ", ")));
}

TableOptions parse_file(const toml::table& table, const std::string& path) {
    static const std::vector<std::string> known{"encoding", "separator", "decimal", "header_end"};
    static constexpr std::array<std::pair<const char*, Encoding>, 3> encodings{
        {{"utf-8", Encoding::utf8}, {"utf-16", Encoding::utf16}, {"latin-1", Encoding::latin1}}};
    static constexpr std::array<std::pair<const char*, char>, 4> separators{
        {{"tab", '\t'}, {"comma", ','}, {"semicolon", ';'}, {"blank", ' '}}};
    static constexpr std::array<std::pair<const char*, char>, 2> decimals{{{"point", '.'}, {"comma", ','}}};
    require_known_keys(table, known, path);
    TableOptions options;
    if (const auto* node = table.get("encoding")) options.encoding = choice(*node, "encoding", encodings, path);
    if (const auto* node = table.get("separator")) options.separator = choice(*node, "separator", separators, path);
    if (const auto* node = table.get("decimal")) options.decimal_point = choice(*node, "decimal", decimals, path);
    if (const auto* node = table.get("header_end")) options.header_end = text(*node, "header_end", path);
    return options;
}

Unit unit_of(const toml::node& node, const std::string& unit, const std::string& path) {
    try {
        return parse_unit(unit);
    } catch (const InvalidArgument& error) {
        broken(path, node, error.what());
    }
}

void require_name(const toml::node& node, const std::string& name, const std::string& path) {
    if (!is_identifier(name)) broken(path, node, fmt::format("'{}' is no name expressions can use; take letters, digits and _", name));
}

/// "3.01 N/m": the number and the unit behind it.
MappedConstant parse_constant(const toml::node& node, const std::string& name, const std::string& path) {
    require_name(node, name, path);
    if (const auto number = node.value<double>()) return {name, *number, {}};
    const auto source = text(node, name, path);
    const auto blank = std::min(source.find(' '), source.size());
    double number = 0.0;
    if (!parse_cell(std::string_view(source).substr(0, blank), '.', number) || !std::isfinite(number))
        broken(path, node, fmt::format("constant '{}' is '{}', expected a number and its unit such as \"3.01 N/m\"", name, source));
    const auto unit = blank < source.size() ? unit_of(node, source.substr(blank), path) : Unit{};
    return {name, number * unit.factor, unit.dimension};
}

MappedColumn parse_column(const toml::table& table, const std::string& name, const std::string& path) {
    static const std::vector<std::string> known{"header", "position", "unit"};
    require_known_keys(table, known, path);
    require_name(table, name, path);
    MappedColumn column{name, {}, {}, {}};
    if (const auto* node = table.get("header")) column.header = text(*node, "header", path);
    if (const auto* node = table.get("position")) {
        column.position = node->value<Index>();
        if (!column.position || *column.position < 1) broken(path, *node, "position is counted from 1");
    }
    if (column.header.has_value() == column.position.has_value())
        broken(path, table, fmt::format("column '{}' needs either header or position", name));
    if (const auto* node = table.get("unit")) {
        column.unit = text(*node, "unit", path);
        (void)unit_of(*node, *column.unit, path);
    }
    return column;
}

std::optional<Dimension> canonical_dimension(const std::string& name) {
    if (name == "force") return dimension::force;
    if (name == "displacement" || name == "contact_radius") return dimension::length;
    if (name == "time") return dimension::time;
    return std::nullopt;
}

MappedResult parse_result(const toml::node& node, const std::string& name, const std::string& path) {
    static const std::vector<std::string> known{"expression", "unit"};
    const auto canonical = canonical_dimension(name);
    if (const auto* table = node.as_table()) {
        require_known_keys(*table, known, path);
        const auto *expression = table->get("expression"), *unit = table->get("unit");
        if (!expression || !unit) broken(path, node, fmt::format("'{}' needs expression and unit", name));
        const auto dimension = unit_of(*unit, text(*unit, "unit", path), path).dimension;
        if (canonical && dimension != *canonical)
            broken(path, node, fmt::format("'{}' has the unit '{}', expected one of {}", name, text(*unit, "unit", path), si_unit(*canonical)));
        return {name, text(*expression, "expression", path), dimension};
    }
    if (!canonical)
        broken(path, node, fmt::format("the unit of '{}' is not known; write {} = {{ expression = \"…\", unit = \"…\" }}", name, name));
    return {name, text(node, name, path), *canonical};
}

toml::table parsed(const std::string& path) {
    const auto content = read_file(path);
    try {
        return toml::parse(content, path);
    } catch (const toml::parse_error& error) {
        throw FormatError(path, {.line = error.source().begin.line}, fmt::format("TOML: {}", error.description()));
    }
}

std::vector<std::string> names_of(const Mapping& mapping) {
    std::vector<std::string> names;
    for (const auto& constant : mapping.constants) names.push_back(constant.name);
    for (const auto& column : mapping.columns) names.push_back(column.name);
    return names;
}

}  // namespace

Mapping read_mapping(const std::string& path) {
    static const std::vector<std::string> known{"file", "constants", "columns", "table"};
    const auto document = parsed(path);
    require_known_keys(document, known, path);
    Mapping mapping;
    mapping.path = path;
    if (const auto* node = document.get("file")) mapping.file = parse_file(table_of(*node, "file", path), path);
    if (const auto* node = document.get("constants"))
        for (const auto& [key, value] : table_of(*node, "constants", path))
            mapping.constants.push_back(parse_constant(value, std::string(key.str()), path));
    if (const auto* node = document.get("columns"))
        for (const auto& [key, value] : table_of(*node, "columns", path))
            mapping.columns.push_back(parse_column(table_of(value, key.str(), path), std::string(key.str()), path));
    if (const auto* node = document.get("table"))
        for (const auto& [key, value] : table_of(*node, "table", path)) {
            mapping.results.push_back(parse_result(value, std::string(key.str()), path));
            const auto& result = mapping.results.back();
            try {
                require_expression(result.expression, names_of(mapping));
            } catch (const InvalidArgument& error) {
                broken(path, value, fmt::format("{}: {}", result.name, error.what()));
            }
        }
    if (mapping.columns.empty() || mapping.results.empty())
        throw FormatError(path, {}, "a mapping needs at least one [columns.NAME] and one entry in [table]");
    return mapping;
}

namespace {

std::string listed_headers(const RawTable& table) {
    std::vector<std::string> cells;
    for (const auto& column : table.columns)
        cells.push_back(column.name.empty() ? "(no name)" : column.unit.empty() ? column.name : fmt::format("{} [{}]", column.name, column.unit));
    return fmt::format("{}", fmt::join(cells, ", "));
}

bool same_header(const RawTable::RawColumn& column, const std::string& wanted) {
    const auto cell = parse_header_cell(wanted);
    return !column.name.empty() && lowered(column.name) == lowered(cell.name) && (cell.unit.empty() || cell.unit == column.unit);
}

/// nullptr where the table lacks the column.
const RawTable::RawColumn* find_column(const RawTable& table, const MappedColumn& wanted) {
    if (wanted.position) {
        const auto index = static_cast<std::size_t>(*wanted.position - 1);
        return index < table.columns.size() ? &table.columns[index] : nullptr;
    }
    for (const auto& column : table.columns)
        if (same_header(column, *wanted.header)) return &column;
    return nullptr;
}

void require_columns(const RawTable& table, const Mapping& mapping, const std::string& path) {
    std::vector<std::string> missing;
    for (const auto& column : mapping.columns)
        if (!find_column(table, column)) missing.push_back(column.header ? fmt::format("'{}'", *column.header) : fmt::format("{}", *column.position));
    if (missing.empty()) return;
    throw FormatError(path, {}, fmt::format("no column {}; the file has {}: {}", fmt::join(missing, ", "),
                                            table.columns.size() == 1 ? "one column" : fmt::format("{} columns", table.columns.size()), listed_headers(table)));
}

/// A column in SI and its dimension.
struct SiColumn {
    Array1D values;
    Dimension dimension;
};

SiColumn in_si(const RawTable::RawColumn& column, const MappedColumn& wanted, const std::string& path) {
    const auto name = wanted.unit ? *wanted.unit : column.unit;
    if (name.empty()) throw FormatError(path, {}, fmt::format("column '{}' has no unit; give it in the mapping", wanted.name));
    const auto unit = try_parse_unit(name);
    if (!unit) throw FormatError(path, {}, fmt::format("column '{}' has the unit '{}', which setae does not know", wanted.name, name));
    return {column.values * unit->factor, unit->dimension};
}

}  // namespace

Table read_mapped_table(const std::string& path, const Mapping& mapping) {
    const auto raw = read_raw_table(file_source(path), mapping.file);
    require_columns(raw, mapping, path);
    ExpressionInputs inputs;
    for (const auto& column : mapping.columns) {
        const auto si = in_si(*find_column(raw, column), column, path);
        inputs.columns.push_back({column.name, si.values, si.dimension});
    }
    inputs.constants = mapping.constants;
    Table table;
    table.metadata["file"] = path;
    table.metadata["mapping"] = mapping.path;
    if (!raw.header.empty()) table.metadata["header"] = fmt::format("{}", fmt::join(raw.header, "\n"));
    for (const auto& result : mapping.results) {
        try {
            table.columns.push_back({result.name, si_unit(result.dimension), evaluate(result.expression, inputs, result.dimension)});
        } catch (const InvalidArgument& error) {
            throw FormatError(mapping.path, {}, fmt::format("{} = \"{}\" for {}: {}", result.name, result.expression, path, error.what()));
        }
    }
    return table;
}

}  // namespace setae::io
