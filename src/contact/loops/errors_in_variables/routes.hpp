// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "start.hpp"

/// The fits in which each sample has a true contact radius, with their data.
namespace setae::loops::errors_in_variables {

struct Route {
    JkrFit fit;
    Fitted fitted;
};

/// Eq. 1 with errors in force and radius. @throws as fit_radius_force.
[[nodiscard]] Route effective_variance_route(const BranchData& data, const LensAndCounterBody& bodies);

/// δ(F) with errors in both. @throws as fit_force_displacement; InvalidArgument where the noise of either is unknown.
[[nodiscard]] Route force_displacement_route(const BranchData& data, const LensAndCounterBody& bodies);

/// @throws as fit_joint.
[[nodiscard]] Route joint_route(const BranchData& data, const LensAndCounterBody& bodies);

/// Covariance of E*, W and the contact point if the residuals were independent and of the variance given.
[[nodiscard]] Eigen::MatrixXd independent_covariance(const Fitted& fitted);

}  // namespace setae::loops::errors_in_variables
