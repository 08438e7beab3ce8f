// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/bytes/source.hpp"
#include "setae/imaging/micrograph.hpp"

namespace setae::imaging {

/// read_micrograph of an open file, which may lie in memory.
[[nodiscard]] Micrograph read_micrograph_file(const bytes::Source& file, const MicrographOptions& options);

}  // namespace setae::imaging
