// SPDX-License-Identifier: GPL-3.0-or-later
#include "stored_array.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "setae/core/errors.hpp"

namespace setae::formats {
namespace {

const Attribute* find(const Attributes& attributes, const std::string& name) {
    const auto found = std::find_if(attributes.begin(), attributes.end(),
                                    [&](const Attribute& attribute) { return attribute.name == name; });
    return found == attributes.end() ? nullptr : &*found;
}

/// An array that is one value wide is a line.
bool is_line(const StoredArray& array) { return array.shape.size() < 2 || array.shape[0] == 1 || array.shape[1] == 1; }

Raster raster_of(const StoredArray& array, FirstIndex first) {
    Raster raster{.offset = array.offset, .nx = array.shape[0], .ny = 1, .sample = array.sample, .order = array.order};
    if (is_line(array)) {
        const bool along_first = array.shape.size() == 1 || array.shape[1] == 1;
        raster.nx = along_first ? array.shape[0] : array.shape[1];
        raster.step = along_first ? array.first_distance : 0;
        return raster;
    }
    const bool first_is_x = first == FirstIndex::x_to_the_right;
    raster.nx = array.shape[first_is_x ? 0 : 1];
    raster.ny = array.shape[first_is_x ? 1 : 0];
    raster.columns = first_is_x != array.first_fast;
    raster.line_distance = array.first_fast ? 0 : array.first_distance;
    return raster;
}

void require_readable(const StoredArray& array) {
    if (!array.refusal.empty()) throw FormatError(array.data.name, {}, array.refusal);
}

Channel refused_channel(ChannelInfo info, const StoredArray& array) {
    info.metadata.file = array.data.name;
    info.alerts.push_back({"UNREADABLE_ARRAY", info.name, array.refusal,
                           "save the array again without compression, or as the message states"});
    return {std::move(info), [name = array.data.name, refusal = array.refusal]() -> topography::Measurement {
                throw FormatError(name, {}, refusal);
            }};
}

}  // namespace

std::string text_of(const Attributes& attributes, const std::string& name) {
    const auto* found = find(attributes, name);
    return found ? found->text : std::string{};
}

std::optional<double> number_of(const Attributes& attributes, const std::string& name) {
    const auto* found = find(attributes, name);
    return found && found->numbers.size() == 1 ? std::optional(found->numbers.front()) : std::nullopt;
}

bool is_map_or_line(const StoredArray& array) {
    const auto dimensions = array.shape.size();
    const bool single = std::all_of(array.shape.begin(), array.shape.end(), [](Index n) { return n == 1; });
    const bool empty = std::any_of(array.shape.begin(), array.shape.end(), [](Index n) { return n < 1; });
    return (dimensions == 1 || dimensions == 2) && !single && !empty;
}

ReadOptions options_for(const StoredArray& array, const ReadOptions& options) {
    auto own = options;
    if (own.size && own.size->size() != (is_line(array) ? 1u : 2u)) own.size.reset();
    return own;
}

std::string orientation_of(const StoredArray& array, FirstIndex first) {
    if (is_line(array)) return {};
    return first == FirstIndex::x_to_the_right ? "first index x, second y downwards, as stored"
                                               : "first index y downwards, second x, as stored";
}

Channel array_channel(ChannelInfo info, const StoredArray& array, FirstIndex first, const RawScale& scale,
                      const ReadOptions& options) {
    if (array.shape.empty()) return refused_channel(std::move(info), array);
    if (info.orientation.empty()) info.orientation = orientation_of(array, first);
    return array_channel(std::move(info), array, raster_of(array, first), scale, options);
}

Channel array_channel(ChannelInfo info, const StoredArray& array, const Raster& raster, const RawScale& scale,
                      const ReadOptions& options) {
    if (!array.refusal.empty()) {
        info.shape = raster.ny == 1 ? std::vector<Index>{raster.nx} : std::vector<Index>{raster.nx, raster.ny};
        return refused_channel(std::move(info), array);
    }
    auto channel = raster_channel(std::move(info), array.data, raster, scale, options);
    if (array.hold)
        read_as_a_whole(channel, [read = channel.read, hold = array.hold] {
            const auto kept = hold();
            return read();
        });
    return channel;
}

void require_array(const StoredArray& array, const std::string& format) {
    if (array.refusal.empty()) require_raster(raster_of(array, FirstIndex::x_to_the_right), array.data, format);
}

Array1D values_of(const StoredArray& array, const std::string& format) {
    require_readable(array);
    const auto kept = array.hold ? array.hold() : nullptr;
    const auto raster = raster_of(array, FirstIndex::x_to_the_right);
    require_raster(raster, array.data, format);
    const auto values = read_raster(array.data, raster, {});
    return Eigen::Map<const Array1D>(values.data(), values.size());
}

Ends ends_of(const StoredArray& array, const std::string& format) {
    require_readable(array);
    const auto kept = array.hold ? array.hold() : nullptr;
    auto raster = raster_of(array, FirstIndex::x_to_the_right);
    require_raster(raster, array.data, format);
    const auto last = raster.offset + static_cast<std::uint64_t>(raster.nx - 1) * raster.sample_distance();
    raster.nx = 1;
    const double front = read_raster(array.data, raster, {})(0, 0);
    raster.offset = last;
    return {front, read_raster(array.data, raster, {})(0, 0)};
}

}  // namespace setae::formats
