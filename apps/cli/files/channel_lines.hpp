// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "setae/formats/channel.hpp"

namespace setae::cli {

/// Metadata of a channel before its heights are read, on one line without a line end: format, name, points, size,
/// unit.
[[nodiscard]] std::string channel_line(const formats::ChannelInfo& info);

/// "12 %", "0.34 %", "< 0.01 %".
[[nodiscard]] std::string percent(double share);

}  // namespace setae::cli
