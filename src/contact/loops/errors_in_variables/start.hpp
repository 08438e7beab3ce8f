// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solution.hpp"

namespace setae::loops::errors_in_variables {

/// Parameters near enough to begin with where the contact radius was measured: F = E*·4a³/(3R) − √(E*W)·√(8πa³) by
/// linear least squares in force, the contact point by the mean difference.
[[nodiscard]] Parameters linear_start(const Points& points);

/// What a fit was made to, and what came out.
struct Fitted {
    Points points;  ///< means of neighbours where the noise is large
    Solution solution;
};

/// Solved for means of neighbours first, then for all samples from there. Without contact radius W >= 0.
///
/// What is left of the noise's offset behind the curvature's correction grows with the fourth power of the noise:
/// samples whose noise exceeds a tenth of the curve's smallest radius of curvature (in units of the noise) are replaced
/// by means of so many neighbours that theirs does not, 24 means at least. Samples therefore come in the order they
/// were taken.
[[nodiscard]] Fitted fit(const Points& points, const Parameters& start);

}  // namespace setae::loops::errors_in_variables
