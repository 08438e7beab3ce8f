// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "format_list.hpp"
#include "setae/bytes/text.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"
#include "vca_tree.hpp"

// OPDx files of Bruker's Dektak XT and Vision64: a signature, then a tree of typed entries. "1D_Data" and "2D_Data"
// contain the channels, "MetaData" states which of them are heights and which is the primary one.
namespace setae::formats {
namespace {

using namespace std::string_view_literals;
constexpr std::size_t max_channels_of_opdx = 1000;
constexpr auto opdx_signature = "VCA DATA\x01\x00\x00\x55"sv;
constexpr auto* format_name = "OPDx";

/// "Radius: 2 µm"
std::optional<double> tip_radius(const std::string& stylus) {
    constexpr std::string_view key = "Radius:";
    const auto at = stylus.find(key);
    if (at == std::string::npos) return std::nullopt;
    try {
        return parse_quantity(stylus.substr(at + key.size()), dimension::length);
    } catch (const InvalidArgument&) {
        return std::nullopt;
    }
}

std::string instrument_type(const std::string& stated, const std::string& mode) {
    if (bytes::lowered(stated).find("stylus") != std::string::npos ||
        bytes::lowered(mode).find("stylus") != std::string::npos)
        return "stylus";
    return mode == "PSI" || mode == "VSI" || mode == "VXI" || mode == "HDVSI" ? "interferometer" : "";
}

ChannelInfo common_info(const VcaItem& tree) {
    ChannelInfo info;
    info.format = "opdx";
    auto& metadata = info.metadata;
    const auto date = tree.text_at("MetaData/Date"), time = tree.text_at("MetaData/Time");
    metadata.acquisition_time = date.empty() || time.empty() ? date + time : date + " " + time;
    metadata.instrument.name = tree.text_at("MetaData/MeasurementSettings/InstrumentName");
    metadata.instrument.type = instrument_type(tree.text_at("MetaData/MeasurementSettings/InstrumentType"),
                                               tree.text_at("MetaData/MeasurementSettings/MeasMode"));
    metadata.instrument.tip_radius = tip_radius(tree.text_at("MetaData/MeasurementSettings/StylusType"));
    const std::pair<const char*, const char*> kept[] = {{"time_stamp", "TimeStamp"},
                                                        {"data_set", "DataSetName"},
                                                        {"stylus", "MeasurementSettings/StylusType"},
                                                        {"serial_number", "MeasurementSettings/InstrumentSerial"},
                                                        {"objective", "MeasurementSettings/Objective"}};
    for (const auto& [key, path] : kept)
        if (const auto text = tree.text_at(fmt::format("MetaData/{}", path)); !text.empty())
            metadata.attributes[key] = text;
    for (const auto& [key, path] : {std::pair{"stylus_force", "StylusForce"}, {"scan_duration", "ScanDuration"}})
        if (const auto* item = tree.find(fmt::format("MetaData/MeasurementSettings/{}", path));
            item && item->type == VcaType::quantity)
            metadata.attributes[key] = fmt::format("{} {}", item->number, item->text);
    return info;
}

/// Names in the order in which they are listed as heights, the primary one first.
std::vector<std::string> heights_first(const VcaItem& tree, const char* lists, const char* primary,
                                       const bytes::Source& source) {
    std::vector<std::string> names;
    if (const auto* list = tree.find(lists); list && list->type == VcaType::string_list)
        names = texts_of(*list, source, format_name);
    const auto first = tree.text_at(primary);
    if (const auto at = std::find(names.begin(), names.end(), first); at != names.end())
        std::rotate(names.begin(), at, at + 1);
    return names;
}

/// Entries with `content`, the named ones first.
std::vector<const VcaItem*> data_items(const VcaItem& tree, const char* folder, const char* content,
                                       const std::vector<std::string>& names, const bytes::Source& source) {
    std::map<std::string, std::size_t> ranks;
    for (const auto& name : names) ranks.emplace(name, ranks.size());
    std::vector<std::pair<std::size_t, const VcaItem*>> ranked;
    if (const auto* data = tree.find(folder))
        for (const auto& child : data->children)
            if (child.find(content))
                ranked.emplace_back(ranks.contains(child.name) ? ranks[child.name] : ranks.size(), &child);
    if (ranked.size() > max_channels_of_opdx)
        throw FormatError(source.name, {.offset = source.size},
                          fmt::format("OPDx: {} channels, expected {} at most; the file is damaged", ranked.size(),
                                      max_channels_of_opdx));
    std::stable_sort(ranked.begin(), ranked.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<const VcaItem*> items;
    for (const auto& [rank, item] : ranked) items.push_back(item);
    return items;
}

Match detect_opdx(std::string_view head, const bytes::Source&) {
    return head.starts_with(opdx_signature) ? Match::yes : Match::no;
}

std::vector<Channel> open_opdx(const bytes::Source& source, const ReadOptions& options) {
    bytes::Cursor cursor(source, format_name, opdx_signature.size());
    const auto tree = read_vca_tree(cursor);
    const auto common = common_info(tree);
    std::vector<Channel> channels;
    for (const auto* item :
         data_items(tree, "2D_Data", "Matrix",
                    heights_first(tree, "MetaData/2D_Channels/Height", "MetaData/PrimaryData2D", source), source))
        channels.push_back(vca_map_channel(*item, common, source, options));
    for (const auto* item :
         data_items(tree, "1D_Data", "Array",
                    heights_first(tree, "MetaData/1D_Channels/Height", "MetaData/PrimaryData1D", source), source))
        channels.push_back(vca_line_channel(*item, common, source, options));
    if (channels.empty())
        throw FormatError(source.name, {.offset = source.size}, "OPDx: no map and no profile in the file");
    return channels;
}

}  // namespace

Format opdx_format() {
    return {
        .identifier = "opdx",
        .name = "OPDx",
        .extensions = ".opdx",
        .description =
            "Bruker Dektak XT and Vision64: a tree of typed entries with profiles and maps; every channel is listed",
        .heights =
            "stored floating-point value times the channel's data scale; NaN and values of 1e38 and more are undefined",
        .orientation =
            "rows from the top, as stored; extents are from the first point to the last and are made n · pixel size",
        .not_read =
            "maps of intensity and modulation are listed without being read; explicit positions of a profile's points",
        .reference = "Gwyddion's module dektakvca, and the files themselves: they repeat positions and extents",
        .tested_on_real_files = true,
        .detect = detect_opdx,
        .open = open_opdx};
}

}  // namespace setae::formats
