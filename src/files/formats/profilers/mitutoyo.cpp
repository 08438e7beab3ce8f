// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "format_list.hpp"
#include "setae/bytes/archive.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/tables/dialect.hpp"
#include "setae/tables/workbook.hpp"
#include "text/curve_channel.hpp"

namespace setae::formats {
namespace {

constexpr std::size_t metrics_column = 0, x_column = 4, height_column = 5;  ///< A, E and F of sheet DATA

Match detect_mitutoyo(std::string_view head, const bytes::Source& source) {
    if (!bytes::is_zip(head)) return Match::no;
    try {
        const bytes::Archive archive(source);
        if (!archive.has("xl/workbook.xml")) return Match::no;
        const auto sheets = archive.head("xl/workbook.xml", bytes::detection_bytes);
        const auto named = [&](const char* name) {
            return sheets.find(fmt::format("name=\"{}\"", name)) != std::string::npos;
        };
        return named("DATA") && named("Certificate") ? Match::yes : Match::no;
    } catch (const FormatError&) {
        return Match::no;
    }
}

tables::SheetRows rows_of(const tables::Workbook& book, const char* name, const bytes::Source& source) {
    for (const auto& sheet : book.sheets())
        if (sheet.name == name) return book.rows(sheet);
    throw FormatError(source.name, {.offset = 0}, fmt::format("Mitutoyo: no sheet '{}'", name));
}

std::string cell(const tables::SheetRows& rows, std::size_t row, std::size_t column) {
    const auto line = rows.find(row);
    if (line == rows.end()) return {};
    const auto found = line->second.find(column);
    return found == line->second.end() ? std::string() : std::string(trimmed(found->second));
}

/// A result such as "Rz 18.485 µm": name, value and unit; parameters without unit have two words.
struct Metric {
    std::string name, value, unit;
};

std::vector<Metric> metrics_of(const tables::SheetRows& data) {
    std::vector<Metric> metrics;
    for (const auto& [row, cells] : data) {
        const auto text = cell(data, row, metrics_column);
        std::vector<std::string_view> words;
        tables::split_cells(text, ' ', words);
        double value = 0.0;
        if (words.size() < 2 || words.size() > 3 || !bytes::parse_cell(words[1], '.', value)) continue;
        Metric metric{std::string(words[0]), std::string(words[1]), words.size() == 3 ? std::string(words[2]) : ""};
        if (metric.name == "Rkµ") metric.name = "Rku";  // the export writes every u of its table as µ
        metrics.push_back(std::move(metric));
    }
    return metrics;
}

/// Unit after the number of a length such as "0.08mm".
std::string unit_of(const std::string& length) {
    const auto at = length.find_first_not_of("0123456789.,+- ");
    return at == std::string::npos ? "" : length.substr(at);
}

/// Positions and heights; rows without either are skipped.
HeightCurve curve_of(const tables::SheetRows& data, const bytes::Source& source) {
    std::vector<double> x, heights;
    for (const auto& [row, cells] : data) {
        const auto position = cell(data, row, x_column), height = cell(data, row, height_column);
        if (position.empty() && height.empty()) continue;
        double at = 0.0, value = 0.0;
        if (position.empty() || !bytes::parse_cell(position, '.', at) || !bytes::parse_cell(height, '.', value))
            throw FormatError(
                source.name, {.line = row + 1},
                fmt::format(
                    "Mitutoyo: sheet 'DATA' has '{:.40}' and '{:.40}' in {} and {}, expected position and height",
                    position, height, tables::cell_name(row, x_column), tables::cell_name(row, height_column)));
        x.push_back(at);
        heights.push_back(value);
    }
    const auto array = [](const std::vector<double>& values) -> Array1D {
        return Eigen::Map<const Array1D>(values.data(), static_cast<Index>(values.size()));
    };
    HeightCurve curve;
    curve.x.values = array(x);
    curve.heights.values = array(heights);
    return curve;
}

/// Entries of the certificate next to each other: name, then value.
void take_certificate(const tables::SheetRows& certificate, topography::Metadata& metadata) {
    constexpr std::size_t date_row = 1, first_row = 42, last_row = 48, value_column = 4;
    metadata.acquisition_time = cell(certificate, date_row, value_column);
    for (auto row = first_row; row <= last_row; ++row)
        for (std::size_t column = 1; column < value_column; column += 2) {
            const auto name = cell(certificate, row, column), value = cell(certificate, row, column + 1);
            if (!name.empty() && !value.empty()) metadata.attributes.insert_or_assign(name, value);
        }
}

std::vector<Channel> open_mitutoyo(const bytes::Source& source, const ReadOptions& options) {
    const tables::Workbook book(source);
    const auto data = rows_of(book, "DATA", source), certificate = rows_of(book, "Certificate", source);
    auto curve = curve_of(data, source);
    ChannelInfo info;
    info.name = "profile";
    info.format = "mitutoyo";
    info.metadata.file = source.name;
    info.metadata.instrument.name = "Mitutoyo SurfTest";
    info.metadata.instrument.type = "stylus";
    take_certificate(certificate, info.metadata);
    const auto cut_off = info.metadata.attributes.find("Cut-Off");
    if (cut_off != info.metadata.attributes.end()) curve.x.unit = unit_of(cut_off->second);
    for (const auto& metric : metrics_of(data)) {
        if (curve.heights.unit.empty() && is_length_unit(metric.unit)) curve.heights.unit = metric.unit;
        info.metadata.attributes.insert_or_assign(
            metric.name, metric.unit.empty() ? metric.value : metric.value + " " + metric.unit);
    }
    return curve_channels(std::move(info), curve, options, source);
}

}  // namespace

Format mitutoyo_format() {
    return {
        .identifier = "mitutoyo",
        .name = "Mitutoyo SurfTest",
        .extensions = ".xlsx",
        .description =
            "profiles of SurfTest roughness testers as workbooks with the sheets DATA and Certificate; the instrument's own Ra to A2 are kept as attributes",
        .heights =
            "column F in the unit of the instrument's Ra; positions in column E, in the unit of the cut-off, the first one step from the start",
        .orientation = "",
        .not_read = "bearing curves and pictures",
        .reference = "SurfaceTopography 1.27.1, IO/Mitutoyo.py; ECMA-376 part 1, 18.2 to 18.4",
        .tested_on_real_files = true,
        .detect = detect_mitutoyo,
        .open = open_mitutoyo};
}

}  // namespace setae::formats
