// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "format_list.hpp"
#include "setae/bytes/archive.hpp"
#include "setae/bytes/xml_file.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/tables/header_number.hpp"
#include "storage/raster.hpp"

// Sensofar PLUX: a ZIP archive whose index.xml has GENERAL (image size, pixel size in µm as FOV_X and FOV_Y, date),
// INFO (items of names and values) and LAYER_0, LAYER_1, …, each naming the member of its heights: float32 in µm,
// little-endian, row after row.
namespace setae::formats {
namespace {

constexpr const char* index_member = "index.xml";

[[noreturn]] void broken_plux(const bytes::Source& source, const std::string& what) {
    throw FormatError(source.name, {}, "PLUX: " + what);
}

Match detect_plux(std::string_view head, const bytes::Source& source) {
    if (!bytes::is_zip(head)) return Match::no;
    const bytes::Archive archive(source);
    if (!archive.has(index_member)) return Match::no;
    return archive.head(index_member, bytes::detection_bytes).find("IMAGE_SIZE_X") != std::string::npos ? Match::yes
                                                                                                        : Match::no;
}

Index dimension_of(const pugi::xml_node& general, const char* name, const bytes::Source& source) {
    const auto count = tables::count_in(general.child(name).child_value());
    if (!count)
        broken_plux(source, fmt::format("{} in {} is '{:.40}', expected a number of pixels", name, index_member,
                                        general.child(name).child_value()));
    return *count;
}

/// Value of the item of that name in <INFO>.
std::string item_value(const pugi::xml_node& info, std::string_view name) {
    for (const auto& item : info.children())
        if (trimmed(item.child_value("NAME")) == name) return std::string(trimmed(item.child_value("VALUE")));
    return {};
}

topography::Metadata metadata_of(const pugi::xml_node& root) {
    topography::Metadata metadata;
    metadata.acquisition_time = trimmed(root.child("GENERAL").child_value("DATE"));
    metadata.instrument.name = item_value(root.child("INFO"), "Device");
    metadata.instrument.type = "optical";
    for (const auto& [item, attribute] : {std::pair{"Objective", "objective"},
                                          {"Technique", "technique"},
                                          {"Measure type", "measurement"},
                                          {"Algorithm", "algorithm"}})
        if (auto value = item_value(root.child("INFO"), item); !value.empty())
            metadata.attributes[attribute] = std::move(value);
    if (const auto author = trimmed(root.child("GENERAL").child_value("AUTHOR")); !author.empty())
        metadata.attributes["operator"] = author;
    return metadata;
}

std::vector<Channel> open_plux(const bytes::Source& source, const ReadOptions& options) {
    const bytes::Archive archive(source);
    const auto text = archive.read(index_member);
    const auto index = archive.member(index_member);
    const auto document = bytes::parsed_xml(text, index, "PLUX");
    const auto root = document.document_element();
    const auto general = root.child("GENERAL");
    const Raster raster{.nx = dimension_of(general, "IMAGE_SIZE_X", index),
                        .ny = dimension_of(general, "IMAGE_SIZE_Y", index),
                        .sample = Sample::float32};
    const double dx = std::abs(bytes::xml_number(general.child("FOV_X"), 0.0, index, "PLUX")),
                 dy = std::abs(bytes::xml_number(general.child("FOV_Y"), dx, index, "PLUX"));
    const auto metadata = metadata_of(root);
    std::vector<Channel> channels;
    for (const auto& layer : root.children()) {
        if (!std::string_view(layer.name()).starts_with("LAYER_")) continue;
        std::string member(trimmed(layer.child_value("FILENAME_Z")));
        if (member.empty()) continue;  // a picture without heights
        if (!archive.has(member) && archive.has("./" + member)) member.insert(0, "./");
        ChannelInfo info{.name = fmt::format("layer {}", channels.size()), .format = "plux"};
        info.metadata = metadata;
        info.unit = "µm";
        if (raster.ny > 1)
            info.orientation = "rows from the top, as stored; not stated in the file, taken as Gwyddion shows it";
        if (dx > 0.0 && dy > 0.0)
            info.size = {dx * static_cast<double>(raster.nx) * units::um,
                         dy * static_cast<double>(raster.ny) * units::um};
        channels.push_back(
            raster_channel(std::move(info), archive.member(member), raster, {.factor = units::um}, options));
    }
    if (channels.empty()) broken_plux(source, fmt::format("{} names no layer of heights", index_member));
    return channels;
}

}  // namespace

Format plux_format() {
    return {
        .identifier = "plux",
        .name = "Sensofar PLUX",
        .extensions = ".plux",
        .description =
            "ZIP archives of Sensofar's optical profilers: index.xml and a member of heights a layer, a channel each",
        .heights = "float32 in µm; NaN is undefined",
        .orientation = "rows stored from the top; the file does not state it",
        .not_read = "colour pictures and stacks are passed over",
        .reference = "PLUX reader of SurfaceTopography 1.27; not tested on an instrument file",
        .carries_scale = true,
        .detect = detect_plux,
        .open = open_plux};
}

}  // namespace setae::formats
