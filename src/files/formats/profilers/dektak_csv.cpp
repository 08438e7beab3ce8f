// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <string_view>
#include <utility>

#include "format_list.hpp"
#include "setae/bytes/text.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "text/curve_channel.hpp"

namespace setae::formats {
namespace {

constexpr std::string_view stylus = "Stylus,Radius:";

Match detect_dektak(std::string_view head, const bytes::Source&) {
    if (!head.starts_with("Scan Parameters")) return Match::no;
    return head.find("\nScan Data") != std::string_view::npos || head.size() == bytes::detection_bytes ? Match::yes
                                                                                                       : Match::maybe;
}

/// "Ra,468.0 um,0.0 um,733.0 um,0.0 um,0.00525 um" among the results: the last cell is the value.
std::string value_of(std::string_view line, std::size_t comma, bool among_results) {
    return std::string(trimmed(line.substr((among_results ? line.rfind(',') : comma) + 1)));
}

topography::Metadata metadata_of(const std::vector<std::string>& header, const bytes::Source& source) {
    topography::Metadata metadata;
    metadata.file = source.name;
    bool among_results = false;
    for (const auto& text : header) {
        const std::string_view line(text);
        if (line.starts_with("Scan Data")) break;
        among_results = among_results || line.starts_with("Analytical Results");
        const auto comma = line.find(',');
        if (comma == std::string_view::npos || line.starts_with("Function,")) continue;
        const auto value = value_of(line, comma, among_results);
        if (line.starts_with(stylus)) metadata.instrument.tip_radius = try_length(line.substr(stylus.size()));
        if (!value.empty()) metadata.attributes.insert_or_assign(std::string(trimmed(line.substr(0, comma))), value);
    }
    metadata.instrument.type = "stylus";
    return metadata;
}

std::vector<Channel> open_dektak(const bytes::Source& source, const ReadOptions& options) {
    const auto table = tables::read_raw_table(source);
    if (table.columns.size() < 2)
        throw FormatError(source.name, {.line = table.header.size() + 1},
                          "Dektak: one column below 'Scan Data', expected positions and heights");
    const auto metadata = metadata_of(table.header, source);
    std::vector<Channel> channels;
    for (std::size_t k = 1; k < table.columns.size(); ++k) {
        if (table.columns[k].values.isNaN().all() && !channels.empty()) continue;  // the part after the last comma
        ChannelInfo info;
        info.name = table.columns[k].name;
        info.format = "dektak-csv";
        info.metadata = metadata;
        for (auto& channel : curve_channels(std::move(info), {table.columns[0], table.columns[k]}, options, source))
            channels.push_back(std::move(channel));
    }
    return channels;
}

}  // namespace

Format dektak_csv_format() {
    return {
        .identifier = "dektak-csv",
        .name = "Dektak CSV",
        .extensions = ".csv",
        .description =
            "profiles of Bruker and Veeco Dektak styluses as text: parameters of the scan, results and the data in columns with their units",
        .heights = "values in the unit of their column; empty cells are undefined",
        .orientation = "",
        .reference = "SurfaceTopography 1.27.1, IO/XYZ.py",
        .tested_on_real_files = true,
        .read_elsewhere = false,
        .detect = detect_dektak,
        .open = open_dektak};
}

}  // namespace setae::formats
