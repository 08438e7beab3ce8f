// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/tables/power_spectrum_table.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

#include <fmt/format.h>

#include "setae/bytes/source.hpp"
#include "setae/bytes/text.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
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

bool says_frequency(const std::string& name) {
    const auto lower = bytes::lowered(name);
    return lower.find("freq") != std::string::npos || lower == "f" || lower == "nu" || lower == "ν" ||
           lower == "1/lambda" || lower == "1/λ";
}

bool has_dimension(const std::string& unit, const Dimension& dimension) {
    try {
        return parse_unit(unit).dimension == dimension;
    } catch (const InvalidArgument&) {
        return false;
    }
}

/// What the first column holds: as it is said, else by its unit and name.
std::string quantity_of(const RawTable::RawColumn& column, const SpectrumUnits& units) {
    if (!units.quantity.empty()) return units.quantity;
    if (has_dimension(column.unit, dimension::length)) return "wavelength";
    return says_frequency(column.name) ? "frequency" : "wavevector";
}

/// The first column as wavevectors; says what it was where it was none.
Column wavevectors(const RawTable::RawColumn& raw, Table& table, const std::string& path) {
    constexpr const char* normalised = "; the density counts as that of both signs, h_rms^2 = int C(f) df over +-f";
    const auto& quantity = table.metadata.at("quantity");
    const auto name = raw.name.empty() ? std::string("the first column") : fmt::format("column '{}'", raw.name);
    if (quantity == "wavelength") {
        auto column = in_si(raw, "wavelength", dimension::length, path);
        table.metadata["converted"] = name + " holds wavelengths: q = 2 pi/lambda";
        return {"wavevector", "1/m", 2.0 * pi / column.values};
    }
    auto column = in_si(raw, "wavevector", dimension::wavevector, path);
    if (quantity == "wavevector") return column;
    table.metadata["converted"] = fmt::format("{} holds frequencies: q = 2 pi f{}", name, normalised);
    return {column.name, column.unit, 2.0 * pi * column.values};
}

/// Rows by rising wavevector.
void sort_rows(Table& table, const std::string& path) {
    const auto q = table.columns[0].values;
    std::vector<Index> order(static_cast<std::size_t>(q.size()));
    std::iota(order.begin(), order.end(), Index{0});
    std::stable_sort(order.begin(), order.end(), [&q](Index a, Index b) { return q[a] < q[b]; });
    for (auto& column : table.columns) column.values = Array1D(column.values(order));
    const auto& sorted = table.columns[0].values;
    for (Index i = 1; i < sorted.size(); ++i)
        if (sorted[i] == sorted[i - 1])
            throw FormatError(path, {}, fmt::format("wavevector {:.6g} 1/m stands in two rows", sorted[i]));
}

/// The dialect ';' with decimal comma begins with a row that is no data, even where it holds numbers.
void drop_first_row(RawTable& table) {
    for (auto& column : table.columns) column.values = Array1D(column.values.tail(column.values.size() - 1));
}

/// Gives a column the unit that the command names; one that the header states stays, and must be the same.
void give_unit(RawTable::RawColumn& column, const std::string& unit, const std::string& path) {
    if (unit.empty() || column.unit == unit) return;
    if (!column.unit.empty())
        throw InvalidArgument(fmt::format("{}: column '{}' is in {} by its header, {} was given; leave the unit out",
                                          path, column.name, column.unit, unit));
    column.unit = unit;
}

bool is_density(const RawTable::RawColumn& column) {
    return has_dimension(column.unit, dimension::power_spectrum_1d) ||
           has_dimension(column.unit, dimension::power_spectrum_2d);
}

bool is_wavevector(const RawTable::RawColumn& column) {
    return has_dimension(column.unit, dimension::wavevector) || has_dimension(column.unit, dimension::length);
}

/// Whole lines from the beginning of a file, enough for its header and some numbers.
std::string first_lines(const bytes::Source& source) {
    constexpr std::uint64_t enough = 16384;
    const auto size = std::min(source.size, enough);
    auto text = source.bytes(0, size);
    if (size < source.size) text.resize(text.rfind('\n') == std::string::npos ? 0 : text.rfind('\n') + 1);
    return text;
}

}  // namespace

SpectrumUnits SpectrumUnits::from_text(const std::string& text) {
    const auto comma = text.find(',');
    if (comma == std::string::npos || text.find(',', comma + 1) != std::string::npos)
        throw InvalidArgument(fmt::format(
            "'{}' are no two units; expected those of wavevector and density, as in \"1/um, nm3\" or \"frequency 1/um, nm3\"",
            text));
    const std::string_view all = text;
    SpectrumUnits units{"", std::string(trimmed(all.substr(0, comma))), std::string(trimmed(all.substr(comma + 1)))};
    for (const char* quantity : {"wavevector", "frequency", "wavelength"})
        if (units.wavevector.starts_with(std::string(quantity) + " ")) {
            units.quantity = quantity;
            units.wavevector = std::string(trimmed(units.wavevector.substr(units.quantity.size())));
        }
    return units;
}

bool is_power_spectrum_table(const bytes::Source& source) {
    try {
        const auto text = first_lines(source);
        if (!bytes::looks_like_text(text)) return false;
        const auto table = read_raw_table(bytes::memory_source(source.name, text));
        return table.columns.size() >= 2 && is_wavevector(table.columns[0]) && is_density(table.columns[1]);
    } catch (const Error&) {
        return false;  // no table, and what it is others say
    }
}

Table read_power_spectrum_table(const std::string& path, const SpectrumUnits& units) {
    auto raw = read_raw_table(bytes::file_source(path));
    auto& columns = raw.columns;
    if (columns.size() < 2)
        throw FormatError(path, {}, fmt::format("{} column, expected wavevector and C1D", columns.size()));
    give_unit(columns[0], units.wavevector, path);
    give_unit(columns[1], units.density, path);
    if (columns.size() > 2 && is_standard_error(columns[2].name) && columns[2].unit.empty())
        columns[2].unit = columns[1].unit;
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
    table.metadata["quantity"] = quantity_of(columns[0], units);
    table.metadata["units_of_file"] = fmt::format("{}, {}", columns[0].unit, columns[1].unit);
    table.columns.push_back(wavevectors(columns[0], table, path));
    const bool areal = has_dimension(columns[1].unit, dimension::power_spectrum_2d);
    const auto& density = areal ? dimension::power_spectrum_2d : dimension::power_spectrum_1d;
    table.columns.push_back(in_si(columns[1], areal ? "C_iso" : "C1D", density, path));
    if (columns.size() > 2 && is_standard_error(columns[2].name))
        table.columns.push_back(in_si(columns[2], "standard_error", density, path));
    sort_rows(table, path);
    if (!(table.columns[0].values > 0.0).any())
        throw FormatError(path, {}, fmt::format("no positive wavevector among {} rows", table.rows()));
    return table;
}

std::vector<Alert> alerts_of(const Table& power_spectrum, const std::string& subject) {
    std::vector<Alert> alerts;
    const auto& said = power_spectrum.metadata;
    if (const auto units = said.find("units"); units != said.end())
        alerts.push_back({"UNIT_GUESSED", subject, fmt::format("{}: units {}", said.at("file"), units->second),
                          "write them in the header as q [1/m], C1D [m3]"});
    if (const auto converted = said.find("converted"); converted != said.end())
        alerts.push_back({"SPECTRUM_CONVERTED", subject, fmt::format("{}: {}", said.at("file"), converted->second),
                          "name the column q where it holds wavevectors"});
    return alerts;
}

}  // namespace setae::tables
