// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>

#include "fit_support.hpp"
#include "reduced_jkr.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::experiment {
namespace {

/// The fit in reduced units: forces by F_s, radii by their largest, parameters L and p.
struct RadiusProblem {
    Array1D force;
    Array1D radius;
    Array1D weights;  ///< 1/σ, of any common scale

    [[nodiscard]] Eigen::VectorXd start() const {
        Eigen::Vector2d best(1.0, 0.0);
        double least = std::numeric_limits<double>::infinity();
        const Array1D candidates = reduced::shape_candidates();
        for (const double shape : candidates) {
            double xy = 0.0, xx = 0.0, yy = 0.0;
            for (Index i = 0; i < force.size(); ++i) {
                const double x = reduced::radius(force[i], shape).value * weights[i];
                const double y = radius[i] * weights[i];
                xy += x * y;
                xx += x * x;
                yy += y * y;
            }
            const double cost = yy - xy * xy / xx;
            if (cost < least) {
                least = cost;
                best = {xy / xx, shape};
            }
        }
        return best;
    }

    [[nodiscard]] LeastSquaresSolution solve(const Eigen::VectorXd& from) const {
        const ResidualFunction function{
            .residuals = force.size(),
            .parameters = 2,
            .evaluate = [this](const Eigen::VectorXd& at, Eigen::VectorXd& residuals, Eigen::MatrixXd* jacobian) {
                for (Index i = 0; i < force.size(); ++i) {
                    const reduced::Point point = reduced::radius(force[i], at[1]);
                    residuals[i] = (radius[i] - at[0] * point.value) * weights[i];
                    if (!jacobian) continue;
                    (*jacobian)(i, 0) = -point.value * weights[i];
                    (*jacobian)(i, 1) = -at[0] * point.by_shape * weights[i];
                }
            }};
        return minimise(function, from);
    }

    /// (da/dF)² σ_F² in the problem's units: the slope as a secant over ±σ_F, finite where a(F) is vertical.
    [[nodiscard]] Array1D force_variances(const Eigen::VectorXd& at, double force_noise) const {
        Array1D variances = Array1D::Zero(force.size());
        if (!(force_noise > 0.0)) return variances;
        for (Index i = 0; i < force.size(); ++i) {
            const double rise = reduced::radius(force[i] + force_noise, at[1]).value -
                                reduced::radius(force[i] - force_noise, at[1]).value;
            variances[i] = std::pow(0.5 * at[0] * rise, 2);
        }
        return variances;
    }
};

/// Fits again with weights from the last solution until they settle.
LeastSquaresSolution solve_with_both_errors(RadiusProblem& problem, double radius_noise, double force_noise) {
    LeastSquaresSolution solution = problem.solve(problem.start());
    constexpr int most_rounds = 50;
    int iterations = solution.iterations;
    bool settled = false;
    for (int round = 0; round < most_rounds && !settled; ++round) {
        problem.weights =
            (problem.force_variances(solution.parameters, force_noise) + radius_noise * radius_noise).rsqrt();
        const Eigen::VectorXd before = solution.parameters;
        solution = problem.solve(before);
        iterations += solution.iterations;
        settled = (solution.parameters - before).norm() <= 1e-12 * before.norm();
    }
    solution.converged = solution.converged && settled;
    solution.iterations = iterations;
    return solution;
}

}  // namespace

JkrFit fit_radius_force(const BranchData& data, const LensAndCounterBody& bodies, RadiusErrors errors) {
    require_data(data, bodies, {.contact_radius = true});
    const bool both = errors == RadiusErrors::effective_variance;
    if (both && !(data.force_noise > 0.0 && data.contact_radius_noise > 0.0))
        throw InvalidArgument("effective variance needs the noise of force and of contact radius; give them or use radius_only");
    const double force_unit = force_scale(data);
    const double length_unit = data.contact_radius.maxCoeff();
    RadiusProblem problem{.force = data.force / force_unit,
                          .radius = data.contact_radius / length_unit,
                          .weights = Array1D::Ones(data.force.size())};
    const double force_noise = data.force_noise / force_unit;
    const double radius_noise = data.contact_radius_noise / length_unit;
    const LeastSquaresSolution solution =
        both ? solve_with_both_errors(problem, radius_noise, force_noise) : problem.solve(problem.start());

    const double length = solution.parameters[0] * length_unit;
    const double shape = solution.parameters[1];
    const double modulus = reduced::contact_modulus(length, force_unit, bodies.radius);
    const double work_unit = reduced::work_of_adhesion(1.0, force_unit, bodies.radius);
    Eigen::Matrix2d transform = Eigen::Matrix2d::Zero();
    transform(0, 0) = -3.0 * modulus / solution.parameters[0];
    transform(1, 1) = 2.0 * std::abs(shape) * work_unit;

    JkrFit fit{.method = both ? "radius_force_effective_variance" : "radius_force",
               .converged = solution.converged && solution.parameters[0] > 0.0,
               .iterations = solution.iterations,
               .contact_point = {undefined, undefined},
               .residual_unit = "m"};
    fit.covariance = transform * solution.covariance * transform.transpose();
    fit.contact_modulus = {modulus, std::sqrt(fit.covariance(0, 0))};
    fit.work_of_adhesion = {reduced::work_of_adhesion(shape, force_unit, bodies.radius),
                            square_standard_error(shape, std::sqrt(solution.covariance(1, 1)), work_unit)};
    fit.residuals = solution.residuals.array() / problem.weights * length_unit;
    const Array1D variances = problem.force_variances(solution.parameters, force_noise) + radius_noise * radius_noise;
    fit.chi2_reduced = reduced_chi2(fit.residuals / length_unit, variances, 2);
    complete(fit, bodies, data.contact_radius.maxCoeff() - data.contact_radius.minCoeff());
    return fit;
}

}  // namespace setae::experiment
