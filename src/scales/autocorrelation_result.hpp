// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/scales/autocorrelation.hpp"

namespace setae::scales {

/// An autocorrelation of so many distances, all still to be filled in.
[[nodiscard]] FunctionOfScale empty_autocorrelation(Index distances, const topography::Metadata& metadata);

/// The limit that sampling along x and resolution set; TIP_CUTOFF where a tip would set one too.
void limit_without_tip(FunctionOfScale& function, const topography::TiledMap& map);

}  // namespace setae::scales
