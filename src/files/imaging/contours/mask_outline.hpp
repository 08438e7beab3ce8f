// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "plane_curve.hpp"
#include "two_phases.hpp"

namespace setae::imaging {

/// Borders of a mask along the sides of its pixels, corners only: open ones between sides of the picture, closed ones
/// around parts and holes; longest first, then from top to bottom. Two pixels of the sample that touch only at a corner
/// are separate.
[[nodiscard]] std::vector<PlaneCurve> outlines(const PixelMask& sample);

}  // namespace setae::imaging
