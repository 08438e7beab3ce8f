// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model_solve.hpp"

namespace setae::loops {

/// E*, W, the model's own parameters, contact point and their covariance, from a solution.
void fill_estimates(ModelFit& fit, const PreparedFit& prepared, const FitSolution& solution,
                    const LensAndCounterBody& bodies);

/// Derivatives of E*, W, the third parameter (λ of Maugis–Dugdale) and δ0 by the slots that fits move; not of
/// transition.
[[nodiscard]] Eigen::Vector4d physical_slopes(const BranchProblem& problem, const FitParameters& at);

/// An estimate of W with its error; a reason where the data do not hold W to within a factor.
[[nodiscard]] Outcome<Estimate> work_estimate(const ModelCurve& curve, const LeastSquaresSolution& solution,
                                              const FitParameters& at, double slot_standard_error);

/// Replaces λ and σ0 by the reason that λ reached one of its limits.
void leave_zone_open(ModelFit& fit, double transition_parameter);

/// A fit with the start of a further fit of the same branch.
struct SolvedFit {
    ModelFit fit;
    PreparedFit prepared;
    FitSolution solution;
};

/// fit_model, nothing forgotten.
[[nodiscard]] SolvedFit solved_fit(const BranchData& data, const LensAndCounterBody& bodies,
                                   const ModelFitOptions& options);

/// Covariance divided by the product of its errors.
[[nodiscard]] Eigen::MatrixXd correlations(const Eigen::MatrixXd& covariance);

}  // namespace setae::loops
