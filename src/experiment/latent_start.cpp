// SPDX-License-Identifier: GPL-3.0-or-later
#include "latent_start.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

#include "fit_support.hpp"
#include "jkr_force_terms.hpp"
#include "setae/core/constants.hpp"

namespace setae::experiment::latent {
namespace {
/// Round by round, the offset of the curvature held while a sum of squares is made least: where plain rounds do not settle.
Solution solve_with_offsets_held(const Points& points, const Solution& near) {
    constexpr int most_rounds = 30;
    constexpr double settled = 1e-7;
    Solution solution = near;
    for (int round = 0; round < most_rounds; ++round) {
        const Parameters before = solution.parameters;
        solution = solve_carefully(round == 0 ? points : straightened(points, solution), before, solution.x);
        if (!solution.converged) return solution;
        solution.converged = round > 0 && (solution.parameters - before).cwiseAbs().maxCoeff() <= settled * before.cwiseAbs().maxCoeff();
        if (solution.converged) break;
    }
    return solution;
}

Solution solve_from(const Points& points, const Parameters& start) {
    Solution solution = solve(points, start, first_radii(points, start));
    if (!solution.converged) solution = solve_with_offsets_held(points, {.parameters = start, .x = first_radii(points, start)});
    return solution;
}

Eigen::MatrixXd information(const Across& noise) {
    Eigen::MatrixXd sum = noise.jacobians.front().transpose() * noise.jacobians.front();
    for (std::size_t s = 1; s < noise.jacobians.size(); ++s) sum += noise.jacobians[s].transpose() * noise.jacobians[s];
    return sum;
}

/// By how much the variance of the noise exceeds what the fit's corrections bear.
double excess(const Fitted& fitted) {
    constexpr double curvature = 0.1, pretended = 0.05;
    const AlongTheCurve along = along_the_curve(fitted.points, fitted.solution);
    const double share = information(across(fitted.points, fitted.solution)).ldlt().solve(along.pretended).trace();
    return std::max(std::pow(along.curvature / curvature, 2), share / pretended);
}

/// The covariance with the information that noise along the curve only pretends taken off.
Eigen::MatrixXd without_pretended(const Eigen::MatrixXd& covariance, const Fitted& fitted, const Across& noise) {
    const Eigen::MatrixXd all = information(noise), left = all - along_the_curve(fitted.points, fitted.solution).pretended;
    const Eigen::VectorXd scale = all.diagonal().cwiseSqrt().cwiseInverse();
    const Eigen::LLT<Eigen::MatrixXd> decomposition(scale.asDiagonal() * left * scale.asDiagonal());
    if (decomposition.info() != Eigen::Success) return Eigen::MatrixXd::Constant(all.rows(), all.cols(), undefined);
    const Eigen::MatrixXd wider = scale.asDiagonal() * decomposition.solve((scale.asDiagonal() * all).eval());
    return wider * covariance * wider.transpose();
}

}  // namespace

Parameters linear_start(const Points& all) {
    const Points points = averaged(all, neighbours_of_a_first_solution(all.force.size()));
    const Array1D three_halves = points.contact_radius * points.contact_radius.sqrt(), cube = points.contact_radius.cube();
    Eigen::Matrix2d normal;
    normal << cube.square().sum(), -(cube * three_halves).sum(), 0.0, cube.sum();
    normal(1, 0) = normal(0, 1);
    const Eigen::Vector2d found = normal.fullPivLu().solve(Eigen::Vector2d((cube * points.force).sum(), -(three_halves * points.force).sum()));
    Parameters start(found[0], found[1], 0.0);
    if (points.channels.displacement)
        start[2] = (points.depth - points.contact_radius.square() + 2.0 / 3.0 * start[1] / start[0] * points.contact_radius.sqrt()).mean();
    return start;
}

Fitted fit(const Points& points, const Parameters& start) {
    constexpr Index fewest_means = 24;
    const Index samples = points.force.size(), first_neighbours = neighbours_of_a_first_solution(samples);
    const Index most = std::max<Index>(1, samples / fewest_means);
    Parameters near = start;
    Index neighbours = 1;
    if (first_neighbours > 1) {
        Fitted first{.points = averaged(points, first_neighbours)};
        first.solution = solve_with_offsets_held(first.points, {.parameters = start, .x = first_radii(first.points, start)});
        neighbours = most;
        if (first.solution.converged) {
            near = first.solution.parameters;
            // variances of the samples are so many times those of the means
            const double wanted = static_cast<double>(first_neighbours) * excess(first);
            if (wanted < static_cast<double>(most)) neighbours = std::max<Index>(1, static_cast<Index>(std::ceil(wanted)));
        }
    }
    Fitted all{.points = neighbours > 1 ? averaged(points, neighbours) : points};
    all.solution = solve_from(all.points, near);
    return all;
}

JkrFit finished(const Fitted& fitted, const Across& noise, std::string method) {
    const Points& points = fitted.points;
    const Solution& solution = fitted.solution;
    JkrFit fit{.method = std::move(method), .converged = solution.converged, .iterations = solution.rounds, .contact_point = {undefined}};
    const Index parameters = noise.jacobians.front().cols(), samples = noise.jacobians.front().rows();
    const bool means = solution.x.size() != samples;
    const Across of_means = means ? across(points, solution) : Across();
    const Across& fitted_noise = means ? of_means : noise;
    FitCovariance found = correlated_covariance(fitted_noise.jacobians, fitted_noise.residuals);
    found.covariance = without_pretended(found.covariance, fitted, fitted_noise);
    const double cubed = points.length * points.length * points.length;
    const double modulus_unit = 0.75 * points.radius * points.force_unit / cubed, root_unit = points.force_unit / std::sqrt(8.0 * pi * cubed);
    const Eigen::VectorXd units = Eigen::Vector3d(modulus_unit, root_unit, points.depth_unit).head(parameters);
    const Eigen::MatrixXd covariance = units.asDiagonal() * found.covariance * units.asDiagonal();
    const double modulus = solution.parameters[0] * modulus_unit;
    require_modulus(modulus);
    const WorkFromRoot work = work_from_root({modulus, solution.parameters[1] * root_unit}, covariance);
    const auto estimate = [&](double value, double standard_error) -> Estimate {
        return {.value = value, .standard_error = standard_error, .method = "fit covariance, correlated residuals", .degrees_of_freedom = found.degrees_of_freedom};
    };
    fit.covariance = work.covariance;
    fit.contact_modulus = estimate(modulus, std::sqrt(work.covariance(0, 0)));
    fit.work_of_adhesion = estimate(work.work_of_adhesion, work.standard_error);
    if (points.channels.displacement) fit.contact_point = estimate(points.origin + solution.parameters[2] * points.depth_unit, std::sqrt(work.covariance(2, 2)));
    double squares = 0.0;
    for (const auto& residuals : noise.residuals) squares += residuals.squaredNorm();
    const Index freedom = samples * static_cast<Index>(noise.residuals.size()) - parameters;
    fit.chi2_reduced = freedom > 0 ? squares / static_cast<double>(freedom) : undefined;
    fit.correlated_samples = found.correlated_samples;
    return fit;
}

}  // namespace setae::experiment::latent
