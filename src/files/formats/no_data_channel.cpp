// SPDX-License-Identifier: GPL-3.0-or-later
#include "no_data_channel.hpp"

#include <memory>
#include <mutex>
#include <utility>

#include "setae/core/units.hpp"
#include "setae/topography/no_data.hpp"

namespace setae::formats {
namespace {

/// Markers found in a map that is read by scan lines: the map is searched before the first lines are returned.
struct FoundByLines {
    topography::TiledMap map;
    topography::NoDataHints hints;
    std::once_flag once = {};
    topography::NoDataReport report = {};

    const topography::NoDataReport& found() {
        std::call_once(once, [this] { report = topography::find_no_data(map, hints); });
        return report;
    }
};

topography::NoDataHints hints_of(const Channel& channel) {
    const auto& unit = channel.info.unit;
    return {.unit = unit.empty() ? 1.0 : unit_factor(unit, dimension::length), .codes = channel.no_data_codes};
}

std::string unit_of(const ChannelInfo& info) { return info.unit.empty() ? "m" : info.unit; }

void read_lines_without_no_data(Channel& channel) {
    const auto& info = channel.info;
    const auto all = std::make_shared<FoundByLines>();
    all->map = {info.shape[0], info.shape[1], {info.size[0], info.size[1]}, false, info.metadata, channel.lines};
    all->hints = hints_of(channel);
    channel.lines = [all](Index first, Index count) {
        auto heights = all->map.lines(first, count);
        topography::undefine(heights, all->found());
        return heights;
    };
    channel.alerts_of_lines = [all, file = info.metadata.file, unit = unit_of(info)] {
        return topography::alerts_of(all->found(), file, unit);
    };
}

}  // namespace

Channel without_no_data(Channel channel) {
    if (!channel.info.is_height) return channel;
    if (channel.lines && channel.info.shape.size() == 2 && channel.info.size.size() == 2)
        read_lines_without_no_data(channel);
    channel.read = [read = std::move(channel.read), hints = hints_of(channel), unit = unit_of(channel.info)] {
        auto measurement = read();
        const auto report = topography::find_no_data(measurement, hints);
        if (report.values.empty()) return measurement;
        topography::undefine(measurement, report);
        auto& metadata = topography::metadata(measurement);
        for (auto& alert : topography::alerts_of(report, metadata.file, unit))
            metadata.alerts.push_back(std::move(alert));
        return measurement;
    };
    return channel;
}

}  // namespace setae::formats
