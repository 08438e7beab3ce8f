// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "setae/core/table.hpp"
#include "setae/core/units.hpp"
#include "setae/io/table_file.hpp"

namespace setae::io {

/// A column of the foreign file under the name expressions use.
struct MappedColumn {
    std::string name;
    std::optional<std::string> header;   ///< text of the header cell, with or without its unit
    std::optional<Index> position;       ///< counted from 1
    std::optional<std::string> unit;     ///< replaces the header's
};

/// A column of the result: an expression over mapped columns and constants, all in SI.
struct MappedResult {
    std::string name;        ///< such as "force"
    std::string expression;  ///< such as "spring_constant * mems"
    Dimension dimension;     ///< the expression is checked to have it
};

/// How a foreign table becomes one with canonical columns; examples/mappings/eoh.toml shows every part.
struct Mapping {
    std::string path;  ///< of the mapping file, for messages
    TableOptions file;
    std::map<std::string, double> constants;  ///< in SI
    std::map<std::string, Dimension> constant_dimensions;
    std::vector<MappedColumn> columns;
    std::vector<MappedResult> results;
};

/// Reads a mapping from TOML: tables [file], [constants], [columns.NAME], [table].
///
/// [file]: encoding, separator ("tab", "comma", "semicolon", "blank"), decimal ("point", "comma"), header_end.
/// [constants]: NAME = "3.01 N/m". [columns.NAME]: header or position (from 1), unit.
/// [table]: force, displacement, contact_radius, time = "expression", any other name = { expression, unit }.
/// Each expression is checked to have the dimension its name or unit says.
/// @throws FileError; FormatError for text that is no TOML, an unknown key (with the nearest known one), a missing or
/// wrong unit, an expression that does not parse or has another dimension.
[[nodiscard]] Mapping read_mapping(const std::string& path);

/// Reads a table through a mapping: columns to SI, then the expressions row by row.
/// @throws FormatError where the file lacks a mapped column; the message lists what the header holds.
[[nodiscard]] Table read_mapped_table(const std::string& path, const Mapping& mapping);

}  // namespace setae::io
