// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/bytes/source.hpp"
#include "setae/imaging/micrograph.hpp"

namespace setae::imaging {

/// Reads an image of a DM3 or DM4: those in ImageSourceList that are no thumbnails, in its order.
/// @throws as read_micrograph.
[[nodiscard]] Micrograph read_digital_micrograph(const bytes::Source& file, const MicrographOptions& options);

}  // namespace setae::imaging
