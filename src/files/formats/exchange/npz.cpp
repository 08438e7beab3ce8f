// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "format_list.hpp"
#include "npy_array.hpp"
#include "setae/bytes/archive.hpp"
#include "setae/core/errors.hpp"
#include "storage/height_likeness.hpp"

// NumPy's savez: a ZIP of NPY files, stored or compressed.
namespace setae::formats {
namespace {

constexpr std::string_view ending = ".npy";

Match detect_npz(std::string_view head, const bytes::Source& source) {
    if (!bytes::is_zip(head)) return Match::no;
    try {
        const auto names = bytes::Archive(source).names();
        const bool arrays = !names.empty() && std::all_of(names.begin(), names.end(), [](const std::string& name) {
            return name.ends_with(ending);
        });
        return arrays ? Match::yes : Match::no;
    } catch (const FormatError&) {
        return Match::no;
    }
}

Channel channel_of(const StoredArray& array, bool only_array, const ReadOptions& options) {
    ChannelInfo info{.name = array.name, .format = "npz"};
    if (!array.refusal.empty()) {
        info.shape = array.shape;
        info.metadata.file = array.data.name;
        return non_height_channel(std::move(info), array.refusal);
    }
    auto channel = array_channel(std::move(info), array, FirstIndex::x_to_the_right, {}, options_for(array, options));
    const bool integers = array.sample != Sample::float32 && array.sample != Sample::float64;
    const auto why =
        reason_against_heights({.array = array, .name = array.name, .integers = integers, .only_array = only_array});
    return why.empty() ? channel : doubtful_channel(std::move(channel), why);
}

std::vector<Channel> open_npz(const bytes::Source& source, const ReadOptions& options) {
    const bytes::Archive archive(source);
    std::vector<StoredArray> arrays;
    for (const auto& name : archive.names()) {
        const auto member = archive.member(name);
        if (!is_npy(member.head(ending.size() + 2)))
            throw FormatError(member.name, {.offset = 0}, "NPZ: a member is not an NPY file; the archive is damaged");
        auto array = npy_array(member);
        if (!is_map_or_line(array)) continue;
        array.name = name.substr(0, name.size() - ending.size());
        arrays.push_back(std::move(array));
    }
    std::vector<Channel> channels;
    const auto readable =
        std::count_if(arrays.begin(), arrays.end(), [](const StoredArray& array) { return array.refusal.empty(); });
    for (const auto& array : arrays) channels.push_back(channel_of(array, readable == 1, options));
    if (channels.empty())
        throw FormatError(source.name, {.offset = 0},
                          "NPZ: no array of numbers with one or two dimensions and more than one value");
    return channels;
}

}  // namespace

Format npz_format() {
    return {
        .identifier = "npz",
        .name = "NumPy arrays",
        .extensions = ".npz",
        .description =
            "what savez and savez_compressed write: each array of numbers with one or two dimensions is a channel; size and unit must be given. Those that do not look like heights are listed with the reason and read only when chosen",
        .heights = "values in the unit given; NaN and infinities are undefined",
        .orientation = "first index x, second y downwards",
        .not_read =
            "single numbers and arrays of more dimensions are passed over; records, objects, texts and complex numbers are listed",
        .reference = "numpy.savez; NumPy Enhancement Proposal 1",
        .tested_on_real_files = false,
        .carries_scale = false,
        .read_elsewhere = false,
        .detect = detect_npz,
        .open = open_npz};
}

}  // namespace setae::formats
