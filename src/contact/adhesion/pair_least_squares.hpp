// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "floored_least_squares.hpp"
#include "setae/adhesion/pair_fit.hpp"

namespace setae::adhesion {

/// Names of the surfaces, or elastomers, that pairs have.
[[nodiscard]] std::set<std::string> groups_of(const std::vector<PairPoint>& pairs, std::string PairPoint::*label);

using PairVariance = std::function<double(const PairPoint&)>;

/// Least squares in W >= 0.
[[nodiscard]] FlooredMinimum minimise_with(const std::vector<PairPoint>& pairs, const PairVariance& variance);
/// Terms of pairs with equal weights, and their least squares.
[[nodiscard]] std::vector<FlooredTerm> terms_of(const std::vector<PairPoint>& pairs);
[[nodiscard]] FlooredMinimum least_squares(const std::vector<PairPoint>& pairs);

/// @throws InvalidArgument for fewer than two pairs, a slope <= 0 and values that are not finite.
void require_pairs(const std::vector<PairPoint>& pairs);

/// Covariance of measured − predicted of pairs: shared `inputs` of residuals, and on the diagonal each pair's own.
[[nodiscard]] Eigen::MatrixXd residual_covariance(const std::vector<PairPoint>& pairs,
                                                  const std::vector<Components>& inputs);

/// Σ (y − ⟨y⟩)².
[[nodiscard]] double squares_about_mean(const std::vector<double>& values);

}  // namespace setae::adhesion
