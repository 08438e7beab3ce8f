// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "plane_curve.hpp"
#include "two_phases.hpp"

namespace setae::imaging {

/// Borders of a mask along the sides of its pixels, corners only: open ones from side to side of the picture, closed
/// ones around parts and holes; longest first, then from top to bottom. Where two pixels of the sample touch at a
/// corner alone they are apart.
[[nodiscard]] std::vector<PlaneCurve> outlines(const PixelMask& sample);

}  // namespace setae::imaging
