// SPDX-License-Identifier: GPL-3.0-or-later
#include "routes.hpp"

#include <cmath>

#include <Eigen/Core>

#include "fits/fit_support.hpp"
#include "setae/contact/jkr_curve.hpp"
#include "setae/core/constants.hpp"
#include "setae/numerics/dense.hpp"

namespace setae::loops::errors_in_variables {
namespace {

/// E* [Pa], √(E*W) and depths [m] of one reduced unit each.
Eigen::Vector3d units_of(const Points& points) {
    const double cubed = points.length * points.length * points.length;
    return {contact::jkr::modulus_of_length(points.length, points.force_unit, points.radius),
            points.force_unit / std::sqrt(8.0 * pi * cubed), points.depth_unit};
}

/// Inverse of the information without the apparent information by noise along the curve; undefined where nothing is
/// left.
Eigen::MatrixXd inverse_information(const Fitted& fitted, const Across& noise) {
    const Eigen::MatrixXd all = across_information(noise),
                          left = all - along_the_curve(fitted.points, fitted.solution).pretended;
    const Eigen::VectorXd scale = all.diagonal().cwiseSqrt().cwiseInverse();
    const auto inverse = numerics::inverse_positive_definite(scale.asDiagonal() * left * scale.asDiagonal());
    if (!scale.allFinite() || !inverse) return Eigen::MatrixXd::Constant(all.rows(), all.cols(), undefined);
    return scale.asDiagonal() * *inverse * scale.asDiagonal();
}

/// A fit's numbers in SI units: all except its residuals (of force unless stated otherwise), and the results of
/// `complete`. noise: of all samples.
JkrFit finished(const Fitted& fitted, const Across& noise, std::string method) {
    const Points& points = fitted.points;
    const Solution& solution = fitted.solution;
    JkrFit fit{.method = std::move(method),
               .converged = solution.converged,
               .iterations = solution.rounds,
               .contact_point = {undefined},
               .residual_unit = "N"};
    const Index parameters = noise.jacobians.front().cols(), samples = noise.jacobians.front().rows();
    const bool means = solution.x.size() != samples;
    const Across of_means = means ? across(points, solution) : Across();
    const Across& fitted_noise = means ? of_means : noise;
    FitCovariance found = correlated_covariance(fitted_noise.jacobians, fitted_noise.residuals);
    const Eigen::MatrixXd wider = inverse_information(fitted, fitted_noise) * across_information(fitted_noise);
    found.covariance = (wider * found.covariance * wider.transpose()).eval();
    const Eigen::VectorXd units = units_of(points).head(parameters);
    const Eigen::MatrixXd covariance = units.asDiagonal() * found.covariance * units.asDiagonal();
    const double modulus = solution.parameters[0] * units[0];
    require_modulus(modulus);
    const WorkFromRoot work = work_from_root({modulus, solution.parameters[1] * units[1]}, covariance);
    const LeastSquaresSolution uncertain{.uncertainty = found};
    fit.covariance = work.covariance;
    fit.contact_modulus = uncertain.estimate(modulus, std::sqrt(work.covariance(0, 0)));
    fit.work_of_adhesion = uncertain.estimate(work.work_of_adhesion, work.standard_error);
    if (points.channels.displacement)
        fit.contact_point = uncertain.estimate(points.origin + solution.parameters[2] * points.depth_unit,
                                               std::sqrt(work.covariance(2, 2)));
    double squares = 0.0;
    for (const auto& residuals : noise.residuals) squares += residuals.squaredNorm();
    const Index freedom = samples * static_cast<Index>(noise.residuals.size()) - parameters;
    fit.chi2_reduced = freedom > 0 ? squares / static_cast<double>(freedom) : undefined;
    fit.correlated_samples = found.correlated_samples;
    return fit;
}

Route radius_route(const BranchData& data, const LensAndCounterBody& bodies, Channels channels, std::string method) {
    const Points all = points(data, bodies, channels);
    Route route{.fitted = errors_in_variables::fit(all, linear_start(all))};
    const Across noise = across(all, projected(all, route.fitted.solution));
    route.fit = finished(route.fitted, noise, std::move(method));
    route.fit.residuals = noise.force;
    route.fit.depth_residuals = noise.depth;
    complete(route.fit, bodies, data.force.maxCoeff() - data.force.minCoeff());
    return route;
}

/// δ − δ(F) − δ0, the depth kept at its value at pull-off for forces below it.
Array1D depth_residuals(const BranchData& data, const JkrFit& fit, double radius) {
    const double modulus = fit.contact_modulus.value, work = fit.work_of_adhesion.value;
    const double force_unit = force_scale(data);
    const double shape = std::copysign(std::sqrt(1.5 * pi * radius * std::abs(work) / force_unit), work);
    const double length = std::cbrt(0.75 * radius * force_unit / modulus);
    Array1D residuals = data.displacement - fit.contact_point.value;
    for (Index i = 0; i < residuals.size(); ++i)
        residuals[i] -= length * length / radius * contact::jkr::depth_at(data.force[i] / force_unit, shape).value;
    return residuals;
}

}  // namespace

Route effective_variance_route(const BranchData& data, const LensAndCounterBody& bodies) {
    return radius_route(data, bodies, {.contact_radius = true}, "radius_force_effective_variance");
}

// the fold at pull-off, where δ(F) is vertical, is a regular point of the curve
Route force_displacement_route(const BranchData& data, const LensAndCounterBody& bodies) {
    const Points all = points(data, bodies, {.displacement = true});
    const Index neighbours = neighbours_of_a_first_solution(data.force.size());
    const BranchData means{.force = block_means(data.force, neighbours),
                           .displacement = block_means(data.displacement, neighbours)};
    const JkrFit first = fit_force_displacement(means, bodies, DepthErrors::depth_only);
    Route route{.fitted = errors_in_variables::fit(
                    all, reduced_parameters(all, first.contact_modulus.value, first.work_of_adhesion.value,
                                            first.contact_point.value))};
    route.fit = finished(route.fitted, across(all, projected(all, route.fitted.solution)), first.method);
    route.fit.residuals = depth_residuals(data, route.fit, bodies.radius);
    route.fit.residual_unit = first.residual_unit;
    complete(route.fit, bodies, data.displacement.maxCoeff() - data.displacement.minCoeff());
    return route;
}

Route joint_route(const BranchData& data, const LensAndCounterBody& bodies) {
    return radius_route(data, bodies, {.displacement = true, .contact_radius = true}, "joint");
}

Eigen::MatrixXd independent_covariance(const Fitted& fitted) {
    const Eigen::MatrixXd reduced = inverse_information(fitted, across(fitted.points, fitted.solution));
    const Eigen::VectorXd units = units_of(fitted.points).head(reduced.rows());
    const Eigen::MatrixXd covariance = units.asDiagonal() * reduced * units.asDiagonal();
    return work_from_root(units.head<2>().cwiseProduct(fitted.solution.parameters.head<2>()), covariance).covariance;
}

}  // namespace setae::loops::errors_in_variables

namespace setae::loops {

JkrFit fit_joint(const BranchData& data, const LensAndCounterBody& bodies) {
    return errors_in_variables::joint_route(data, bodies).fit;
}

}  // namespace setae::loops
