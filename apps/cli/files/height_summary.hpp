// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "setae/core/arrays.hpp"
#include "setae/formats/channel.hpp"

namespace setae::cli::info_command {

/// What the heights of a channel say, or why they could not be read.
struct HeightSummary {
    bool read = false;
    Index undefined_count = 0, points = 0;
    double mean = undefined, standard_deviation = undefined, least = undefined, greatest = undefined;
    std::string error;

    [[nodiscard]] double undefined_share() const {
        return read ? static_cast<double>(undefined_count) / static_cast<double>(points) : undefined;
    }
};

/// Whether a channel's heights can be read as they are: its size and unit are known.
[[nodiscard]] bool can_be_read(const formats::ChannelInfo& info);

/// Reads the heights of a channel. What keeps it from that stands in the result.
[[nodiscard]] HeightSummary summarise(const formats::Channel& channel);

}  // namespace setae::cli::info_command
