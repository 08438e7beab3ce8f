// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/bytes/source.hpp"
#include "setae/imaging/micrograph.hpp"

namespace setae::imaging {

/// Reads a PNG, JPEG or BMP. The pixel size is that of the pHYs chunk of a PNG if it is finer than print.
/// @throws as read_micrograph.
[[nodiscard]] Micrograph read_plain_picture(const bytes::Source& file, const MicrographOptions& options);

}  // namespace setae::imaging
