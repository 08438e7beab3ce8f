// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "format_list.hpp"
#include "setae/bytes/hdf5_handle.hpp"
#include "setae/bytes/text.hpp"
#include "setae/core/errors.hpp"
#include "setae/tables/header.hpp"
#include "storage/hdf5_file.hpp"
#include "storage/stored_array.hpp"

// Images and films of JPK's fast microscopes: HDF5 with groups Measurement_n/Channel_m, each with a dataset whose
// rows are the pixels of a frame, line after line from the bottom, and whose columns are the frames.
namespace setae::formats {
namespace {

constexpr const char* jpk_hdf5 = "jpk-hdf5";
constexpr std::size_t max_frames = 10'000;

/// Grid of a measurement: pixels and extents [m].
struct JpkGrid {
    Index nx = 0, ny = 0;
    std::vector<double> size;
};

std::optional<Index> count_of(const Attributes& attributes, const char* name) {
    const auto number = number_of(attributes, name);
    if (!number || !(*number >= 1.0) || *number > 1e9) return std::nullopt;
    return static_cast<Index>(*number);
}

JpkGrid grid_of(const Attributes& measurement, Index pixels, const bytes::Source& source, const std::string& path) {
    const auto nx = count_of(measurement, "position-pattern.grid.ilength");
    if (!nx || pixels % *nx != 0)
        throw FormatError(
            source.name, {},
            fmt::format("JPK HDF5: {:.200} has {} pixels per frame, which do not form lines of {}; the file is damaged",
                        path, pixels, nx.value_or(0)));
    JpkGrid grid{*nx, pixels / *nx, {}};
    const auto ny = count_of(measurement, "position-pattern.grid.jlength");
    if (ny && *ny != grid.ny)
        throw FormatError(
            source.name, {},
            fmt::format("JPK HDF5: {:.200} has {} lines, expected {}; the file is damaged", path, grid.ny, *ny));
    const auto width = number_of(measurement, "position-pattern.grid.ulength"),
               height = number_of(measurement, "position-pattern.grid.vlength");
    if (width && height) grid.size = {*width, *height};
    return grid;
}

bool is_true(const Attributes& attributes, const char* name) {
    return bytes::lowered(text_of(attributes, name)) == "true" || number_of(attributes, name).value_or(0.0) != 0.0;
}

bool is_height(const std::string& name) { return bytes::lowered(name).find("height") != std::string::npos; }

/// All frames of a dataset, each a channel.
void add_frames(const StoredArray& array, const Attributes& channel, const Attributes& measurement,
                const bytes::Source& source, const ReadOptions& options, std::vector<Channel>& channels) {
    const auto name = text_of(channel, "channel.name");
    const Index frames = array.shape.size() == 2 ? array.shape[1] : 1;
    const auto grid = grid_of(measurement, array.shape[0], source, array.name);
    const auto stated = text_of(channel, "net-encoder.scaling.unit.unit");
    const auto unit = tables::try_parse_unit(stated);
    const bool height = stated.empty() ? is_height(name) : unit && unit->dimension == dimension::length;
    const double factor = stated.empty() || !unit ? 1.0 : unit->factor;
    const RawScale scale{.factor = factor * number_of(channel, "net-encoder.scaling.multiplier").value_or(1.0),
                         .offset = factor * number_of(channel, "net-encoder.scaling.offset").value_or(0.0)};
    const std::string direction = is_true(channel, "retrace") ? "retrace" : "trace";
    for (Index frame = 0; frame < frames; ++frame) {
        ChannelInfo info{
            .name = fmt::format("{} ({}){}", name, direction, frames > 1 ? fmt::format(", frame {}", frame) : ""),
            .format = jpk_hdf5};
        info.size = grid.size;
        info.unit = stated.empty() && height ? "m" : stated;
        info.orientation = "rows from the bottom, turned";
        info.metadata.instrument.type = "afm";
        if (const auto rate = number_of(measurement, "timing-settings.scanRate"))
            info.metadata.attributes["lines_a_second"] = fmt::format("{}", *rate);
        if (!height) {
            info.shape = {grid.nx, grid.ny};
            info.metadata.file = source.name;
            channels.push_back(non_height_channel(std::move(info)));
            continue;
        }
        if (stated.empty())
            info.alerts.push_back(
                {"UNIT_ASSUMED", info.name,
                 "the file states no unit of heights; metres were assumed, as in files of JPK's programs",
                 "compare the range of heights with that in JPK's software"});
        const auto value_bytes = bytes_of(array.sample), step = value_bytes * static_cast<std::uint64_t>(frames);
        const Raster raster{.offset = array.offset + value_bytes * static_cast<std::uint64_t>(frame),
                            .nx = grid.nx,
                            .ny = grid.ny,
                            .sample = array.sample,
                            .order = array.order,
                            .bottom_up = true,
                            .line_distance = step * static_cast<std::uint64_t>(grid.nx),
                            .step = step};
        channels.push_back(array_channel(std::move(info), array, raster, scale, options));
    }
}

bool starts(const std::string& name, std::string_view with) { return name.starts_with(with); }

Match detect_jpk_hdf5(std::string_view head, const bytes::Source& source) {
    if (!bytes::find_hdf5(head)) return Match::no;
    try {
        const Hdf5File file(source);
        for (const auto& measurement : file.members("/")) {
            if (!starts(measurement, "Measurement_")) continue;
            const auto members = file.members("/" + measurement);
            if (std::any_of(members.begin(), members.end(),
                            [](const std::string& name) { return starts(name, "Channel_"); }))
                return Match::yes;
        }
    } catch (const FormatError&) {
    }
    return Match::no;
}

std::vector<Channel> open_jpk_hdf5(const bytes::Source& source, const ReadOptions& options) {
    const Hdf5File file(source);
    std::vector<Channel> channels;
    for (const auto& measurement : file.members("/")) {
        if (!starts(measurement, "Measurement_")) continue;
        const auto about = file.attributes("/" + measurement);
        for (const auto& channel : file.members("/" + measurement)) {
            if (!starts(channel, "Channel_")) continue;
            const auto group = fmt::format("/{}/{}", measurement, channel);
            const auto about_channel = file.attributes(group);
            for (const auto& name : file.members(group)) {
                const auto array = file.array(group + "/" + name);
                if (!array || array->shape.empty() || array->shape.size() > 2 || array->shape[0] < 4 ||
                    array->shape.back() < 1)
                    continue;
                if (channels.size() + static_cast<std::size_t>(array->shape.size() == 2 ? array->shape[1] : 1) >
                    max_frames)
                    throw FormatError(source.name, {},
                                      fmt::format("JPK HDF5: more than {} frames; cut the film", max_frames));
                add_frames(*array, about_channel, about, source, options, channels);
            }
        }
    }
    if (channels.empty()) throw FormatError(source.name, {.offset = 0}, "JPK HDF5: no frame in its measurements");
    return channels;
}

}  // namespace

Format jpk_hdf5_format() {
    return {
        .identifier = jpk_hdf5,
        .name = "JPK HDF5",
        .extensions = ".h5-jpk .jpk-h5",
        .description = "images and films of JPK's fast microscopes: each frame of each channel is a channel",
        .heights =
            "raw times multiplier plus offset of the net encoder, in metres where no unit is stated; no point is undefined",
        .orientation = "rows stored from the bottom, turned",
        .not_read = "channels other than heights are listed, not read",
        .reference = "AFMReader's reader of h5-jpk",
        .tested_on_real_files = false,
        .carries_scale = true,
        .detect = detect_jpk_hdf5,
        .open = open_jpk_hdf5};
}

}  // namespace setae::formats
