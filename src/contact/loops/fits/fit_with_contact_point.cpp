// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include "contact_points/held_contact_point.hpp"
#include "fit_support.hpp"
#include "setae/contact/jkr_curve.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "small_least_squares.hpp"

namespace setae::loops {
namespace {

using contact::jkr::DepthCurve;
using Point = contact::jkr::CurveValue;

struct HeldProblem {
    Array1D depth;  ///< δ − δ0 [m]
    Array1D force;  ///< [N]
    Array1D weight;
    double radius;
    double shape_unit;    ///< λ of a contact whose adhesion is as deep as its penetration
    double modulus_unit;  ///< [Pa]

    /// λ of the second parameter, which is 1 where W = 0, so that steps can be compared with it.
    [[nodiscard]] double shape_of(const Eigen::Vector2d& at) const { return (at[1] - 1.0) * shape_unit; }

    /// The best of many shapes, E* by linear regression, on some hundred of the samples.
    [[nodiscard]] Eigen::Vector2d start() const {
        constexpr Index enough = 100;
        const Index stride = std::max<Index>(1, depth.size() / enough);
        Eigen::Vector2d best(1.0, 1.0);
        double least = std::numeric_limits<double>::infinity();
        const auto consider = [&](double shape) {
            const DepthCurve curve(shape * shape_unit, radius);
            double xx = 0.0, xy = 0.0, yy = 0.0;
            for (Index i = 0; i < depth.size(); i += stride) {
                const double model = curve.at(depth[i]).value * modulus_unit;
                xx += model * model;
                xy += model * force[i];
                yy += force[i] * force[i];
            }
            const double cost = yy - xy * xy / xx;
            if (!(xx > 0.0 && xy > 0.0) || !(cost < least)) return;
            least = cost;
            best = {xy / xx, 1.0 + shape};
        };
        constexpr int steps = 40;
        consider(0.0);
        for (int i = 0; i < steps; ++i) consider(std::pow(10.0, -2.0 + 3.0 * i / (steps - 1)));
        return best;
    }

    [[nodiscard]] SmallMinimum<2> minimum(const Eigen::Vector2d& from) const {
        const auto evaluate = [this](const Eigen::Vector2d& at) {
            const DepthCurve curve(shape_of(at), radius);
            NormalEquations<2> sums;
            for (Index i = 0; i < force.size(); ++i) {
                const Point point = curve.at(depth[i]);
                const Eigen::Vector2d row =
                    weight[i] * modulus_unit * Eigen::Vector2d(point.value, at[0] * shape_unit * point.by_shape);
                const double residual = weight[i] * (force[i] - at[0] * modulus_unit * point.value);
                sums.normal += row * row.transpose();
                sums.gradient += row * residual;
                sums.squares += residual * residual;
            }
            return sums;
        };
        return minimise_small<2>(evaluate, from, static_cast<double>(std::max<Index>(force.size() - 2, 1)));
    }

    /// The minimum with its covariance; residuals without their weights.
    [[nodiscard]] LeastSquaresSolution completed(const SmallMinimum<2>& found) const {
        LeastSquaresSolution solution{
            .parameters = found.parameters_found, .converged = found.converged, .iterations = found.iterations};
        const Eigen::Vector2d& at = found.parameters_found;
        const DepthCurve curve(shape_of(at), radius);
        Eigen::MatrixXd jacobian(force.size(), 2);
        solution.residuals.resize(force.size());
        for (Index i = 0; i < force.size(); ++i) {
            const Point point = curve.at(depth[i]);
            jacobian.row(i) << -weight[i] * modulus_unit * point.value,
                -weight[i] * at[0] * modulus_unit * shape_unit * point.by_shape;
            solution.residuals[i] = weight[i] * (force[i] - at[0] * modulus_unit * point.value);
        }
        solution.uncertainty = correlated_covariance(jacobian, solution.residuals);
        solution.residuals.array() /= weight;
        return solution;
    }

    /// Variance of F − F(δ) [N²].
    [[nodiscard]] Array1D variances(const BranchData& data, const Eigen::Vector2d& at) const {
        const DepthCurve curve(shape_of(at), radius);
        Array1D result(force.size());
        for (Index i = 0; i < result.size(); ++i) {
            const double slope = at[0] * modulus_unit * curve.at(depth[i]).by_abscissa;
            result[i] = data.force_noise * data.force_noise +
                        slope * slope * data.displacement_noise * data.displacement_noise -
                        2.0 * slope * data.force_displacement_covariance;
        }
        return result;
    }
};

/// The data in units of the largest force.
struct Reduced {
    HeldProblem problem;
    BranchData data;  ///< its noise in the problem's units
    double scale;     ///< [N]
};

Reduced reduced_data(const BranchData& data, const LensAndCounterBody& bodies, double contact_point) {
    require_data(data, bodies, {.displacement = true, .fewest = 3});
    const double largest = data.displacement.maxCoeff() - contact_point, scale = force_scale(data);
    if (!(largest > 0.0))
        throw UndefinedDataError("the branch never passes the contact point; a fit needs a penetration > 0");
    Reduced reduced{.problem = {.depth = data.displacement - contact_point,
                                .force = data.force / scale,
                                .weight = Array1D::Ones(data.force.size()),
                                .radius = bodies.radius,
                                .shape_unit = std::sqrt(largest * std::sqrt(largest / bodies.radius)),
                                .modulus_unit = 0.75 / (std::sqrt(bodies.radius * largest) * largest)},
                    .data = {.force_noise = data.force_noise / scale,
                             .displacement_noise = data.displacement_noise,
                             .force_displacement_covariance = data.force_displacement_covariance / scale},
                    .scale = scale};
    return reduced;
}

/// Weighs each residual by its variance at the parameters, where it is known.
bool weigh(Reduced& reduced, const Eigen::Vector2d& at) {
    const Array1D variances = reduced.problem.variances(reduced.data, at);
    if (!(variances.minCoeff() > 0.0 && variances.isFinite().all())) return false;
    reduced.problem.weight = (variances.mean() / variances).sqrt();
    return true;
}

SmallMinimum<2> weighted_minimum(Reduced& reduced, SmallMinimum<2> found) {
    constexpr int rounds = 2;
    for (int round = 0; round < rounds && found.converged && weigh(reduced, found.parameters_found); ++round)
        found = reduced.problem.minimum(found.parameters_found);
    return found;
}

JkrFit completed(const Reduced& reduced, const SmallMinimum<2>& found, const BranchData& data,
                 const LensAndCounterBody& bodies, double contact_point) {
    const auto& [problem, noise, scale] = reduced;
    const LeastSquaresSolution solution = problem.completed(found);

    const double modulus = solution.parameters[0] * problem.modulus_unit * scale,
                 shape = problem.shape_of(solution.parameters);
    require_modulus(modulus);
    const double work_over_modulus = shape * std::abs(shape) / (2.0 * pi);
    Eigen::Matrix2d transform;
    transform << problem.modulus_unit * scale, 0.0,  //
        work_over_modulus * problem.modulus_unit * scale, modulus * std::abs(shape) / pi * problem.shape_unit;
    JkrFit fit{.method = "force_displacement_held_contact_point",
               .converged = solution.converged,
               .iterations = solution.iterations,
               .contact_point = {.value = contact_point, .standard_error = 0.0, .method = "held"},
               .residual_unit = "N"};
    fit.covariance = transform * solution.uncertainty.covariance * transform.transpose();
    fit.contact_modulus = solution.estimate(modulus, std::sqrt(fit.covariance(0, 0)));
    // the second-order term keeps the error finite at W = 0
    const double second = modulus / pi * std::pow(problem.shape_unit, 2) * solution.uncertainty.covariance(1, 1);
    fit.work_of_adhesion =
        solution.estimate(modulus * work_over_modulus, std::sqrt(fit.covariance(1, 1) + 0.5 * second * second));
    fit.residuals = solution.residuals.array() * scale;
    fit.chi2_reduced = reduced_chi2(solution.residuals.array(), problem.variances(noise, solution.parameters), 2);
    fit.correlated_samples = solution.uncertainty.correlated_samples;
    complete(fit, bodies, data.force.maxCoeff() - data.force.minCoeff());
    return fit;
}

}  // namespace

JkrFit fit_with_contact_point(const BranchData& data, const LensAndCounterBody& bodies, double contact_point) {
    Reduced reduced = reduced_data(data, bodies, contact_point);
    const SmallMinimum<2> found = weighted_minimum(reduced, reduced.problem.minimum(reduced.problem.start()));
    return completed(reduced, found, data, bodies, contact_point);
}

JkrFit fit_with_contact_point(const BranchData& data, const LensAndCounterBody& bodies, double contact_point,
                              const JkrFit& near) {
    Reduced reduced = reduced_data(data, bodies, contact_point);
    const double modulus = near.contact_modulus.value, ratio = near.work_of_adhesion.value / modulus;
    const Eigen::Vector2d start(
        modulus / (reduced.problem.modulus_unit * reduced.scale),
        1.0 + std::copysign(std::sqrt(2.0 * pi * std::abs(ratio)), ratio) / reduced.problem.shape_unit);
    const SmallMinimum<2> found =
        weighted_minimum(reduced, {.parameters_found = start, .converged = start.allFinite()});
    return found.converged && found.iterations > 0 ? completed(reduced, found, data, bodies, contact_point)
                                                   : fit_with_contact_point(data, bodies, contact_point);
}

}  // namespace setae::loops
