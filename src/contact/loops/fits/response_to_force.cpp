// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include "errors_in_variables/routes.hpp"
#include "fit_support.hpp"
#include "setae/contact/jkr_curve.hpp"
#include "setae/core/errors.hpp"
#include "small_least_squares.hpp"

namespace setae::loops {
namespace {

namespace jkr = contact::jkr;

/// Response of a contact to force, in reduced units: c M(f; p) with parameters c and p, M the contact radius; or, with
/// three parameters, c M(f; p) + δ0, M the depth. Least squares in the response.
template <int parameters>
struct Response {
    static constexpr bool is_depth = parameters == 3;
    using Vector = Eigen::Matrix<double, parameters, 1>;

    Array1D force;
    Array1D values;

    [[nodiscard]] static jkr::CurveValues model(const Array1D& force, double shape) {
        if constexpr (is_depth) return jkr::depths_at(force, shape);
        else return jkr::radii_at(force, shape);
    }
    [[nodiscard]] static double offset(const Eigen::Ref<const Eigen::VectorXd>& at) { return is_depth ? at[2] : 0.0; }

    /// The best of many shapes, c and δ0 by linear regression, refined on means of neighbours.
    [[nodiscard]] Vector start() const {
        const Index neighbours = neighbours_of_a_first_solution(force.size());
        const Response some{.force = block_means(force, neighbours), .values = block_means(values, neighbours)};
        const double mean_value = is_depth ? some.values.mean() : 0.0;
        Vector best = Vector::Unit(0);
        double least = std::numeric_limits<double>::infinity();
        for (const double shape : shape_candidates()) {
            Array1D curve = model(some.force, shape).value;
            const double mean_curve = is_depth ? curve.mean() : 0.0;
            curve -= mean_curve;
            const double xx = curve.square().sum();
            if (!(xx > 0.0)) continue;
            const double scale = (curve * (some.values - mean_value)).sum() / xx;
            const double cost = (some.values - mean_value - scale * curve).square().sum();
            if (!(cost < least)) continue;
            least = cost;
            best[0] = scale;
            best[1] = shape;
            if constexpr (is_depth) best[2] = mean_value - scale * mean_curve;
        }
        return some.minimum(best).parameters_found;
    }

    [[nodiscard]] SmallMinimum<parameters> minimum(const Vector& from) const {
        const auto evaluate = [this](const Vector& at) {
            const jkr::CurveValues curve = model(force, at[1]);
            const Array1D residuals = values - at[0] * curve.value - offset(at), by_shape = at[0] * curve.by_shape;
            NormalEquations<parameters> sums{.squares = residuals.square().sum()};
            sums.normal(0, 0) = curve.value.square().sum();
            sums.normal(0, 1) = (curve.value * by_shape).sum();
            sums.normal(1, 1) = by_shape.square().sum();
            sums.gradient.template head<2>() << (curve.value * residuals).sum(), (by_shape * residuals).sum();
            if constexpr (is_depth) {
                sums.normal.col(2) << curve.value.sum(), by_shape.sum(), static_cast<double>(force.size());
                sums.gradient[2] = residuals.sum();
            }
            sums.normal = sums.normal.template selfadjointView<Eigen::Upper>();
            return sums;
        };
        return minimise_small<parameters>(evaluate, from,
                                          std::max(1.0, static_cast<double>(force.size() - parameters)));
    }

    /// c and δ0 with p = 0, a contact without adhesion.
    [[nodiscard]] SmallMinimum<parameters> without_adhesion() const {
        const Array1D curve = model(force, 0.0).value, centred = curve - curve.mean();
        const double scale = (centred * (values - values.mean())).sum() / centred.square().sum();
        SmallMinimum<parameters> found{.parameters_found = Vector::Zero(), .converged = true, .iterations = 1};
        found.parameters_found[0] = scale;
        found.parameters_found[parameters - 1] = values.mean() - scale * curve.mean();
        return found;
    }

    [[nodiscard]] LeastSquaresSolution solve() const {
        SmallMinimum<parameters> found = minimum(start());
        // a depth has another minimum at p < 0, which is no contact
        if (is_depth && found.parameters_found[1] < 0.0) found = without_adhesion();
        LeastSquaresSolution solution{
            .parameters = found.parameters_found, .converged = found.converged, .iterations = found.iterations};
        const Vector& at = found.parameters_found;
        const jkr::CurveValues curve = model(force, at[1]);
        solution.residuals = (values - at[0] * curve.value - offset(at)).matrix();
        Eigen::MatrixXd jacobian(force.size(), parameters);
        jacobian.leftCols(2) << -curve.value, -at[0] * curve.by_shape;
        if constexpr (is_depth) jacobian.col(2).setConstant(-1.0);
        solution.uncertainty = correlated_covariance(jacobian, solution.residuals);
        return solution;
    }
};

/// Conversion to SI units.
struct Scales {
    double radius, force, unit;  ///< radius of the sphere [m], scale of forces [N], of the response [m]
    double modulus;              ///< E* of the solution [Pa]
    double modulus_power;        ///< E* ∝ c to this power
};

JkrFit in_si_units(const LeastSquaresSolution& solution, const Scales& scales, const char* method) {
    require_modulus(scales.modulus);
    const double shape = solution.parameters[1], work_unit = jkr::work_of_shape(1.0, scales.force, scales.radius);
    Eigen::VectorXd transform = Eigen::VectorXd::Constant(solution.parameters.size(), scales.unit);
    transform[0] = scales.modulus_power * scales.modulus / solution.parameters[0];
    transform[1] = 2.0 * std::abs(shape) * work_unit;
    JkrFit fit{.method = method,
               .converged = solution.converged,
               .iterations = solution.iterations,
               .contact_point = {undefined},
               .residual_unit = "m"};
    fit.covariance = transform.asDiagonal() * solution.uncertainty.covariance * transform.asDiagonal();
    fit.contact_modulus = solution.estimate(scales.modulus, std::sqrt(fit.covariance(0, 0)));
    fit.work_of_adhesion =
        solution.estimate(jkr::work_of_shape(shape, scales.force, scales.radius),
                          square_standard_error(shape, std::sqrt(solution.uncertainty.covariance(1, 1)), work_unit));
    fit.residuals = solution.residuals.array() * scales.unit;
    fit.correlated_samples = solution.uncertainty.correlated_samples;
    return fit;
}

/// Variance of a − a(F) [m²] from the noise of both: the slope as a secant over ±σ_F, finite where a(F) is vertical.
Array1D radius_variances(const BranchData& data, const Response<2>& problem, const Eigen::VectorXd& at,
                         const Scales& scales) {
    Array1D variances = Array1D::Constant(data.force.size(), data.contact_radius_noise * data.contact_radius_noise);
    const double noise = data.force_noise / scales.force;
    if (!(noise > 0.0)) return variances;
    const Array1D rise =
        jkr::radii_at(problem.force + noise, at[1]).value - jkr::radii_at(problem.force - noise, at[1]).value;
    return variances + (0.5 * at[0] * rise).square() * scales.unit * scales.unit;
}

/// Variance of δ − δ(F) [m²] from the noise of both channels and its covariance. At and beyond the pull-off, where δ(F)
/// is vertical, the slope is that one standard deviation of force above it.
Array1D depth_variances(const BranchData& data, const Response<3>& problem, const Eigen::VectorXd& at,
                        const Scales& scales) {
    const double weakest = -at[1] * at[1] + data.force_noise / scales.force;
    return problem.force.unaryExpr([&](double force) {
        const double slope =
            at[0] * jkr::depth_at(std::max(force, weakest), at[1]).by_abscissa * scales.unit / scales.force;
        return data.displacement_noise * data.displacement_noise + slope * slope * data.force_noise * data.force_noise -
               2.0 * slope * data.force_displacement_covariance;
    });
}

}  // namespace

JkrFit fit_radius_force(const BranchData& data, const LensAndCounterBody& bodies, RadiusErrors errors) {
    require_data(data, bodies, {.contact_radius = true});
    if (errors == RadiusErrors::effective_variance)
        return errors_in_variables::effective_variance_route(data, bodies).fit;
    Scales scales{.radius = bodies.radius,
                  .force = force_scale(data),
                  .unit = data.contact_radius.maxCoeff(),
                  .modulus_power = -3.0};
    const Response<2> problem{.force = data.force / scales.force, .values = data.contact_radius / scales.unit};
    const LeastSquaresSolution solution = problem.solve();
    scales.modulus = jkr::modulus_of_length(solution.parameters[0] * scales.unit, scales.force, bodies.radius);
    JkrFit fit = in_si_units(solution, scales, "radius_force");
    fit.chi2_reduced = reduced_chi2(fit.residuals, radius_variances(data, problem, solution.parameters, scales), 2);
    complete(fit, bodies, data.contact_radius.maxCoeff() - data.contact_radius.minCoeff());
    return fit;
}

JkrFit fit_force_displacement(const BranchData& data, const LensAndCounterBody& bodies, DepthErrors errors) {
    require_data(data, bodies, {.displacement = true, .fewest = 4});
    if (errors == DepthErrors::effective_variance && (data.force_noise > 0.0 || data.displacement_noise > 0.0))
        return errors_in_variables::force_displacement_route(data, bodies).fit;
    Scales scales{.radius = bodies.radius, .force = force_scale(data), .modulus_power = -1.5};
    const double origin = data.displacement[0];
    scales.unit = data.displacement.maxCoeff() - data.displacement.minCoeff();
    if (!(scales.unit > 0.0))
        throw UndefinedDataError("the displacement does not change along the branch; a fit needs one that does");
    const Response<3> problem{.force = data.force / scales.force, .values = (data.displacement - origin) / scales.unit};
    const LeastSquaresSolution solution = problem.solve();
    scales.modulus = jkr::modulus_of_length(std::sqrt(solution.parameters[0] * scales.unit * bodies.radius),
                                            scales.force, bodies.radius);
    JkrFit fit = in_si_units(solution, scales, "force_displacement");
    fit.contact_point =
        solution.estimate(origin + solution.parameters[2] * scales.unit, std::sqrt(fit.covariance(2, 2)));
    fit.chi2_reduced = reduced_chi2(fit.residuals, depth_variances(data, problem, solution.parameters, scales), 3);
    complete(fit, bodies, scales.unit);
    return fit;
}

}  // namespace setae::loops
