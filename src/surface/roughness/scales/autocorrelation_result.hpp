// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/scales/autocorrelation.hpp"

namespace setae::scales {

/// An autocorrelation of so many distances, without values.
[[nodiscard]] FunctionOfScale empty_autocorrelation(Index distances, const topography::Metadata& metadata);

}  // namespace setae::scales
