// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/core/quantity.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::topography {

/// What cleaning did to a traced contour.
struct CleanedContour {
    Profile profile;               ///< strictly increasing x
    Index dropped_points = 0;      ///< points whose x is not larger than their predecessor's, within one pixel
    Index reentrant_points = 0;    ///< points cut with re-entrant stretches
    double reentrant_share = 0.0;  ///< share of the contour's arc length cut with re-entrant stretches, 0 … 1
    std::vector<Alert> alerts;     ///< REENTRANT with the share, where anything was cut
};

/// The points of a curve whose position and height are defined, from left to right.
[[nodiscard]] Profile defined_points(Profile contour);

/// Makes a traced contour a function h(x).
///
/// Points with undefined x or h are dropped. A point whose x is not larger than the largest x before it lies on a
/// re-entrant stretch: the stretch runs until x passes that largest value again, and is cut. Stretches that step back
/// by no more than `tolerance` [m] (digitising noise) count as dropped points, deeper ones as re-entrant. A contour
/// traced from right to left is reversed first. Standard errors stay with their points, the response stays.
/// @throws UndefinedDataError where fewer than two points remain.
/// Source: [D19] SI, "drop a point whose x is not larger than its predecessor's; cut re-entrant stretches".
[[nodiscard]] CleanedContour clean_contour(Profile contour, double tolerance = 0.0);

}  // namespace setae::topography
