// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/tables/power_spectrum_table.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "setae/bytes/source.hpp"
#include "setae/bytes/text.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"
#include "setae/tables/table_file.hpp"

namespace setae::tables {
namespace {

Column in_si(const RawTable::RawColumn& raw, const char* name, const Dimension& expected, const std::string& path) {
    try {
        return {name, si_unit(expected), raw.values * unit_factor(raw.unit, expected)};
    } catch (const InvalidArgument& error) {
        throw FormatError(path, {}, fmt::format("column '{}' as {}: {}", raw.name, name, error.what()));
    }
}

bool is_standard_error(const std::string& name) {
    const auto lower = bytes::lowered(name);
    return lower.find("err") != std::string::npos || lower.find("std") != std::string::npos;
}

/// The dialect ';' with decimal comma begins with a row that is no data, even where it holds numbers.
void drop_first_row(RawTable& table) {
    for (auto& column : table.columns) column.values = Array1D(column.values.tail(column.values.size() - 1));
}

}  // namespace

Table read_power_spectrum_table(const std::string& path) {
    auto raw = read_raw_table(bytes::file_source(path));
    auto& columns = raw.columns;
    if (columns.size() < 2)
        throw FormatError(path, {}, fmt::format("{} column, expected wavevector and C1D", columns.size()));
    Table table;
    table.metadata["file"] = path;
    const bool any_unit = std::any_of(columns.begin(), columns.end(), [](const auto& c) { return !c.unit.empty(); });
    if (!any_unit) {
        if (columns.size() != 2)
            throw FormatError(
                path, {},
                fmt::format("{} columns without units; write them in the header, as 'q [1/m]', 'C1D [m3]'",
                            columns.size()));
        columns[0].unit = "1/m";
        columns[1].unit = "m3";
        table.metadata["units"] = "assumed SI";
        if (raw.separator == ';' && raw.decimal_point == ',' && raw.header.empty()) drop_first_row(raw);
    }
    table.columns.push_back(in_si(columns[0], "wavevector", dimension::wavevector, path));
    table.columns.push_back(in_si(columns[1], "C1D", dimension::power_spectrum_1d, path));
    if (columns.size() > 2 && is_standard_error(columns[2].name))
        table.columns.push_back(in_si(columns[2], "standard_error", dimension::power_spectrum_1d, path));
    if (!(table.columns[0].values > 0.0).any())
        throw FormatError(path, {}, fmt::format("no positive wavevector among {} rows", table.rows()));
    return table;
}

}  // namespace setae::tables
