// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include "fit_support.hpp"
#include "latent_routes.hpp"
#include "reduced_jkr.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "small_least_squares.hpp"

namespace setae::loops {
namespace {

/// Depth against force in reduced units: δ = c D(f; p) + δ0, parameters c = L²/R, p and δ0.
struct DepthProblem {
    Array1D force;
    Array1D depth;

    /// The best of many shapes, c and δ0 by linear regression.
    [[nodiscard]] Eigen::Vector3d start() const {
        const Index neighbours = neighbours_of_a_first_solution(force.size());
        const DepthProblem some{.force = block_means(force, neighbours), .depth = block_means(depth, neighbours)};
        const double mean_depth = some.depth.mean();
        Eigen::Vector3d best(1.0, 0.0, 0.0);
        double least = std::numeric_limits<double>::infinity();
        const Array1D candidates = reduced::shape_candidates();
        for (const double shape : candidates) {
            Array1D model = reduced::depths(some.force, shape).value;
            const double mean_model = model.mean();
            model -= mean_model;
            const double xx = model.square().sum();
            if (!(xx > 0.0)) continue;
            const double slope = (model * (some.depth - mean_depth)).sum() / xx;
            const double cost = (some.depth - mean_depth - slope * model).square().sum();
            if (cost < least) {
                least = cost;
                best = {slope, shape, mean_depth - slope * mean_model};
            }
        }
        return some.minimum(best).parameters_found;
    }

    [[nodiscard]] SmallMinimum<3> minimum(const Eigen::Vector3d& from) const {
        const auto evaluate = [this](const Eigen::Vector3d& at) {
            const reduced::Curve curve = reduced::depths(force, at[1]);
            const Array1D residuals = depth - at[0] * curve.value - at[2], by_shape = at[0] * curve.by_shape;
            NormalEquations<3> sums{.squares = residuals.square().sum()};
            sums.normal << curve.value.square().sum(), (curve.value * by_shape).sum(), curve.value.sum(),  //
                0.0, by_shape.square().sum(), by_shape.sum(),                                              //
                0.0, 0.0, static_cast<double>(force.size());
            sums.normal = sums.normal.selfadjointView<Eigen::Upper>();
            sums.gradient << (curve.value * residuals).sum(), (by_shape * residuals).sum(), residuals.sum();
            return sums;
        };
        return minimise_small<3>(evaluate, from, std::max(1.0, static_cast<double>(force.size() - 3)));
    }

    [[nodiscard]] LeastSquaresSolution solve() const {
        const SmallMinimum<3> found = minimum(start());
        LeastSquaresSolution solution{
            .parameters = found.parameters_found, .converged = found.converged, .iterations = found.iterations};
        const reduced::Curve curve = reduced::depths(force, solution.parameters[1]);
        solution.residuals = (depth - solution.parameters[0] * curve.value - solution.parameters[2]).matrix();
        Eigen::MatrixXd jacobian(force.size(), 3);
        jacobian << -curve.value, -solution.parameters[0] * curve.by_shape, Array1D::Constant(force.size(), -1.0);
        solution.uncertainty = correlated_covariance(jacobian, solution.residuals);
        return solution;
    }
};

/// Variance of δ − δ(F) [m²] from the noise of both channels and its covariance. At and beyond the pull-off, where δ(F)
/// is vertical, the slope is that one standard deviation of force above it.
Array1D depth_variances(const BranchData& data, const DepthProblem& problem, const Eigen::VectorXd& at,
                        double force_unit, double depth_unit) {
    Array1D variances(data.force.size());
    const double weakest = -at[1] * at[1] + data.force_noise / force_unit;
    for (Index i = 0; i < variances.size(); ++i) {
        const double force = std::max(problem.force[i], weakest);
        const double slope = at[0] * reduced::depth(force, at[1]).by_force * depth_unit / force_unit;
        variances[i] = data.displacement_noise * data.displacement_noise +
                       slope * slope * data.force_noise * data.force_noise -
                       2.0 * slope * data.force_displacement_covariance;
    }
    return variances;
}

/// Least squares in depth.
JkrFit in_depth(const BranchData& data, const LensAndCounterBody& bodies) {
    const double force_unit = force_scale(data);
    const double origin = data.displacement[0];
    const double depth_unit = data.displacement.maxCoeff() - data.displacement.minCoeff();
    if (!(depth_unit > 0.0))
        throw UndefinedDataError("the displacement does not change along the branch; a fit needs one that does");
    const DepthProblem problem{.force = data.force / force_unit, .depth = (data.displacement - origin) / depth_unit};
    const LeastSquaresSolution solution = problem.solve();
    const double scale = solution.parameters[0];

    const double length = std::sqrt(scale * depth_unit * bodies.radius);
    const double shape = solution.parameters[1];
    const double modulus = reduced::contact_modulus(length, force_unit, bodies.radius);
    require_modulus(modulus);
    const double work_unit = reduced::work_of_adhesion(1.0, force_unit, bodies.radius);
    const Eigen::Vector3d transform(-1.5 * modulus / scale, 2.0 * std::abs(shape) * work_unit, depth_unit);

    JkrFit fit{.method = "force_displacement",
               .converged = solution.converged,
               .iterations = solution.iterations,
               .residual_unit = "m"};
    fit.covariance = transform.asDiagonal() * solution.uncertainty.covariance * transform.asDiagonal();
    fit.contact_modulus = solution.estimate(modulus, std::sqrt(fit.covariance(0, 0)));
    fit.work_of_adhesion =
        solution.estimate(reduced::work_of_adhesion(shape, force_unit, bodies.radius),
                          square_standard_error(shape, std::sqrt(solution.uncertainty.covariance(1, 1)), work_unit));
    fit.contact_point =
        solution.estimate(origin + solution.parameters[2] * depth_unit, std::sqrt(fit.covariance(2, 2)));
    fit.residuals = solution.residuals.array() * depth_unit;
    fit.chi2_reduced =
        reduced_chi2(fit.residuals, depth_variances(data, problem, solution.parameters, force_unit, depth_unit), 3);
    fit.correlated_samples = solution.uncertainty.correlated_samples;
    complete(fit, bodies, depth_unit);
    return fit;
}

/// δ − δ(F) − δ0, the depth kept at its value at pull-off for forces below it.
Array1D depth_residuals(const BranchData& data, const JkrFit& fit, double radius) {
    const double modulus = fit.contact_modulus.value, work = fit.work_of_adhesion.value;
    const double force_unit = force_scale(data);
    const double shape = std::copysign(std::sqrt(1.5 * pi * radius * std::abs(work) / force_unit), work);
    const double length = std::cbrt(0.75 * radius * force_unit / modulus);
    Array1D residuals = data.displacement - fit.contact_point.value;
    for (Index i = 0; i < residuals.size(); ++i)
        residuals[i] -= length * length / radius * reduced::depth(data.force[i] / force_unit, shape).value;
    return residuals;
}

}  // namespace

// the fold at pull-off, where δ(F) is vertical, is a point of the curve like others
latent::Route latent::force_displacement_route(const BranchData& data, const LensAndCounterBody& bodies) {
    const Points all = points(data, bodies, {.displacement = true});
    BranchData means = data;
    const Index neighbours = neighbours_of_a_first_solution(data.force.size());
    means.force = block_means(data.force, neighbours);
    means.displacement = block_means(data.displacement, neighbours);
    const JkrFit first = in_depth(means, bodies);
    Route route{.fitted =
                    latent::fit(all, reduced_parameters(all, first.contact_modulus.value, first.work_of_adhesion.value,
                                                        first.contact_point.value))};
    route.fit = finished(route.fitted, across(all, projected(all, route.fitted.solution)), first.method);
    route.fit.residuals = depth_residuals(data, route.fit, bodies.radius);
    route.fit.residual_unit = first.residual_unit;
    complete(route.fit, bodies, data.displacement.maxCoeff() - data.displacement.minCoeff());
    return route;
}

JkrFit fit_force_displacement(const BranchData& data, const LensAndCounterBody& bodies, DepthErrors errors) {
    require_data(data, bodies, {.displacement = true, .fewest = 4});
    if (errors == DepthErrors::depth_only || !(data.force_noise > 0.0 && data.displacement_noise > 0.0))
        return in_depth(data, bodies);
    return latent::force_displacement_route(data, bodies).fit;
}

}  // namespace setae::loops
