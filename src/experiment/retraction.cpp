// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/experiment/retraction.hpp"

#include <cmath>

#include "fit_support.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::experiment {
namespace {

/// The linear problem F = E* (4a³/3R) − √(E*W) √(8πa³), with E* known or not.
struct Terms {
    Array1D hertz;     ///< 4a³/(3R)
    Array1D adhesion;  ///< √(8πa³)
};

Terms terms_of(const Array1D& contact_radius, double radius) {
    const Array1D cubed = contact_radius.cube();
    return {.hertz = 4.0 / 3.0 * cubed / radius, .adhesion = (8.0 * pi * cubed).sqrt()};
}

/// The contact radii, measured or implied. @throws UndefinedDataError where force and displacement imply none.
Array1D radii(const BranchData& points, double radius, double modulus, double contact_point) {
    const Array1D a = energy_release_rates(points, radius, modulus, contact_point).contact_radius;
    if (!a.allFinite())
        throw UndefinedDataError("force and displacement near pull-off imply no contact radius with the loading modulus");
    return a;
}

/// √(E*W) with E* given.
LeastSquaresSolution solve_fixed(const BranchData& points, double radius, double modulus, double contact_point) {
    const Terms terms = terms_of(radii(points, radius, modulus, contact_point), radius);
    return solve_linear(terms.adhesion.matrix(), modulus * terms.hertz - points.force);
}

/// E* and √(E*W).
LeastSquaresSolution solve_free(const BranchData& points, double radius) {
    const Terms terms = terms_of(points.contact_radius, radius);
    Eigen::MatrixXd design(points.force.size(), 2);
    design << terms.hertz, -terms.adhesion;
    return solve_linear(design, points.force);
}

}  // namespace

RetractionFit fit_retraction(const BranchData& last_points, double radius, const UncertainValue& contact_modulus,
                             double contact_point, bool modulus_free) {
    require_data(last_points, {.radius = radius}, {.fewest = modulus_free ? 3 : 2});
    RetractionFit fit{.contact_modulus = contact_modulus,
                      .modulus_free = modulus_free,
                      .n = last_points.force.size(),
                      .radius_measured = last_points.contact_radius.size() > 0};
    if (modulus_free && !fit.radius_measured)
        throw UndefinedDataError("a free modulus near pull-off needs the measured contact radius; keep the loading modulus");
    const auto work = [](double root, double modulus) { return root * std::abs(root) / modulus; };
    LeastSquaresSolution solution;
    if (modulus_free) {
        solution = solve_free(last_points, radius);
        const double modulus = solution.parameters[0];
        const double root = solution.parameters[1];
        fit.contact_modulus = {modulus, std::sqrt(solution.covariance(0, 0))};
        const Eigen::Vector2d slope(-work(root, modulus) / modulus, 2.0 * std::abs(root) / modulus);
        fit.work_of_adhesion = {work(root, modulus), std::sqrt(slope.dot(solution.covariance * slope))};
    } else {
        const double modulus = contact_modulus.value;
        solution = solve_fixed(last_points, radius, modulus, contact_point);
        const double root = solution.parameters[0];
        const double scatter = square_standard_error(root, std::sqrt(solution.covariance(0, 0)), 1.0 / modulus);
        const double stiffer = modulus + contact_modulus.standard_error;
        const double shift =
            work(solve_fixed(last_points, radius, stiffer, contact_point).parameters[0], stiffer) - work(root, modulus);
        fit.work_of_adhesion = {work(root, modulus), std::hypot(scatter, shift)};
    }
    fit.rms_residual = std::sqrt(solution.residuals.array().square().mean());
    return fit;
}

}  // namespace setae::experiment
