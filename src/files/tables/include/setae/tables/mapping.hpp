// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "setae/core/table.hpp"
#include "setae/core/units.hpp"
#include "setae/tables/table_file.hpp"

namespace setae::tables {

/// A column of the foreign file with its name in expressions.
struct MappedColumn {
    std::string name;
    std::optional<std::string> header;  ///< text of the header cell, with or without its unit
    std::optional<Index> position;      ///< counted from 1
    std::optional<std::string> unit;    ///< replaces the unit of the header

    friend bool operator==(const MappedColumn&, const MappedColumn&) = default;
};

/// A named number for expressions, in SI.
struct MappedConstant {
    std::string name;
    double value = 0.0;
    Dimension dimension;

    friend bool operator==(const MappedConstant&, const MappedConstant&) = default;
};

/// A column of the result: an expression over mapped columns and constants, all in SI.
struct MappedResult {
    std::string name;        ///< such as "force"
    std::string expression;  ///< such as "spring_constant * mems"
    Dimension dimension;     ///< required dimension of the expression

    friend bool operator==(const MappedResult&, const MappedResult&) = default;
};

/// Conversion of a foreign table to canonical columns; examples/mappings/eoh.toml shows every part.
struct Mapping {
    std::string path;  ///< of the mapping file, for messages
    TableOptions file;
    std::vector<MappedConstant> constants;
    std::vector<MappedColumn> columns;
    std::vector<MappedResult> results;
    std::vector<std::string> notes;  ///< comment lines at the top of write_mapping's output; read_mapping ignores them
};

/// Reads a mapping from TOML: tables [file], [constants], [columns.NAME], [table].
///
/// [file]: encoding, separator ("tab", "comma", "semicolon", "blank"), decimal ("point", "comma"), header_end, sheet.
/// [constants]: NAME = "3.01 N/m". [columns.NAME]: header or position (from 1), unit. [table]: force, displacement,
/// contact_radius, time = "expression", any other name = { expression, unit }.
/// @throws FileError; FormatError for text that is no TOML, an unknown key (with the nearest known one), a missing or
/// wrong unit, an expression that does not parse or contains an unknown name.
[[nodiscard]] Mapping read_mapping(const std::string& path);

/// The mapping with other expressions for some of its results, such as {"force", "3.05 N/m * mems"}: numbers with a
/// unit and columns and constants of the mapping. A missing result is added.
/// @throws InvalidArgument for a result other than force, displacement, contact_radius and time, and an expression that
/// does not parse or contains an unknown name.
[[nodiscard]] Mapping with_results(Mapping mapping, const std::map<std::string, std::string>& expressions);

/// A mapping as TOML, from which read_mapping restores the mapping: a template for other files of the same layout.
/// @throws InvalidArgument for a constant that is not finite, or a name that expressions cannot use.
[[nodiscard]] std::string as_toml(const Mapping& mapping);

/// Writes as_toml(mapping) as a whole.
/// @throws FileError; InvalidArgument as as_toml.
void write_mapping(const std::string& path, const Mapping& mapping);

/// Reads a table with a mapping: columns to SI, then the expressions row by row. Each expression must have the
/// dimension of its name or unit: "3.01 * mems" is no force, "spring_constant * mems" is.
/// @throws FileError; FormatError if the file lacks a mapped column (the message lists those it has) or its unit, or if
/// an expression has another dimension.
[[nodiscard]] Table read_mapped_table(const std::string& path, const Mapping& mapping);

/// Applies a mapping to a table read from `path`. @throws FormatError as read_mapped_table.
[[nodiscard]] Table mapped_table(const RawTable& table, const std::string& path, const Mapping& mapping);

}  // namespace setae::tables
