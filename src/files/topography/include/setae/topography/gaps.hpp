// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/arrays.hpp"

namespace setae::topography {

/// Undefined heights of a line, and the runs that they make.
struct Gaps {
    Index points = 0;
    Index count = 0;
};

/// Writes straight lines from end to end of each gap of a line; periodic lines go on over their end, the others are
/// constant beyond their first and last defined height.
/// @return what was undefined; a line without a defined height stays as it is.
Gaps bridge_gaps(Eigen::Ref<Array1D> heights, bool periodic = false);

}  // namespace setae::topography
