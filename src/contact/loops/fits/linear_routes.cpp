// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "fit_support.hpp"
#include "setae/core/constants.hpp"

namespace setae::loops {

JkrFit fit_linear_form(const BranchData& data, const LensAndCounterBody& bodies) {
    require_data(data, bodies, {.contact_radius = true});
    const Array1D root = data.contact_radius * data.contact_radius.sqrt();  // a^(3/2)
    const Array1D abscissa = root / (std::sqrt(6.0 * pi) * bodies.radius);
    const Array1D ordinate = data.force / (std::sqrt(6.0 * pi) * root);
    Eigen::MatrixXd design(root.size(), 2);
    design << abscissa, Array1D::Constant(root.size(), -1.0);
    const LeastSquaresSolution solution = solve_linear(design, ordinate);
    const double stiffness = solution.parameters[0];  // K; the second is √(KW), with the sign of W

    JkrFit fit{.method = "linear_form", .converged = true, .contact_point = {undefined}, .residual_unit = "N/m^1.5"};
    require_modulus(stiffness);
    // K = 4E*/3, so c = √(KW) = √(4/3) √(E*W)
    const Eigen::Vector2d scale(0.75, std::sqrt(0.75));
    const WorkFromRoot work = work_from_root(scale.asDiagonal() * Eigen::Vector2d(solution.parameters),
                                             scale.asDiagonal() * solution.uncertainty.covariance * scale.asDiagonal());
    fit.covariance = work.covariance;
    fit.contact_modulus = solution.estimate(0.75 * stiffness, std::sqrt(work.covariance(0, 0)));
    fit.work_of_adhesion = solution.estimate(work.work_of_adhesion, work.standard_error);
    fit.residuals = solution.residuals.array();
    // with y = F/√(6πa³), x ∝ a^(3/2): d(y − Kx)/da = −(3/2) (y + Kx)/a
    const Array1D by_radius = 1.5 * (ordinate + stiffness * abscissa) / data.contact_radius;
    const Array1D by_force = (std::sqrt(6.0 * pi) * root).inverse();
    fit.chi2_reduced = reduced_chi2(
        fit.residuals, (by_radius * data.contact_radius_noise).square() + (by_force * data.force_noise).square(), 2);
    fit.correlated_samples = solution.uncertainty.correlated_samples;
    complete(fit, bodies, ordinate.maxCoeff() - ordinate.minCoeff());
    return fit;
}

PointwiseModulus fit_pointwise_modulus(const BranchData& data, const LensAndCounterBody& bodies) {
    require_data(data, bodies, {.contact_radius = true, .displacement = true});
    const double origin = data.displacement[0];
    const Array1D approach = data.displacement - origin - data.contact_radius.square() / (3.0 * bodies.radius);
    const Array1D ordinate = data.force / (2.0 * data.contact_radius);
    Eigen::MatrixXd design(approach.size(), 2);
    design << approach, Array1D::Constant(approach.size(), -1.0);
    const LeastSquaresSolution solution = solve_linear(design, ordinate);
    const double modulus = solution.parameters[0];
    require_modulus(modulus);
    const double offset = solution.parameters[1] / modulus;
    const Eigen::Vector2d offset_by(-offset / modulus, 1.0 / modulus);

    PointwiseModulus result;
    result.contact_modulus = solution.estimate(modulus, std::sqrt(solution.uncertainty.covariance(0, 0)));
    result.youngs_modulus = youngs_modulus(result.contact_modulus, bodies);
    result.contact_point =
        solution.estimate(origin + offset, std::sqrt(offset_by.dot(solution.uncertainty.covariance * offset_by)));
    result.pointwise = (approach - offset == 0.0).select(undefined, ordinate / (approach - offset));
    result.n = approach.size();
    result.rms_residual = std::sqrt(solution.residuals.array().square().mean());
    result.relative_residual = result.rms_residual / (ordinate.maxCoeff() - ordinate.minCoeff());
    return result;
}

}  // namespace setae::loops
