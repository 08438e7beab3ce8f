// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/bytes/source.hpp"
#include "setae/imaging/micrograph.hpp"

namespace setae::imaging {

/// Reads an image of a TIFF: pages that are no thumbnails (marked as reduced, without the data block of Olympus
/// software, or less than half as wide as the widest page).
/// @throws as read_micrograph does.
[[nodiscard]] Micrograph read_tiff(const bytes::Source& file, const MicrographOptions& options);

}  // namespace setae::imaging
