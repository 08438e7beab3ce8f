// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>

#include "latent_routes.hpp"
#include "fit_support.hpp"
#include "reduced_jkr.hpp"
#include "setae/core/constants.hpp"

namespace setae::experiment {
namespace {

/// The fit in reduced units: forces by F_s, radii by their largest, parameters L and p.
struct RadiusProblem {
    Array1D force;
    Array1D radius;

    [[nodiscard]] Eigen::VectorXd start() const {
        Eigen::Vector2d best(1.0, 0.0);
        double least = std::numeric_limits<double>::infinity();
        const Array1D candidates = reduced::shape_candidates();
        for (const double shape : candidates) {
            double xy = 0.0, xx = 0.0, yy = 0.0;
            for (Index i = 0; i < force.size(); ++i) {
                const double x = reduced::radius(force[i], shape).value;
                const double y = radius[i];
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

    [[nodiscard]] LeastSquaresSolution solve() const {
        const ResidualFunction function{
            .residuals = force.size(),
            .parameters = 2,
            .evaluate = [this](const Eigen::VectorXd& at, Eigen::VectorXd& residuals, Eigen::MatrixXd* jacobian) {
                for (Index i = 0; i < force.size(); ++i) {
                    const reduced::Point point = reduced::radius(force[i], at[1]);
                    residuals[i] = radius[i] - at[0] * point.value;
                    if (!jacobian) continue;
                    (*jacobian)(i, 0) = -point.value;
                    (*jacobian)(i, 1) = -at[0] * point.by_shape;
                }
            }};
        return minimise(function, start());
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
    fit.work_of_adhesion = solution.estimate(reduced::work_of_adhesion(shape, force_unit, bodies.radius),
                                             square_standard_error(shape, std::sqrt(solution.uncertainty.covariance(1, 1)), work_unit));
    fit.residuals = solution.residuals.array() * length_unit;
    const Array1D variances = problem.force_variances(solution.parameters, data.force_noise / force_unit) * length_unit *
                                  length_unit +
                              data.contact_radius_noise * data.contact_radius_noise;
    fit.chi2_reduced = reduced_chi2(fit.residuals, variances, 2);
    fit.correlated_samples = solution.uncertainty.correlated_samples;
    complete(fit, bodies, data.contact_radius.maxCoeff() - data.contact_radius.minCoeff());
    return fit;
}

}  // namespace setae::experiment
