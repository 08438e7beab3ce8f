// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "channel_building.hpp"
#include "format_list.hpp"
#include "setae/bytes/json_text.hpp"
#include "setae/bytes/text.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/core/units.hpp"
#include "setae/tables/header.hpp"
#include "setae/tables/text_numbers.hpp"
#include "text/curve_channel.hpp"
#include "text/text_start.hpp"

namespace setae::formats {
namespace {

using nlohmann::json;

/// The description "name.txt" next to a file of numbers "name.dat"; empty if it is no description of dabam.
std::optional<json> description_of(const bytes::Source& source) {
    constexpr std::uintmax_t most = 1 << 20;
    if (source.path.empty()) return std::nullopt;
    auto path = std::filesystem::path(source.path);
    if (bytes::lowered(path.extension().string()) != ".dat") return std::nullopt;
    path.replace_extension(".txt");
    std::error_code error;
    const auto size = std::filesystem::file_size(path, error);
    if (error || size > most) return std::nullopt;
    auto description = bytes::json_or_null(bytes::read_file(path.string()));
    if (!description.is_object() || !description.contains("FILE_FORMAT") || !description.contains("X1_FACTOR"))
        return std::nullopt;
    return description;
}

std::optional<double> number_of(const json& description, const std::string& key) {
    const auto found = description.find(key);
    return found != description.end() && found->is_number() ? std::optional(found->get<double>()) : std::nullopt;
}

std::string text_of(const json& description, const std::string& key) {
    const auto found = description.find(key);
    if (found == description.end() || found->is_null()) return {};
    return found->is_string() ? found->get<std::string>() : found->dump();
}

/// Whether a text is such a description.
bool describes(std::string_view head) {
    return head.find("\"FILE_FORMAT\"") != std::string_view::npos &&
           head.find("\"X1_FACTOR\"") != std::string_view::npos;
}

enum class Quantity { heights, slopes, unknown };

/// From a name such as "Measured heigth (nm)" or "slope error (urad)".
Quantity quantity_of(const std::string& name) {
    const auto word = bytes::lowered(name);
    if (word.find("slope") != std::string::npos) return Quantity::slopes;
    return word.find("heig") != std::string::npos ? Quantity::heights : Quantity::unknown;
}

/// A column in addition to the positions.
struct Ordinate {
    std::size_t column = 1;
    std::string name;
    double factor = 1.0;  ///< to metres or radians
    Quantity quantity = Quantity::unknown;
};

struct DabamColumns {
    double x_factor = 1.0;
    std::vector<Ordinate> ordinates;
    topography::Metadata metadata;
};

/// Columns of a header row at tabs or, if there are none, at two blanks or more.
std::vector<std::string> names_of(std::string_view line) {
    std::vector<std::string> names;
    const bool tabs = line.find('\t') != std::string_view::npos;
    while (!line.empty()) {
        const auto end = line.find(tabs ? "\t" : "  ");
        if (const auto name = trimmed(line.substr(0, end)); !name.empty()) names.emplace_back(name);
        line.remove_prefix(end == std::string_view::npos ? line.size() : end + (tabs ? 1 : 2));
    }
    return names;
}

std::vector<std::string> header_names(const tables::TextStart& start) {
    if (start.header.empty()) return {};
    auto names = names_of(start.header.back());
    if (names.size() != start.layout.columns) names.clear();
    return names;
}

std::string without_unit(const std::string& name) {
    return std::string(trimmed(std::string_view(name).substr(0, name.find('('))));
}

/// Whether a header has the names of positions and heights or slopes of a mirror, with their units.
bool names_mirror(const std::vector<std::string>& names) {
    if (names.size() < 2 || !bytes::lowered(names[0]).starts_with('x') ||
        !is_length_unit(tables::parse_header_cell(names[0]).unit))
        return false;
    return std::any_of(names.begin() + 1, names.end(),
                       [](const auto& name) { return quantity_of(name) == Quantity::slopes; });
}

/// Factor to SI of a column's unit; micro-radians are spelled "urad", "microrad", "micror-rad".
std::optional<double> factor_of(const std::string& name, Quantity quantity) {
    auto unit = name.substr(std::min(name.find('(') + 1, name.size()));
    unit.resize(std::min(unit.find(')'), unit.size()));
    if (quantity == Quantity::slopes && bytes::lowered(unit).starts_with("micro")) return 1e-6;
    if (quantity == Quantity::slopes && unit.ends_with("rad"))
        unit.replace(unit.size() - 3, 3, "m");  // the prefix is that of a length
    const auto known = tables::try_parse_unit(unit);
    return known && known->dimension == dimension::length ? std::optional(known->factor) : std::nullopt;
}

DabamColumns columns_of(const json& description, const tables::TextStart& start, const bytes::Source& source) {
    DabamColumns columns;
    const auto x_factor = number_of(description, "X1_FACTOR");
    if (!x_factor || !(*x_factor > 0.0))
        throw FormatError(source.name, {.line = 1},
                          "dabam: the description that belongs to the file has no X1_FACTOR above 0");
    columns.x_factor = *x_factor;
    const auto names = header_names(start);
    const bool slopes_first = number_of(description, "FILE_FORMAT") == 1.0;
    for (std::size_t k = 1; k < start.layout.columns; ++k) {
        const auto factor = number_of(description, fmt::format("Y{}_FACTOR", k));
        if (!factor || *factor == 0.0) continue;
        Ordinate ordinate{k, names.empty() ? text_of(description, fmt::format("PLOT_TITLE_Y{}", k)) : names[k], *factor,
                          Quantity::unknown};
        ordinate.quantity = k == 1 ? (slopes_first ? Quantity::slopes : Quantity::heights) : quantity_of(ordinate.name);
        ordinate.name = without_unit(ordinate.name);
        columns.ordinates.push_back(std::move(ordinate));
    }
    auto& metadata = columns.metadata;
    metadata.acquisition_time = text_of(description, "SCAN_DATE");
    metadata.instrument.name = text_of(description, "INSTRUMENT");
    for (const auto* key : {"FACILITY", "SURFACE_SHAPE", "FUNCTION", "SUBSTRATE", "COATING", "POLISHING",
                            "LENGTH_OPTICAL", "YEAR_FABRICATION", "CALC_HEIGHT_RMS", "CALC_HEIGHT_RMS_FACTOR",
                            "CALC_SLOPE_RMS", "CALC_SLOPE_RMS_FACTOR", "USER_REFERENCE", "USER_ADDED_BY"})
        if (auto text = text_of(description, key); !text.empty()) metadata.attributes.emplace(key, std::move(text));
    return columns;
}

/// Columns of a single file of numbers, from its header.
DabamColumns columns_of(const tables::TextStart& start) {
    DabamColumns columns;
    const auto names = header_names(start);
    columns.x_factor = unit_factor(tables::parse_header_cell(names[0]).unit, dimension::length);
    for (std::size_t k = 1; k < names.size(); ++k) {
        const auto quantity = quantity_of(names[k]);
        if (const auto factor = factor_of(names[k], quantity))
            columns.ordinates.push_back({k, without_unit(names[k]), *factor, quantity});
    }
    return columns;
}

/// Unit of heights or slopes with a given factor.
std::string unit_name(double factor, bool slopes) {
    static constexpr std::pair<double, const char*> prefixes[] = {{1.0, ""}, {1e-3, "m"}, {1e-6, "µ"}, {1e-9, "n"}};
    for (const auto& [value, prefix] : prefixes)
        if (std::abs(factor / value - 1.0) < 1e-9) return fmt::format("{}{}", prefix, slopes ? "rad" : "m");
    return slopes ? "rad" : "m";
}

/// h_0 = 0, h_i = h_(i−1) + (s_(i−1) + s_i)/2 (x_i − x_(i−1)).
Array1D integrated(const Array1D& x, const Array1D& slopes) {
    Array1D heights = Array1D::Zero(x.size());
    for (Index i = 1; i < x.size(); ++i)
        heights[i] = heights[i - 1] + 0.5 * (slopes[i - 1] + slopes[i]) * (x[i] - x[i - 1]);
    return heights;
}

Channel slopes_channel(ChannelInfo info, const Ordinate& ordinate, Index points) {
    info.unit = unit_name(ordinate.factor, true);
    info.shape = {points};
    return non_height_channel(std::move(info));
}

std::vector<Channel> open_dabam(const bytes::Source& source, const ReadOptions& options) {
    if (describes(source.head(bytes::detection_bytes)))
        throw FormatError(source.name, {.line = 1},
                          "dabam: this is the JSON that describes a profile; open the file with its numbers, which has "
                          "the same name and the ending .dat");
    const auto start = find_start(source);
    if (!start || start->layout.columns < 2)
        throw FormatError(source.name, {.line = 1}, "dabam: no rows of positions and heights or slopes");
    const auto description = description_of(source);
    const auto columns = description ? columns_of(*description, *start, source) : columns_of(*start);
    const auto lines = tables::find_number_lines(*start, start->begin, start->source.size);
    tables::require_whole_last_line(lines);
    const auto numbers = tables::read_numbers(lines);
    HeightCurve curve;
    curve.x.unit = "m";
    curve.x.values = columns.x_factor * numbers.row(0);
    const bool any_heights = std::any_of(columns.ordinates.begin(), columns.ordinates.end(),
                                         [](const auto& ordinate) { return ordinate.quantity == Quantity::heights; });
    std::vector<Channel> channels;
    for (const auto& ordinate : columns.ordinates) {
        ChannelInfo info;
        info.name = ordinate.name.empty() ? "heights" : ordinate.name;
        info.format = "dabam";
        info.metadata = columns.metadata;
        info.metadata.file = source.name;
        const Array1D values = numbers.row(static_cast<Index>(ordinate.column));
        const bool to_integrate =
            ordinate.quantity == Quantity::slopes && (description ? ordinate.column == 1 : !any_heights);
        if (ordinate.quantity == Quantity::slopes && !to_integrate) {
            channels.push_back(slopes_channel(std::move(info), ordinate, values.size()));
            continue;
        }
        curve.heights.unit = to_integrate ? "m" : unit_name(ordinate.factor, false);
        curve.heights.values = values * (ordinate.factor / unit_factor(curve.heights.unit, dimension::length));
        if (to_integrate) {
            curve.heights.values = integrated(curve.x.values, curve.heights.values);
            info.alerts.push_back(
                {"SLOPES_INTEGRATED", source.name,
                 "the file contains slopes; heights are their integral by the trapezoidal rule, starting at 0",
                 "subtract a line or the figure: mean height and mean slope are arbitrary"});
            info.name += ", integrated";
            info.metadata.attributes["heights from"] = "slopes, integrated by the trapezoidal rule";
        }
        for (auto& channel : curve_channels(std::move(info), curve, options, source))
            channels.push_back(std::move(channel));
    }
    if (channels.empty())
        throw FormatError(source.name, {.line = 1}, "dabam: no column of heights or slopes with a factor to SI");
    return channels;
}

Match detect_dabam(std::string_view head, const bytes::Source& source) {
    if (!bytes::looks_like_text(head)) return Match::no;
    if (describes(head) || description_of(source)) return Match::yes;
    const auto start = find_start(source);
    return start && names_mirror(header_names(*start)) ? Match::maybe : Match::no;
}

}  // namespace

Format dabam_format() {
    return {
        .identifier = "dabam",
        .name = "DABAM mirror profile",
        .extensions = ".dat",
        .description =
            "profiles of synchrotron mirrors from the metrology database DABAM: numbers in name.dat, their "
            "meaning and units in name.txt in the same folder, or only in the header of the numbers",
        .heights =
            "values times the factor of the description, or in the unit of the header; files of slopes are "
            "integrated by the trapezoidal rule, with a warning",
        .orientation = "",
        .not_read = "slopes given in addition to heights are listed only",
        .reference = "M. Sanchez del Rio et al., J. Synchrotron Rad. 23, 665 (2016); SR-xraylib, metrology/dabam.py",
        .tested_on_real_files = true,
        .read_elsewhere = false,
        .detect = detect_dabam,
        .open = open_dabam};
}

}  // namespace setae::formats
