// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "setae/core/arrays.hpp"

namespace setae::loops {

/// The two parts of F = E*·hertz − √(E*W)·adhesion, linear in E* and √(E*W).
struct ForceTerms {
    Array1D hertz;     ///< 4a³/(3R) [m²]
    Array1D adhesion;  ///< √(8πa³) [m^1.5]
};
[[nodiscard]] ForceTerms force_terms(const Array1D& contact_radius, double radius);

/// W from E* and c = √(E*W), W = c|c|/E*, with the covariance of E*, W and what else was fitted.
struct WorkFromRoot {
    double work_of_adhesion = 0.0;
    double standard_error = 0.0;
    Eigen::MatrixXd covariance;
};
/// covariance: of E*, c and any others.
[[nodiscard]] WorkFromRoot work_from_root(const Eigen::Vector2d& modulus_and_root, const Eigen::MatrixXd& covariance);

}  // namespace setae::loops
