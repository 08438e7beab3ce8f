// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/loops/retraction.hpp"

#include <array>
#include <cmath>
#include <limits>

#include "fit_support.hpp"
#include "setae/contact/jkr_curve.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/statistics.hpp"

namespace setae::loops {
namespace {

using JkrArray = contact::jkr::CurveAt<Array1D>;

/// The contact radii, measured or implied. @throws UndefinedDataError where force and displacement imply none.
Array1D radii(const BranchData& points, double radius, double modulus, double contact_point) {
    const Array1D a = energy_release_rates(points, radius, modulus, contact_point).contact_radius;
    if (!a.allFinite())
        throw UndefinedDataError(
            "with the E* of loading, no contact radius follows from force and displacement near pull-off");
    return a;
}

/// √(E*W) with E* given.
LeastSquaresSolution solve_fixed(const BranchData& points, double radius, double modulus, double contact_point) {
    const JkrArray jkr(radii(points, radius, modulus, contact_point));
    const Array1D adhesion = contact::jkr::pull_coefficient(1.0) * jkr.three_halves;
    return solve_linear(adhesion.matrix(), contact::jkr::press_coefficient(modulus, radius) * jkr.cube - points.force);
}

/// E* and √(E*W).
LeastSquaresSolution solve_free(const BranchData& points, double radius) {
    const JkrArray jkr(points.contact_radius);
    Eigen::MatrixXd design(points.force.size(), 2);
    design << contact::jkr::press_coefficient(1.0, radius) * jkr.cube,
        -contact::jkr::pull_coefficient(1.0) * jkr.three_halves;
    return solve_linear(design, points.force);
}

}  // namespace

RetractionFit fit_retraction(const BranchData& last_points, double radius, const Estimate& contact_modulus,
                             double contact_point, bool modulus_free) {
    require_data(last_points, {.radius = radius}, {.fewest = modulus_free ? 3 : 2});
    RetractionFit fit{.contact_modulus = contact_modulus,
                      .modulus_free = modulus_free,
                      .n = last_points.force.size(),
                      .radius_measured = last_points.contact_radius.size() > 0};
    if (modulus_free && !fit.radius_measured)
        throw UndefinedDataError(
            "a free modulus near pull-off needs the contact radius, which was not measured; keep the "
            "modulus of loading");
    LeastSquaresSolution solution;
    if (modulus_free) {
        solution = solve_free(last_points, radius);
        require_modulus(solution.parameters[0]);
        fit.contact_modulus =
            solution.estimate(solution.parameters[0], std::sqrt(solution.uncertainty.covariance(0, 0)));
        const WorkFromRoot work = work_from_root(solution.parameters, solution.uncertainty.covariance);
        fit.work_of_adhesion = solution.estimate(work.work_of_adhesion, work.standard_error);
    } else {
        const double modulus = contact_modulus.value;
        const auto work = [](double root, double stiffness) { return root * std::abs(root) / stiffness; };
        solution = solve_fixed(last_points, radius, modulus, contact_point);
        const double root = solution.parameters[0];
        const double scatter =
            square_standard_error(root, std::sqrt(solution.uncertainty.covariance(0, 0)), 1.0 / modulus);
        const double stiffer = modulus + contact_modulus.standard_error;
        const double shift =
            std::isnan(stiffer)
                ? undefined
                : work(solve_fixed(last_points, radius, stiffer, contact_point).parameters[0], stiffer) -
                      work(root, modulus);
        fit.work_of_adhesion = solution.estimate(work(root, modulus), std::hypot(scatter, shift));
        const double modulus_freedom =
            contact_modulus.degrees_of_freedom.value_or(std::numeric_limits<double>::infinity());
        const std::array terms{VarianceTerm{scatter * scatter, solution.uncertainty.degrees_of_freedom},
                               VarianceTerm{shift * shift, modulus_freedom}};
        fit.work_of_adhesion.degrees_of_freedom = satterthwaite_degrees_of_freedom(terms);
    }
    fit.rms_residual = std::sqrt(solution.residuals.array().square().mean());
    return fit;
}

}  // namespace setae::loops
