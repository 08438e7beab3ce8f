// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "setae/bytes/text.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/number_text.hpp"
#include "setae/core/text.hpp"
#include "setae/core/units.hpp"
#include "setae/tables/dialect.hpp"
#include "setae/tables/force_curve_formats.hpp"
#include "setae/tables/header.hpp"

// Force curves exported by JPK data processing as text: for each segment lines "# key: value", among them "segment",
// "columns" and "units", then rows of numbers in SI between blanks. Several curves follow one another with another
// "index".
namespace setae::tables {
namespace {

using JpkEntries = std::map<std::string, std::string>;

/// Place of the rows of a segment, and its metadata.
struct TextSegment {
    JpkEntries entries;
    std::size_t first_line = 0, lines = 0;  ///< of the text
};

/// A text with its lines; both exist as long as any of its curves.
struct JpkText {
    std::string name, text;
    std::vector<std::string_view> lines;
    std::map<long, std::vector<TextSegment>> curves;
};

std::string entry_of(const JpkEntries& entries, const std::string& key) {
    const auto found = entries.find(key);
    return found == entries.end() ? std::string() : found->second;
}

std::vector<std::string> words_of_line(std::string_view line) {
    std::vector<std::string_view> cells;
    split_cells(line, ' ', cells);
    return {cells.begin(), cells.end()};
}

/// The number of the curve of a segment: its index, which is −1 if the file contains one curve.
long number_of(const TextSegment& segment) {
    return std::max(0L, spelled<long>(entry_of(segment.entries, "index")).value_or(0));
}

std::shared_ptr<const JpkText> parsed_text(const bytes::Source& source) {
    auto parsed = std::make_shared<JpkText>();
    parsed->name = source.name;
    parsed->text = bytes::decoded(source.all(), bytes::Encoding::detect);
    parsed->lines = bytes::split_lines(parsed->text);
    TextSegment segment;
    const auto finish = [&] {
        if (segment.lines > 0) parsed->curves[number_of(segment)].push_back(std::move(segment));
        segment = {};
    };
    for (std::size_t i = 0; i < parsed->lines.size(); ++i) {
        const auto line = trimmed(parsed->lines[i]);
        if (line.empty()) continue;
        if (!line.starts_with('#')) {
            if (segment.lines == 0) segment.first_line = i;
            segment.lines = i + 1 - segment.first_line;
            continue;
        }
        if (segment.lines > 0) finish();
        const auto text = trimmed(line.substr(1));
        const auto colon = text.find(": ");
        if (colon != std::string_view::npos)
            segment.entries.insert_or_assign(std::string(text.substr(0, colon)),
                                             std::string(trimmed(text.substr(colon + 2))));
    }
    finish();
    return parsed;
}

[[noreturn]] void refuse(const JpkText& text, const TextSegment& segment, const std::string& what) {
    throw FormatError(text.name, {.line = segment.first_line + 1}, "JPK text: " + what);
}

/// A column of a segment, and its unit.
struct TextColumn {
    std::size_t index = 0;
    std::string name;
    Unit unit;
};

std::optional<TextColumn> column_named(const TextSegment& segment, std::initializer_list<const char*> names) {
    const auto columns = words_of_line(entry_of(segment.entries, "columns")),
               units = words_of_line(entry_of(segment.entries, "units"));
    for (const char* name : names)
        for (std::size_t k = 0; k < columns.size(); ++k)
            if (columns[k] == name)
                if (const auto unit = try_parse_unit(k < units.size() ? units[k] : ""))
                    return TextColumn{k, name, *unit};
    return std::nullopt;
}

TextColumn required_column(const JpkText& text, const TextSegment& segment, const char* what,
                           std::initializer_list<const char*> names) {
    if (const auto column = column_named(segment, names)) return *column;
    refuse(text, segment,
           fmt::format("no column of {} with a unit; the segment has '{}' in '{}'; export it with the data processing "
                       "of JPK",
                       what, entry_of(segment.entries, "columns"), entry_of(segment.entries, "units")));
}

/// Columns of the rows of a segment in SI, in the requested order.
std::vector<Array1D> columns_of(const JpkText& text, const TextSegment& segment,
                                const std::vector<TextColumn>& wanted) {
    std::vector<std::vector<double>> values(wanted.size());
    std::vector<std::string_view> cells;
    for (std::size_t i = segment.first_line; i < segment.first_line + segment.lines; ++i) {
        const auto line = trimmed(text.lines[i]);
        if (line.empty()) continue;
        split_cells(line, ' ', cells);
        for (std::size_t k = 0; k < wanted.size(); ++k) {
            double value = 0.0;
            if (wanted[k].index >= cells.size() || !parse_cell(cells[wanted[k].index], '.', value))
                throw FormatError(
                    text.name, {.line = i + 1},
                    fmt::format("JPK text: no number for column '{}' in {} cells; the file may be truncated here",
                                wanted[k].name, cells.size()));
            values[k].push_back(value * wanted[k].unit.factor);
        }
    }
    std::vector<Array1D> columns;
    for (const auto& column : values)
        columns.emplace_back(Eigen::Map<const Array1D>(column.data(), static_cast<Index>(column.size())));
    return columns;
}

Reading reading_of(const JpkText& text, const TextSegment& segment, const TextColumn& column) {
    if (column.unit.dimension == dimension::force) return Reading::force;
    if (column.unit.dimension == dimension::length) return Reading::deflection;
    if (column.unit.dimension == parse_unit("V").dimension) return Reading::volts;
    refuse(text, segment,
           fmt::format("column '{}' is in '{}', expected N, m or V", column.name, entry_of(segment.entries, "units")));
}

std::optional<double> positive_entry(const TextSegment& segment, const std::string& key) {
    const auto value = spelled<double>(entry_of(segment.entries, key));
    return value && *value > 0.0 && std::isfinite(*value) ? value : std::nullopt;
}

ForceCurveData curve_of(const JpkText& text, long number) {
    ForceCurveData data;
    data.travel_sign = -1.0;
    bool first = true;
    for (const auto& segment : text.curves.at(number)) {
        const auto height = required_column(
                       text, segment, "height",
                       {"measuredHeight", "capacitiveSensorHeight", "strainGaugeHeight", "smoothedMeasuredHeight",
                        "smoothedCapacitiveSensorHeight", "smoothedStrainGaugeHeight", "height"}),
                   deflection = required_column(text, segment, "deflection", {"vDeflection"});
        const auto kind = reading_of(text, segment, deflection);
        if (!first && kind != data.reading) refuse(text, segment, "the deflection of the segments has different units");
        data.reading = kind;
        std::vector<TextColumn> wanted{height, deflection};
        const auto time = column_named(segment, {"time", "seriesTime"});
        if (time) wanted.push_back(*time);
        auto columns = columns_of(text, segment, wanted);
        const auto count = columns[0].size();
        const double duration = time && count > 1 ? (columns[2][count - 1] - columns[2][0]) *
                                                        static_cast<double>(count) / static_cast<double>(count - 1)
                                                  : 0.0;
        if (first) {
            data.metadata["height_channel"] = height.name;
            for (const auto& [key, name] : {std::pair{"date", "date"}, {"data-description.instrument", "instrument"}})
                if (auto value = entry_of(segment.entries, key); !value.empty()) data.metadata.emplace(name, value);
            data.constants = {positive_entry(segment, "springConstant"), positive_entry(segment, "sensitivity")};
            data.x = spelled<double>(entry_of(segment.entries, "xPosition")).value_or(undefined);
            data.y = spelled<double>(entry_of(segment.entries, "yPosition")).value_or(undefined);
        }
        const auto style = entry_of(segment.entries, "segment");
        data.segments.push_back(
            {style.empty() ? "pause" : style, std::move(columns[0]), std::move(columns[1]), duration});
        first = false;
    }
    return data;
}

}  // namespace

bool is_jpk_text(const bytes::Source& source) {
    const auto head = source.head(bytes::detection_bytes);
    if (!head.starts_with('#') || !bytes::looks_like_text(head)) return false;
    return head.find("# columns: ") != std::string::npos && head.find("# fancyNames: ") != std::string::npos &&
           head.find("# segment: ") != std::string::npos;
}

ForceCurveFile open_jpk_text(const bytes::Source& source) {
    const auto text = parsed_text(source);
    if (text->curves.empty())
        throw FormatError(source.name, {.line = text->lines.size()}, "JPK text: no row of numbers below its header");
    ForceCurveFile file;
    for (const auto& [number, segments] : text->curves) file.numbers.push_back(number);
    file.read = [text](long number) { return curve_of(*text, number); };
    return file;
}

}  // namespace setae::tables
