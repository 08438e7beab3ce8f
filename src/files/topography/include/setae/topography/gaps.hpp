// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/arrays.hpp"

namespace setae::topography {

/// Undefined heights of a line, and their runs.
struct Gaps {
    Index points = 0;
    Index count = 0;
};

/// Interpolates linearly over each gap of a line. Periodic lines continue over their end; other lines are constant
/// beyond their first and last defined height.
/// @return the undefined heights; a line without a defined height is unchanged.
Gaps bridge_gaps(Eigen::Ref<Array1D> heights, bool periodic = false);

}  // namespace setae::topography
