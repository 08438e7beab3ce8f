// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "format_list.hpp"
#include "setae/bytes/hdf5_handle.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "storage/hdf5_file.hpp"
#include "storage/stored_array.hpp"

// Images of TopoStats: HDF5 with the heights [nm] as "image", those before filtering as "image_original", and the
// nanometres per pixel as "pixel_to_nm_scaling"; masks, traces, statistics and settings next to them.
namespace setae::formats {
namespace {

constexpr const char* topostats_identifier = "topostats";
constexpr const char* topostats_scaling = "/pixel_to_nm_scaling";

bool has_member(const std::vector<std::string>& members, const char* name) {
    return std::find(members.begin(), members.end(), name) != members.end();
}

Match detect_topostats(std::string_view head, const bytes::Source& source) {
    if (!bytes::find_hdf5(head)) return Match::no;
    try {
        const auto members = Hdf5File(source).members("/");
        const bool image = has_member(members, "image") || has_member(members, "image_original");
        return image && has_member(members, topostats_scaling + 1) ? Match::yes : Match::no;
    } catch (const FormatError&) {
        return Match::no;
    }
}

std::vector<Channel> open_topostats(const bytes::Source& source, const ReadOptions& options) {
    const Hdf5File file(source);
    const double pixel = file.number(topostats_scaling).value_or(0.0) * units::nm;
    std::vector<Channel> channels;
    for (const auto& name : file.members("/")) {
        const auto array = file.array("/" + name);
        if (!array || array->shape.size() != 2 || array->shape[0] < 2 || array->shape[1] < 2) continue;
        ChannelInfo info{.name = name, .format = topostats_identifier, .orientation = "rows from the top, as stored"};
        info.metadata.instrument.type = "afm";
        info.metadata.file = source.name;
        if (!name.starts_with("image")) {
            info.shape = {array->shape[1], array->shape[0]};
            channels.push_back(non_height_channel(std::move(info), "a result of TopoStats"));
            continue;
        }
        info.unit = "nm";
        if (pixel > 0.0)
            info.size = {pixel * static_cast<double>(array->shape[1]), pixel * static_cast<double>(array->shape[0])};
        channels.push_back(array_channel(std::move(info), *array, FirstIndex::y_downwards, {.factor = units::nm},
                                         options_for(*array, options)));
    }
    if (channels.empty()) throw FormatError(source.name, {.offset = 0}, "TopoStats: no image");
    return channels;
}

}  // namespace

Format topostats_format() {
    return {
        .identifier = topostats_identifier,
        .name = "TopoStats",
        .extensions = ".topostats",
        .description =
            "HDF5 files of TopoStats: the image and the image before its filters (image_original), with the size of a pixel",
        .heights = "nanometres, as TopoStats keeps them; NaN and infinities are undefined",
        .orientation = "rows from the top, as stored",
        .not_read = "masks, grains and traces are listed; statistics and settings are passed over",
        .reference = "AFMReader's reader of .topostats",
        .tested_on_real_files = false,
        .carries_scale = true,
        .read_elsewhere = false,
        .detect = detect_topostats,
        .open = open_topostats};
}

}  // namespace setae::formats
