// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "floored_least_squares.hpp"
#include "setae/adhesion/pair_fit.hpp"

namespace setae::adhesion {

using PairVariance = std::function<double(const PairPoint&)>;

/// Least squares in W >= 0.
[[nodiscard]] FlooredMinimum minimise_with(const std::vector<PairPoint>& pairs, const PairVariance& variance);
/// Every pair alike.
[[nodiscard]] FlooredMinimum least_squares(const std::vector<PairPoint>& pairs);

/// @throws InvalidArgument for fewer than two pairs, a slope <= 0 and values that are not finite.
void require_pairs(const std::vector<PairPoint>& pairs);

/// Σ (y − ⟨y⟩)².
[[nodiscard]] double squares_about_mean(const std::vector<double>& values);

}  // namespace setae::adhesion
