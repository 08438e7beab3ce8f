// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/core/quantity.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::topography {

/// Result of cleaning a traced contour.
struct CleanedContour {
    Profile profile;               ///< strictly increasing x
    Index dropped_points = 0;      ///< points whose x does not exceed that of their predecessor, within one pixel
    Index reentrant_points = 0;    ///< points removed with re-entrant parts
    double reentrant_share = 0.0;  ///< share of the contour's arc length removed with re-entrant parts, 0 … 1
    std::vector<Alert> alerts;     ///< REENTRANT with the share, if any points were removed
};

/// The points of a curve with defined position and height, from left to right.
[[nodiscard]] Profile defined_points(Profile contour);

/// Converts a traced contour to a function h(x).
///
/// Points with undefined x or h are dropped. A point whose x does not exceed the largest x before it is on a re-entrant
/// part: this part continues until x exceeds that largest value again, and is removed. Parts that step back by at most
/// `tolerance` [m] (digitising noise) count as dropped points, deeper ones as re-entrant. A contour traced from right
/// to left is reversed first. Standard errors are kept with their points; the response is unchanged.
/// @throws UndefinedDataError if fewer than two points remain.
/// Source: [D19] SI, "drop a point whose x is not larger than its predecessor's; cut re-entrant stretches".
[[nodiscard]] CleanedContour clean_contour(Profile contour, double tolerance = 0.0);

}  // namespace setae::topography
