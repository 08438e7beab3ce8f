// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "setae/formats/channel.hpp"

namespace setae::study {

/// "waves down to 78.1 nm are used": lateral resolution that is assumed for a channel without a known probe, two of its
/// steps; without a length where the file does not state its size.
[[nodiscard]] std::string resolution_without_probe(const formats::ChannelInfo& info);

}  // namespace setae::study
