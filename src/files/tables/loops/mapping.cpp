// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/tables/mapping.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "expression.hpp"
#include "expression_text.hpp"
#include "setae/bytes/text.hpp"
#include "setae/bytes/toml_reader.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/tables/header.hpp"

namespace setae::tables {
namespace {

TableOptions parse_file(bytes::TomlReader reader) {
    TableOptions options;
    options.encoding = reader
                           .choice<bytes::Encoding>("encoding", {{"utf-8", bytes::Encoding::utf8},
                                                                 {"utf-16", bytes::Encoding::utf16},
                                                                 {"latin-1", bytes::Encoding::latin1}})
                           .value_or(options.encoding);
    options.separator =
        reader.choice<char>("separator", {{"tab", '\t'}, {"comma", ','}, {"semicolon", ';'}, {"blank", ' '}});
    options.decimal_point = reader.choice<char>("decimal", {{"point", '.'}, {"comma", ','}});
    options.header_end = reader.text("header_end");
    options.sheet = reader.text("sheet");
    reader.finish();
    return options;
}

/// A unit in `key`.
Unit unit_of(const bytes::TomlReader& reader, const char* key, const std::string& unit) {
    try {
        return parse_unit(unit);
    } catch (const InvalidArgument& error) {
        reader.fail(key, error.what());
    }
}

void require_name(const bytes::TomlReader& reader, const std::string& name) {
    if (!is_identifier(name))
        reader.fail(name.c_str(), fmt::format("'{}' cannot be a name in expressions; use letters, digits and _", name));
}

/// "3.01 N/m": the number and the unit after it.
MappedConstant parse_constant(bytes::TomlReader& reader, const std::string& name) {
    const char* key = name.c_str();
    require_name(reader, name);
    if (reader.is_number(key)) return {name, *reader.number(key), {}};
    const auto source = reader.required_text(key);
    const auto blank = std::min(source.find(' '), source.size());
    double number = 0.0;
    if (!bytes::parse_cell(std::string_view(source).substr(0, blank), '.', number) || !std::isfinite(number))
        reader.fail(key, fmt::format("constant '{}' is '{}', expected a number and its unit such as \"3.01 N/m\"", name,
                                     source));
    const auto unit = blank < source.size() ? unit_of(reader, key, source.substr(blank)) : Unit{};
    return {name, number * unit.factor, unit.dimension};
}

MappedColumn parse_column(const std::string& name, bytes::TomlReader reader) {
    MappedColumn column{name, reader.text("header"), {}, reader.text("unit")};
    if (const auto position = reader.integer("position")) {
        if (*position < 1) reader.fail("position", "the position of a column starts at 1");
        column.position = static_cast<Index>(*position);
    }
    if (column.header.has_value() == column.position.has_value())
        reader.fail("header", fmt::format("column '{}' needs either header or position", name));
    if (column.header == "?" || column.unit == "?")
        reader.fail(column.unit == "?" ? "unit" : "header",
                    "a \"?\" marks information that the file does not contain; replace it by the answer");
    if (column.unit) (void)unit_of(reader, "unit", *column.unit);
    reader.finish();
    return column;
}

std::optional<Dimension> canonical_dimension(const std::string& name) {
    if (name == "force") return dimension::force;
    if (name == "displacement" || name == "contact_radius") return dimension::length;
    if (name == "time") return dimension::time;
    return std::nullopt;
}

/// NAME = { expression, unit }.
MappedResult parse_result_with_unit(const std::string& name, bytes::TomlReader reader) {
    const auto unit = reader.required_text("unit");
    MappedResult result{name, reader.required_text("expression"), unit_of(reader, "unit", unit).dimension};
    const auto canonical = canonical_dimension(name);
    if (canonical && result.dimension != *canonical)
        reader.fail("unit", fmt::format("'{}' has the unit '{}', expected one of {}", name, unit, si_unit(*canonical)));
    reader.finish();
    return result;
}

MappedResult parse_result(bytes::TomlReader& reader, const std::string& name) {
    MappedResult result;
    if (reader.is_table(name.c_str())) {
        reader.table(name.c_str(),
                     [&](bytes::TomlReader inner) { result = parse_result_with_unit(name, std::move(inner)); });
        return result;
    }
    const auto canonical = canonical_dimension(name);
    if (!canonical)
        reader.fail(name.c_str(),
                    fmt::format("the unit of '{}' is not known; write {} = {{ expression = \"…\", unit = \"…\" }}",
                                name, name));
    return {name, reader.required_text(name.c_str()), *canonical};
}

std::vector<std::string> names_of(const Mapping& mapping) {
    std::vector<std::string> names;
    for (const auto& constant : mapping.constants) names.push_back(constant.name);
    for (const auto& column : mapping.columns) names.push_back(column.name);
    return names;
}

}  // namespace

Mapping read_mapping(const std::string& path) {
    const auto document = bytes::parse_toml_file(path);
    bytes::TomlReader reader(document, path, "");
    Mapping mapping;
    mapping.path = path;
    reader.table("file", [&](bytes::TomlReader file) { mapping.file = parse_file(std::move(file)); });
    reader.table("constants", [&](bytes::TomlReader constants) {
        for (const auto& name : constants.keys()) mapping.constants.push_back(parse_constant(constants, name));
    });
    reader.named_tables("columns", [&](const std::string& name, bytes::TomlReader column) {
        require_name(column, name);
        mapping.columns.push_back(parse_column(name, std::move(column)));
    });
    reader.table("table", [&](bytes::TomlReader results) {
        for (const auto& name : results.keys()) mapping.results.push_back(parse_result(results, name));
    });
    reader.finish();
    // only now: a misspelt [constants] is the error, not the expressions with its names
    reader.table("table", [&](const bytes::TomlReader& results) {
        for (const auto& result : mapping.results) {
            try {
                require_expression(result.expression, names_of(mapping));
            } catch (const InvalidArgument& error) {
                results.fail(result.name.c_str(), error.what());
            }
        }
    });
    if (mapping.columns.empty() || mapping.results.empty())
        throw FormatError(path, {}, "a mapping needs at least one [columns.NAME] and one entry in [table]");
    return mapping;
}

Mapping with_results(Mapping mapping, const std::map<std::string, std::string>& expressions) {
    for (const auto& [name, text] : expressions) {
        const auto canonical = canonical_dimension(name);
        if (!canonical)
            throw InvalidArgument(
                fmt::format("'{}' = {}: expected force, displacement, contact_radius or time", name, text));
        const auto parts = expression_text(text, mapping.constants.size() + 1);
        mapping.constants.insert(mapping.constants.end(), parts.constants.begin(), parts.constants.end());
        try {
            require_expression(parts.expression, names_of(mapping));
        } catch (const InvalidArgument& error) {
            throw InvalidArgument(fmt::format("{} = {}: {}; the mapping {} has {}", name, text, error.what(),
                                              mapping.path, fmt::join(names_of(mapping), ", ")));
        }
        const auto replaced = std::find_if(mapping.results.begin(), mapping.results.end(),
                                           [&](const MappedResult& result) { return result.name == name; });
        if (replaced == mapping.results.end()) mapping.results.push_back({name, parts.expression, *canonical});
        else *replaced = {name, parts.expression, *canonical};
    }
    return mapping;
}

namespace {

std::string listed_headers(const RawTable& table) {
    std::vector<std::string> cells;
    for (const auto& column : table.columns)
        cells.push_back(column.name.empty()   ? "(no name)"
                        : column.unit.empty() ? column.name
                                              : fmt::format("{} [{}]", column.name, column.unit));
    return fmt::format("{}", fmt::join(cells, ", "));
}

bool same_header(const RawTable::RawColumn& column, const std::string& wanted) {
    const auto cell = parse_header_cell(wanted);
    return !column.name.empty() && folded(column.name) == folded(cell.name) &&
           (cell.unit.empty() || cell.unit == column.unit);
}

/// nullptr if the table lacks the column.
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
        if (!find_column(table, column))
            missing.push_back(column.header ? fmt::format("'{}'", *column.header)
                                            : fmt::format("{}", *column.position));
    if (missing.empty()) return;
    throw FormatError(
        path, {},
        fmt::format("no column {}; the file has {}: {}", fmt::join(missing, ", "),
                    table.columns.size() == 1 ? "one column" : fmt::format("{} columns", table.columns.size()),
                    listed_headers(table)));
}

/// A column in SI and its dimension.
struct SiColumn {
    Array1D values;
    Dimension dimension;
};

SiColumn in_si(const RawTable::RawColumn& column, const MappedColumn& wanted, const std::string& path) {
    if (!column.text.empty())
        throw FormatError(path, {},
                          fmt::format("column '{}' contains text ({}), expected numbers", wanted.name, column.text));
    if (column.values.isNaN().all())
        throw FormatError(
            path, {},
            fmt::format("column '{}' has no numbers: all {} values are undefined", wanted.name, column.values.size()));
    const auto name = wanted.unit ? *wanted.unit : column.unit;
    if (name.empty())
        throw FormatError(
            path, {},
            fmt::format("column '{}' has no unit; write unit = \"mN\", or the right unit, into [columns.{}] of the "
                        "mapping",
                        wanted.name, wanted.name));
    const auto unit = try_parse_unit(name);
    if (!unit) throw FormatError(path, {}, fmt::format("column '{}' has the unknown unit '{}'", wanted.name, name));
    return {column.values * unit->factor, unit->dimension};
}

}  // namespace

Table read_mapped_table(const std::string& path, const Mapping& mapping) {
    return mapped_table(read_raw_table(bytes::file_source(path), mapping.file), path, mapping);
}

Table mapped_table(const RawTable& raw, const std::string& path, const Mapping& mapping) {
    require_columns(raw, mapping, path);
    ExpressionInputs inputs;
    for (const auto& column : mapping.columns) {
        const auto si = in_si(*find_column(raw, column), column, path);
        inputs.columns.push_back({column.name, si.values, si.dimension});
    }
    inputs.constants = mapping.constants;
    Table table;
    table.metadata = raw.metadata;
    table.metadata["file"] = path;
    table.metadata["mapping"] = mapping.path;
    if (!raw.header.empty()) table.metadata["header"] = fmt::format("{}", fmt::join(raw.header, "\n"));
    for (const auto& result : mapping.results) {
        try {
            table.columns.push_back(
                {result.name, si_unit(result.dimension), evaluate(result.expression, inputs, result.dimension)});
        } catch (const InvalidArgument& error) {
            if (mapping.path.empty())
                throw FormatError(path, {},
                                  fmt::format("{} = \"{}\": {}", result.name, result.expression, error.what()));
            throw FormatError(
                mapping.path, {},
                fmt::format("{} = \"{}\" for {}: {}", result.name, result.expression, path, error.what()));
        }
    }
    return table;
}

}  // namespace setae::tables
