// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "latent_fit.hpp"

namespace setae::experiment::latent {

/// Parameters near enough to begin with where the contact radius was measured: F = E*·4a³/(3R) − √(E*W)·√(8πa³) by linear
/// least squares in force, the contact point by the mean difference.
[[nodiscard]] Parameters linear_start(const Points& points);

/// Solved for means of neighbours first, then for all samples from there.
[[nodiscard]] Solution solve_from(const Points& points, const Parameters& start, const Options& options = {});

}  // namespace setae::experiment::latent
