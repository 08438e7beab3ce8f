// SPDX-License-Identifier: GPL-3.0-or-later
#include "latent_routes.hpp"

#include <cmath>

#include <Eigen/Dense>

#include "fit_support.hpp"
#include "jkr_force_terms.hpp"
#include "setae/core/constants.hpp"

namespace setae::loops::latent {
namespace {

/// E* [Pa], √(E*W) and depths [m] of one reduced unit each.
Eigen::Vector3d units_of(const Points& points) {
    const double cubed = points.length * points.length * points.length;
    return {0.75 * points.radius * points.force_unit / cubed, points.force_unit / std::sqrt(8.0 * pi * cubed),
            points.depth_unit};
}

/// Inverse of the information without what noise along the curve only pretends; undefined where nothing is left.
Eigen::MatrixXd inverse_information(const Fitted& fitted, const Across& noise) {
    const Eigen::MatrixXd all = across_information(noise),
                          left = all - along_the_curve(fitted.points, fitted.solution).pretended;
    const Eigen::VectorXd scale = all.diagonal().cwiseSqrt().cwiseInverse();
    const Eigen::LLT<Eigen::MatrixXd> decomposition(scale.asDiagonal() * left * scale.asDiagonal());
    if (!scale.allFinite() || decomposition.info() != Eigen::Success)
        return Eigen::MatrixXd::Constant(all.rows(), all.cols(), undefined);
    return scale.asDiagonal() * decomposition.solve(Eigen::MatrixXd::Identity(all.rows(), all.cols())) *
           scale.asDiagonal();
}

Route radius_route(const BranchData& data, const LensAndCounterBody& bodies, Channels channels, std::string method) {
    const Points all = points(data, bodies, channels);
    Route route{.fitted = latent::fit(all, linear_start(all))};
    const Across noise = across(all, projected(all, route.fitted.solution));
    route.fit = finished(route.fitted, noise, std::move(method));
    route.fit.residuals = noise.force;
    route.fit.depth_residuals = noise.depth;
    route.fit.residual_unit = "N";
    complete(route.fit, bodies, data.force.maxCoeff() - data.force.minCoeff());
    return route;
}

}  // namespace

Route effective_variance_route(const BranchData& data, const LensAndCounterBody& bodies) {
    return radius_route(data, bodies, {.contact_radius = true}, "radius_force_effective_variance");
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

JkrFit finished(const Fitted& fitted, const Across& noise, std::string method) {
    const Points& points = fitted.points;
    const Solution& solution = fitted.solution;
    JkrFit fit{.method = std::move(method),
               .converged = solution.converged,
               .iterations = solution.rounds,
               .contact_point = {undefined}};
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
    const auto estimate = [&](double value, double standard_error) -> Estimate {
        return {.value = value,
                .standard_error = standard_error,
                .method = "fit covariance, correlated residuals",
                .degrees_of_freedom = found.degrees_of_freedom};
    };
    fit.covariance = work.covariance;
    fit.contact_modulus = estimate(modulus, std::sqrt(work.covariance(0, 0)));
    fit.work_of_adhesion = estimate(work.work_of_adhesion, work.standard_error);
    if (points.channels.displacement)
        fit.contact_point =
            estimate(points.origin + solution.parameters[2] * points.depth_unit, std::sqrt(work.covariance(2, 2)));
    double squares = 0.0;
    for (const auto& residuals : noise.residuals) squares += residuals.squaredNorm();
    const Index freedom = samples * static_cast<Index>(noise.residuals.size()) - parameters;
    fit.chi2_reduced = freedom > 0 ? squares / static_cast<double>(freedom) : undefined;
    fit.correlated_samples = found.correlated_samples;
    return fit;
}

}  // namespace setae::loops::latent
