// SPDX-License-Identifier: GPL-3.0-or-later
#include "jkr_force_terms.hpp"

#include <cmath>

#include "setae/core/constants.hpp"

namespace setae::loops {

ForceTerms force_terms(const Array1D& contact_radius, double radius) {
    const Array1D cubed = contact_radius.cube();
    return {.hertz = 4.0 / 3.0 * cubed / radius, .adhesion = (8.0 * pi * cubed).sqrt()};
}

WorkFromRoot work_from_root(const Eigen::Vector2d& modulus_and_root, const Eigen::MatrixXd& covariance) {
    const double modulus = modulus_and_root[0], root = modulus_and_root[1];
    const double work = root * std::abs(root) / modulus;
    Eigen::MatrixXd slopes = Eigen::MatrixXd::Identity(covariance.rows(), covariance.cols());
    slopes(1, 0) = -work / modulus;
    slopes(1, 1) = 2.0 * std::abs(root) / modulus;
    WorkFromRoot result{.work_of_adhesion = work, .covariance = slopes * covariance * slopes.transpose()};
    // the second-order term keeps the error finite at W = 0
    const double second = covariance(1, 1) / modulus;
    result.standard_error = std::sqrt(result.covariance(1, 1) + 2.0 * second * second);
    return result;
}

}  // namespace setae::loops
