// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "least_squares.hpp"
#include "setae/loops/jkr_fits.hpp"

/// Functions shared by the routes to E* and W.
namespace setae::loops {

/// @throws InvalidArgument for R <= 0 or series of different length; UndefinedDataError for fewer than `fewest`
/// samples, or where contact radius or displacement is required and missing.
struct Wanted {
    bool contact_radius = false;
    bool displacement = false;
    Index fewest = 3;
};
void require_data(const BranchData& data, const LensAndCounterBody& bodies, const Wanted& wanted);

/// Largest |F| [N], the scale of the reduced model. @throws UndefinedDataError where all forces are zero.
[[nodiscard]] double force_scale(const BranchData& data);

/// @throws UndefinedDataError unless E* is finite and > 0: such a branch is no elastic contact.
void require_modulus(double contact_modulus);

/// Standard error of W ∝ p|p| from that of p: sqrt((2|p| σ)² + 2σ⁴) c, which stays finite at W = 0.
[[nodiscard]] double square_standard_error(double root, double root_standard_error, double factor);

/// W from E* and c = √(E*W), W = c|c|/E*, with the covariance of E*, W and the other fitted parameters.
struct WorkFromRoot {
    double work_of_adhesion = 0.0;
    double standard_error = 0.0;
    Eigen::MatrixXd covariance;
};
/// covariance: of E*, c and any others.
[[nodiscard]] WorkFromRoot work_from_root(const Eigen::Vector2d& modulus_and_root, const Eigen::MatrixXd& covariance);

/// Values of the shape parameter p of contact::jkr::radius_at for a search of the best one: 0 and logarithmic steps to
/// 10, which cover W from far below to a hundred times the W of the force scale.
[[nodiscard]] Array1D shape_candidates();

/// Fills E, correlation, runs, rms and relative residual from covariance, residuals and E*, W, and keeps W >= 0: where
/// the sum of squares has its minimum at W < 0, W becomes 0 and E* and contact point move along the valley of the sum
/// of squares to there; `unbounded_work` keeps the original W.
void complete(JkrFit& fit, const LensAndCounterBody& bodies, double fitted_range);

/// Adds to the covariance of a fit the uncertainty of the zero of force: the square of the change to `shifted`, the
/// same fit of the same data with all forces one standard error of their zero higher. An unusable shifted fit changes
/// nothing.
void add_force_zero_error(JkrFit& fit, const JkrFit& shifted, const LensAndCounterBody& bodies);

/// Means of so many neighbours each; a shorter rest at the end is left out.
[[nodiscard]] Array1D block_means(const Array1D& series, Index neighbours);

/// Neighbours whose means leave 64 samples or more for a first solution.
[[nodiscard]] Index neighbours_of_a_first_solution(Index samples);

/// Σ r²/variance over n − p; undefined where a variance is not > 0.
[[nodiscard]] double reduced_chi2(const ArrayView1D& residuals, const ArrayView1D& variances, Index parameters);

}  // namespace setae::loops
