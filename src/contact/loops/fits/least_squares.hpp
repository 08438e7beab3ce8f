// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <Eigen/Core>

#include "correlated_residuals.hpp"
#include "setae/core/estimate.hpp"

namespace setae::loops {

/// Residuals that make up a sum of squares, and their derivatives.
struct ResidualFunction {
    Eigen::Index residuals = 0;
    Eigen::Index parameters = 0;
    /// Fills the residuals and, where requested, their Jacobian (residuals × parameters) at the given parameters.
    std::function<void(const Eigen::VectorXd& parameters, Eigen::VectorXd& residuals, Eigen::MatrixXd* jacobian)>
        evaluate;
};

struct LeastSquaresSolution {
    Eigen::VectorXd parameters;
    Eigen::VectorXd residuals;
    FitCovariance uncertainty;
    bool converged = false;
    int iterations = 0;

    /// A value that follows from the parameters, with its standard error and these degrees of freedom.
    [[nodiscard]] Estimate estimate(double value, double standard_error) const;
};

/// Least squares by Levenberg and Marquardt's method from a start near the solution.
[[nodiscard]] LeastSquaresSolution solve_nonlinear(const ResidualFunction& function, const Eigen::VectorXd& start,
                                                   int max_iterations = 200);

/// The same for a problem linear in its parameters, `design` · parameters ≈ values.
[[nodiscard]] LeastSquaresSolution solve_linear(const Eigen::MatrixXd& design, const Eigen::VectorXd& values);

}  // namespace setae::loops
