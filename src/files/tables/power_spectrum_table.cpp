// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/tables/power_spectrum_table.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numeric>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "setae/bytes/source.hpp"
#include "setae/bytes/text.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/core/units.hpp"
#include "setae/tables/header.hpp"
#include "setae/tables/table_file.hpp"
#include "spectrum_convention.hpp"

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

std::string shown(const RawTable::RawColumn& column, const char* otherwise) {
    return column.name.empty() ? std::string(otherwise) : fmt::format("column '{}'", column.name);
}

/// The first column in SI.
Array1D abscissa_of(const RawTable::RawColumn& raw, const std::string& quantity, const std::string& path) {
    const bool length = quantity == "wavelength";
    return in_si(raw, quantity.c_str(), length ? dimension::length : dimension::wavevector, path).values;
}

/// The density in SI as in the file.
Array1D density_of(const RawTable::RawColumn& raw, const std::string& path) {
    const bool areal = is_unit_of(raw.unit, dimension::power_spectrum_2d);
    return in_si(raw, areal ? "C_iso" : "C1D", areal ? dimension::power_spectrum_2d : dimension::power_spectrum_1d,
                 path)
        .values;
}

/// h_rms of a reading over the rows with a wavevector above 0.
double rms_height_of(const SpectrumConvention& convention, const std::vector<RawTable::RawColumn>& columns,
                     const std::string& path) {
    const auto spectrum = converted(convention, abscissa_of(columns[0], convention.quantity, path));
    const Array1D density = spectrum.factor * density_of(columns[1], path);
    std::vector<Index> order;
    for (Index i = 0; i < density.size(); ++i)
        if (spectrum.wavevector[i] > 0.0 && std::isfinite(spectrum.wavevector[i])) order.push_back(i);
    std::sort(order.begin(), order.end(),
              [&](Index a, Index b) { return spectrum.wavevector[a] < spectrum.wavevector[b]; });
    return rms_height(spectrum.wavevector(order), density(order), spectrum.areal);
}

/// @throws FormatError for logarithms, which have no unit to convert.
void refuse_logarithms(const std::vector<RawTable::RawColumn>& columns, const std::string& path) {
    for (std::size_t k = 0; k < 2; ++k) {
        const auto name = folded(columns[k].name);
        if (name.starts_with("log") || name.starts_with("ln ") || name.starts_with("ln(") || name.starts_with("lg"))
            throw FormatError(
                path, {},
                fmt::format(
                    "column '{}' contains logarithms, expected the numbers themselves; convert the logarithms in "
                    "the table",
                    columns[k].name));
    }
}

/// The convention by names, header and options. @throws FormatError that lists the readings if it is ambiguous.
SpectrumConvention convention_of(const RawTable& raw, const SpectrumUnits& units, const std::string& path) {
    const auto& columns = raw.columns;
    if (columns[0].name.empty() && columns[1].name.empty() && units.empty())
        return {.quantity = is_unit_of(columns[0].unit, dimension::length) ? "wavelength" : "wavevector",
                .kind = is_unit_of(columns[1].unit, dimension::power_spectrum_2d) ? DensityKind::areal
                                                                                  : DensityKind::per_cycle};
    const auto possible = possible_conventions(raw, units);
    if (possible.size() == 1) return possible.front();
    std::vector<std::string> readings;
    for (const auto& reading : possible)
        readings.push_back(fmt::format("\"{}\": {}, {}", as_option(reading, units), normalisation(reading),
                                       format_value(rms_height_of(reading, columns, path), "m", 3)));
    throw FormatError(path, {},
                      fmt::format("the header does not state how {} against {} is normalised; give `unit` (in a study: "
                                  "power_spectrum_unit), for which h_rms is then: {}",
                                  shown(columns[1], "the density"), shown(columns[0], "the first column"),
                                  fmt::join(readings, "; ")));
}

/// Describes the conversion of the columns unless they are wavevectors and C1D or C_iso by their names.
void describe_convention(Table& table, const SpectrumConvention& convention, const RawTable& raw,
                         const std::string& path) {
    table.metadata["quantity"] = convention.quantity;
    if (convention.own()) return;
    const auto& columns = raw.columns;
    const auto first = shown(columns[0], "the first column"), second = shown(columns[1], "the density");
    const std::string quantity = convention.quantity == "frequency"    ? first + " contains frequencies, q = 2π f; "
                                 : convention.quantity == "wavelength" ? first + " contains wavelengths, q = 2π/λ; "
                                                                       : "";
    const std::string name = convention.density.empty() ? (convention.areal() ? "C_iso" : "C1D") : convention.density;
    const bool same = !convention.one_sided && convention.density.empty() && quantity.empty();
    table.metadata[same ? "assumed" : "converted"] = fmt::format(
        "{}{} is taken as {}{}, {}: h_rms is {}", quantity, second, convention.one_sided ? "one-sided " : "", name,
        normalisation(convention), format_value(rms_height_of(convention, columns, path), "m", 3));
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
            throw FormatError(path, {}, fmt::format("wavevector {:.6g} 1/m is in two rows", sorted[i]));
}

void keep_positive(Table& table) {
    std::vector<Index> kept;
    for (Index i = 0; i < table.rows(); ++i)
        if (table.columns[0].values[i] > 0.0) kept.push_back(i);
    for (auto& column : table.columns) column.values = Array1D(column.values(kept));
}

/// The dialect ';' with decimal comma begins with a row that is no data, even if it contains numbers.
void drop_first_row(RawTable& table) {
    for (auto& column : table.columns) column.values = Array1D(column.values.tail(column.values.size() - 1));
}

bool same_unit(const std::string& a, const std::string& b) {
    try {
        const auto first = parse_unit(a), second = parse_unit(b);
        return first.dimension == second.dimension && std::abs(first.factor - second.factor) <= 1e-12 * first.factor;
    } catch (const InvalidArgument&) {
        return a == b;
    }
}

/// Gives a column the unit of the command; a unit in the header is kept, and must be the same.
void give_unit(RawTable::RawColumn& column, const std::string& unit, const std::string& path) {
    if (unit.empty() || (!column.unit.empty() && same_unit(column.unit, unit))) return;
    if (!column.unit.empty())
        throw InvalidArgument(
            fmt::format("{}: column '{}' is in {} according to its header, but {} was given; leave out the unit", path,
                        column.name, column.unit, unit));
    column.unit = unit;
}

/// "m<sup>3</sup>" as Gwyddion marks it up.
std::string without_markup(const std::string& text) {
    std::string plain;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto end = text[i] == '<' ? text.find('>', i) : std::string::npos;
        if (end == std::string::npos) plain += text[i];
        else i = end;
    }
    return plain;
}

bool is_density(const RawTable::RawColumn& column) {
    return is_unit_of(column.unit, dimension::power_spectrum_1d) ||
           is_unit_of(column.unit, dimension::power_spectrum_2d);
}

bool is_wavevector(const RawTable::RawColumn& column) {
    return is_unit_of(column.unit, dimension::wavevector) || is_unit_of(column.unit, dimension::length);
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
        throw InvalidArgument(
            fmt::format("'{}' does not describe two columns; expected the kinds of wavevector and density, as in "
                        "\"1/um, nm3\", \"frequency 1/um, one-sided nm3\" or \"wavevector, W1\"",
                        text));
    const std::string_view all = text;
    SpectrumUnits units{.quantity = {},
                        .wavevector = std::string(trimmed(all.substr(0, comma))),
                        .density = std::string(trimmed(all.substr(comma + 1)))};
    const auto take = [](std::string& from, std::string& to, std::initializer_list<const char*> words) {
        for (const char* word : words)
            if (from == word || from.starts_with(std::string(word) + " ")) {
                to = word;
                from = std::string(trimmed(from.substr(to.size())));
                return;
            }
    };
    take(units.wavevector, units.quantity, {"wavevector", "frequency", "wavelength"});
    take(units.density, units.sides, {"one-sided", "two-sided"});
    if (!units.sides.empty()) units.sides = units.sides.substr(0, 3);
    take(units.density, units.kind, {"C1D", "W1", "Wr", "C_iso", "W2"});
    return units;
}

bool SpectrumUnits::empty() const {
    return quantity.empty() && wavevector.empty() && density.empty() && sides.empty() && kind.empty();
}

bool is_power_spectrum_table(const bytes::Source& source) {
    try {
        const auto text = first_lines(source);
        if (!bytes::looks_like_text(text)) return false;
        auto table = read_raw_table(bytes::memory_source(source.name, text));
        for (auto& column : table.columns) column.unit = without_markup(column.unit);
        return table.columns.size() >= 2 && is_wavevector(table.columns[0]) && is_density(table.columns[1]);
    } catch (const Error&) {
        return false;  // no table; detected elsewhere
    }
}

Table read_power_spectrum_table(const std::string& path, const SpectrumUnits& units) {
    auto raw = read_raw_table(bytes::file_source(path));
    auto& columns = raw.columns;
    for (auto& column : columns) column.unit = without_markup(column.unit);
    if (columns.size() < 2)
        throw FormatError(path, {}, fmt::format("{} column, expected wavevector and C1D", columns.size()));
    refuse_logarithms(columns, path);
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
                fmt::format("{} columns without units; write the units in the header, as 'q [1/m]', 'C1D [m3]'",
                            columns.size()));
        columns[0].unit = "1/m";
        columns[1].unit = "m3";
        table.metadata["units"] = "assumed SI";
        if (raw.separator == ';' && raw.decimal_point == ',' && raw.header.empty()) drop_first_row(raw);
    }
    const auto convention = convention_of(raw, units, path);
    describe_convention(table, convention, raw, path);
    table.metadata["units_of_file"] = fmt::format("{}, {}", columns[0].unit, columns[1].unit);
    const auto spectrum = converted(convention, abscissa_of(columns[0], convention.quantity, path));
    const char* unit = spectrum.areal ? "m4" : "m3";
    table.columns.push_back({"wavevector", "1/m", spectrum.wavevector});
    table.columns.push_back({spectrum.areal ? "C_iso" : "C1D", unit, spectrum.factor * density_of(columns[1], path)});
    if (columns.size() > 2 && is_standard_error(columns[2].name))
        table.columns.push_back({"standard_error", unit, spectrum.factor * density_of(columns[2], path)});
    if (convention.kind == DensityKind::radial) keep_positive(table);  // C_iso at q = 0 is not part of it
    sort_rows(table, path);
    if (!(table.columns[0].values > 0.0).any())
        throw FormatError(path, {}, fmt::format("no positive wavevector among {} rows", table.rows()));
    return table;
}

std::vector<Alert> alerts_of(const Table& power_spectrum, const std::string& subject) {
    std::vector<Alert> alerts;
    const auto& metadata = power_spectrum.metadata;
    if (const auto units = metadata.find("units"); units != metadata.end())
        alerts.push_back({"UNIT_GUESSED", subject,
                          fmt::format("{}: the table states no units ({})", metadata.at("file"), units->second),
                          "write the units in the header as q [1/m], C1D [m3]"});
    if (const auto converted = metadata.find("converted"); converted != metadata.end())
        alerts.push_back({"SPECTRUM_CONVERTED", subject, fmt::format("{}: {}", metadata.at("file"), converted->second),
                          "name the columns q and C1D if that is what they contain, or describe them in `unit` (in a "
                          "study: power_spectrum_unit)"});
    if (const auto assumed = metadata.find("assumed"); assumed != metadata.end())
        alerts.push_back(
            {"SPECTRUM_CONVENTION", subject, fmt::format("{}: {}", metadata.at("file"), assumed->second),
             "name the columns q and C1D, or describe them in `unit` (in a study: power_spectrum_unit), such "
             "as \"wavevector, W1\""});
    return alerts;
}

}  // namespace setae::tables
