// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/bytes/source.hpp"
#include "setae/formats/channel.hpp"

namespace setae::formats {

/// The heights of one Olympus OIR file; a POIR archive holds several.
/// @throws FormatError for content that violates the format.
[[nodiscard]] std::vector<Channel> open_oir(const bytes::Source& source, const ReadOptions& options);

}  // namespace setae::formats
