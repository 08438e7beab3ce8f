// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/io/channel.hpp"
#include "setae/io/source.hpp"

namespace setae::io {

/// The heights of one Olympus OIR file; a POIR archive holds several.
/// @throws FormatError for content that breaks the format.
[[nodiscard]] std::vector<Channel> open_oir(const Source& source, const ReadOptions& options);

}  // namespace setae::io
