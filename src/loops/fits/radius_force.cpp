// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include "fit_support.hpp"
#include "latent_routes.hpp"
#include "reduced_jkr.hpp"
#include "setae/core/constants.hpp"
#include "small_least_squares.hpp"

namespace setae::loops {
namespace {

/// The fit in reduced units: forces by F_s, radii by their largest, parameters L and p.
struct RadiusProblem {
    Array1D force;
    Array1D radius;

    [[nodiscard]] Eigen::Vector2d start() const {
        const Index neighbours = neighbours_of_a_first_solution(force.size());
        const Array1D some_forces = block_means(force, neighbours), some_radii = block_means(radius, neighbours);
        Eigen::Vector2d best(1.0, 0.0);
        double least = std::numeric_limits<double>::infinity();
        const Array1D candidates = reduced::shape_candidates();
        for (const double shape : candidates) {
            const Array1D model = reduced::radii(some_forces, shape).value;
            const double xy = (model * some_radii).sum(), xx = model.square().sum();
            const double cost = some_radii.square().sum() - xy * xy / xx;
            if (cost < least) {
                least = cost;
                best = {xy / xx, shape};
            }
        }
        return RadiusProblem{.force = some_forces, .radius = some_radii}.minimum(best).parameters_found;
    }

    [[nodiscard]] SmallMinimum<2> minimum(const Eigen::Vector2d& from) const {
        const auto evaluate = [this](const Eigen::Vector2d& at) {
            const reduced::Curve curve = reduced::radii(force, at[1]);
            const Array1D residuals = radius - at[0] * curve.value, by_shape = at[0] * curve.by_shape;
            NormalEquations<2> sums{.squares = residuals.square().sum()};
            sums.normal << curve.value.square().sum(), (curve.value * by_shape).sum(), 0.0, by_shape.square().sum();
            sums.normal(1, 0) = sums.normal(0, 1);
            sums.gradient << (curve.value * residuals).sum(), (by_shape * residuals).sum();
            return sums;
        };
        return minimise_small<2>(evaluate, from, std::max(1.0, static_cast<double>(force.size() - 2)));
    }

    [[nodiscard]] LeastSquaresSolution solve() const {
        const SmallMinimum<2> found = minimum(start());
        LeastSquaresSolution solution{
            .parameters = found.parameters_found, .converged = found.converged, .iterations = found.iterations};
        const reduced::Curve curve = reduced::radii(force, solution.parameters[1]);
        solution.residuals = (radius - solution.parameters[0] * curve.value).matrix();
        Eigen::MatrixXd jacobian(force.size(), 2);
        jacobian << -curve.value, -solution.parameters[0] * curve.by_shape;
        solution.uncertainty = correlated_covariance(jacobian, solution.residuals);
        return solution;
    }

    /// (da/dF)² σ_F² in the problem's units: the slope as a secant over ±σ_F, finite where a(F) is vertical.
    [[nodiscard]] Array1D force_variances(const Eigen::VectorXd& at, double force_noise) const {
        Array1D variances = Array1D::Zero(force.size());
        if (!(force_noise > 0.0)) return variances;
        const Array1D rise =
            reduced::radii(force + force_noise, at[1]).value - reduced::radii(force - force_noise, at[1]).value;
        variances = (0.5 * at[0] * rise).square();
        return variances;
    }
};

}  // namespace

JkrFit fit_radius_force(const BranchData& data, const LensAndCounterBody& bodies, RadiusErrors errors) {
    require_data(data, bodies, {.contact_radius = true});
    if (errors == RadiusErrors::effective_variance) return latent::effective_variance_route(data, bodies).fit;
    const double force_unit = force_scale(data);
    const double length_unit = data.contact_radius.maxCoeff();
    const RadiusProblem problem{.force = data.force / force_unit, .radius = data.contact_radius / length_unit};
    const LeastSquaresSolution solution = problem.solve();

    const double length = solution.parameters[0] * length_unit;
    const double shape = solution.parameters[1];
    const double modulus = reduced::contact_modulus(length, force_unit, bodies.radius);
    require_modulus(modulus);
    const double work_unit = reduced::work_of_adhesion(1.0, force_unit, bodies.radius);
    const Eigen::Vector2d transform(-3.0 * modulus / solution.parameters[0], 2.0 * std::abs(shape) * work_unit);

    JkrFit fit{.method = "radius_force",
               .converged = solution.converged,
               .iterations = solution.iterations,
               .contact_point = {undefined},
               .residual_unit = "m"};
    fit.covariance = transform.asDiagonal() * solution.uncertainty.covariance * transform.asDiagonal();
    fit.contact_modulus = solution.estimate(modulus, std::sqrt(fit.covariance(0, 0)));
    fit.work_of_adhesion =
        solution.estimate(reduced::work_of_adhesion(shape, force_unit, bodies.radius),
                          square_standard_error(shape, std::sqrt(solution.uncertainty.covariance(1, 1)), work_unit));
    fit.residuals = solution.residuals.array() * length_unit;
    const Array1D variances =
        problem.force_variances(solution.parameters, data.force_noise / force_unit) * length_unit * length_unit +
        data.contact_radius_noise * data.contact_radius_noise;
    fit.chi2_reduced = reduced_chi2(fit.residuals, variances, 2);
    fit.correlated_samples = solution.uncertainty.correlated_samples;
    complete(fit, bodies, data.contact_radius.maxCoeff() - data.contact_radius.minCoeff());
    return fit;
}

}  // namespace setae::loops
