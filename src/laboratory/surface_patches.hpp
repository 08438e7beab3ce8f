// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/laboratory/recipe.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::laboratory {

/// All scans of a surface, on one strip.
[[nodiscard]] std::vector<topography::LineScan> stylus_scans(const KnownSurface& surface, const StylusProtocol& protocol,
                                                             synthesis::RandomKey key);

/// Map `index` of the protocol, on a patch of its own.
[[nodiscard]] topography::HeightMap afm_scan(const KnownSurface& surface, const AfmProtocol& protocol, std::size_t index,
                                             synthesis::RandomKey key);

/// Contour `index` of the protocol, on a line of its own.
[[nodiscard]] topography::Profile tem_contour(const KnownSurface& surface, const TemProtocol& protocol, std::size_t index,
                                              synthesis::RandomKey key);

}  // namespace setae::laboratory
