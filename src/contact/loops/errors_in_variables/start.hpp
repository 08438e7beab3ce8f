// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solution.hpp"

namespace setae::loops::errors_in_variables {

/// Parameters near enough to begin with where the contact radius was measured: F = E*·4a³/(3R) − √(E*W)·√(8πa³) by
/// linear least squares in force, the contact point by the mean difference.
[[nodiscard]] Parameters linear_start(const Points& points);

/// Data and result of a fit.
struct Fitted {
    Points points;  ///< means of neighbours where the noise is large
    Solution solution;
};

/// Solved for means of neighbours first, then for all samples from there. Without contact radius W >= 0.
///
/// The remaining offset by noise after the correction for curvature grows with the fourth power of the noise: samples
/// whose noise exceeds a tenth of the curve's smallest radius of curvature (in units of the noise) are replaced by
/// means of as many neighbours as necessary, with at least 24 means. Samples therefore have the order of recording.
[[nodiscard]] Fitted fit(const Points& points, const Parameters& start);

}  // namespace setae::loops::errors_in_variables
