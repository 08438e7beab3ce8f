// SPDX-License-Identifier: GPL-3.0-or-later
#include "effective_variance.hpp"

#include <cmath>

#include "fit_support.hpp"
#include "jkr_force_terms.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::experiment {
namespace {

/// σ_F² + (dF/da)² σ_a² at each sample; both terms of F are powers of a.
Array1D variances(const BranchData& data, const ForceTerms& terms, const Eigen::VectorXd& at) {
    const Array1D slope = (3.0 * at[0] * terms.hertz - 1.5 * at[1] * terms.adhesion) / data.contact_radius;
    return data.force_noise * data.force_noise + (slope * data.contact_radius_noise).square();
}

}  // namespace

JkrFit fit_with_both_errors(const BranchData& data, const LensAndCounterBody& bodies) {
    if (!(data.force_noise > 0.0 && data.contact_radius_noise > 0.0))
        throw InvalidArgument("effective variance needs the noise of force and of contact radius; give them or use radius_only");
    const ForceTerms terms = force_terms(data.contact_radius, bodies.radius);
    Eigen::MatrixXd design(data.force.size(), 2);
    design << terms.hertz, -terms.adhesion;
    LeastSquaresSolution solution = solve_linear(design, data.force);
    JkrFit fit{.method = "radius_force_effective_variance", .contact_point = {undefined}, .residual_unit = "N"};
    constexpr int most_rounds = 100;
    while (!fit.converged && fit.iterations < most_rounds) {
        const Array1D weights = variances(data, terms, solution.parameters).rsqrt();
        const Eigen::VectorXd before = solution.parameters;
        solution = solve_linear(weights.matrix().asDiagonal() * design, weights * data.force);
        fit.converged = ((solution.parameters - before).array().abs() <= 1e-10 * before.array().abs()).all();
        ++fit.iterations;
    }
    require_modulus(solution.parameters[0]);
    const WorkFromRoot work = work_from_root(solution.parameters, solution.uncertainty.covariance);
    fit.contact_modulus = solution.estimate(solution.parameters[0], std::sqrt(solution.uncertainty.covariance(0, 0)));
    fit.work_of_adhesion = solution.estimate(work.work_of_adhesion, work.standard_error);
    fit.covariance = work.covariance;
    fit.residuals = data.force - (design * solution.parameters).array();
    fit.chi2_reduced = reduced_chi2(fit.residuals, variances(data, terms, solution.parameters), 2);
    complete(fit, solution, bodies, data.force.maxCoeff() - data.force.minCoeff());
    return fit;
}

}  // namespace setae::experiment
