// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace setae::adhesion {

/// x >= 0 that minimises ½ xᵀNx − bᵀx; N symmetric and positive definite.
/// Source: Lawson, Hanson, Solving Least Squares Problems (1974), ch. 23.
[[nodiscard]] Eigen::VectorXd nonnegative_minimum(const Eigen::MatrixXd& N, const Eigen::VectorXd& b);

}  // namespace setae::adhesion
