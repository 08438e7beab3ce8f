// SPDX-License-Identifier: GPL-3.0-or-later
#include "least_squares.hpp"

#include <ceres/ceres.h>

#include <Eigen/Core>

#include "setae/numerics/dense.hpp"

namespace setae::loops {
namespace {

class Residuals final : public ceres::CostFunction {
public:
    explicit Residuals(const ResidualFunction& function) : function_(function) {
        set_num_residuals(static_cast<int>(function.residuals));
        mutable_parameter_block_sizes()->push_back(static_cast<int>(function.parameters));
    }

    bool Evaluate(const double* const* parameters, double* residuals, double** jacobians) const override {
        const Eigen::VectorXd at = Eigen::Map<const Eigen::VectorXd>(parameters[0], function_.parameters);
        Eigen::VectorXd values(function_.residuals);
        Eigen::MatrixXd jacobian(function_.residuals, function_.parameters);
        const bool wanted = jacobians != nullptr && jacobians[0] != nullptr;
        function_.evaluate(at, values, wanted ? &jacobian : nullptr);
        if (!values.allFinite()) return false;
        Eigen::Map<Eigen::VectorXd>(residuals, values.size()) = values;
        if (wanted)
            Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
                jacobians[0], jacobian.rows(), jacobian.cols()) = jacobian;
        return true;
    }

private:
    const ResidualFunction& function_;
};

}  // namespace

Estimate LeastSquaresSolution::estimate(double value, double standard_error) const {
    return {.value = value,
            .standard_error = standard_error,
            .method = "fit covariance, correlated residuals",
            .degrees_of_freedom = uncertainty.degrees_of_freedom};
}

LeastSquaresSolution solve_nonlinear(const ResidualFunction& function, const Eigen::VectorXd& start,
                                     int max_iterations) {
    LeastSquaresSolution solution{.parameters = start};
    ceres::Problem problem;
    problem.AddResidualBlock(new Residuals(function), nullptr, solution.parameters.data());  // the problem owns it
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_QR;
    options.logging_type = ceres::SILENT;
    options.max_num_iterations = max_iterations;
    // noise-free data are to be recovered to 1e-8 and better
    options.function_tolerance = 1e-15;
    options.parameter_tolerance = 1e-14;
    options.gradient_tolerance = 1e-16;
    // the default of 5 ends, with a line on stderr, where a smaller step is sufficient
    options.max_num_consecutive_invalid_steps = 100;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    solution.converged = summary.termination_type == ceres::CONVERGENCE;
    solution.iterations = static_cast<int>(summary.iterations.size());
    solution.residuals.resize(function.residuals);
    Eigen::MatrixXd jacobian(function.residuals, function.parameters);
    function.evaluate(solution.parameters, solution.residuals, &jacobian);
    solution.uncertainty = correlated_covariance(jacobian, solution.residuals);
    return solution;
}

LeastSquaresSolution solve_linear(const Eigen::MatrixXd& design, const Eigen::VectorXd& values) {
    LeastSquaresSolution solution{.parameters = numerics::least_squares(design, values), .converged = true};
    solution.residuals = values - design * solution.parameters;
    solution.uncertainty = correlated_covariance(design, solution.residuals);
    return solution;
}

}  // namespace setae::loops
