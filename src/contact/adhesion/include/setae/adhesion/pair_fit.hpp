// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "setae/adhesion/generalised_fit.hpp"
#include "setae/adhesion/pair_point.hpp"
#include "setae/core/estimate.hpp"

namespace setae::adhesion {

/// An estimate of W under one assumption on the errors.
struct WorkEstimate {
    Estimate work_of_adhesion;
    double chi_squared = 0.0;    ///< χ² with the assumed errors
    double extra_scatter = 0.0;  ///< standard deviation added to each pair's own, where the assumption has one
};

/// W from all pairs, and measures of the fit.
struct WorkFit {
    Estimate work_of_adhesion;  ///< least squares with equal weights; error from the residuals, with independent pairs
    /// The same value with correlated pairs of one surface and of one elastomer (two-way sandwich); degrees of freedom:
    /// number of groups of the rarer kind, minus one.
    Estimate clustered;
    double r_squared = 0.0;  ///< 1 − SS_res/SS_tot
    double residual_standard_deviation = 0.0;
    int n = 0;
    int degrees_of_freedom = 0;
    std::vector<PairPoint> pairs;  ///< pairs of the fit; residual = measured − prediction(work_of_adhesion.value)
    /// Fit weighted by the measured standard errors only; its χ² tests the model. For p < 0.05 the fit has no standard
    /// error.
    std::optional<WorkEstimate> weighted;
    /// with measured standard errors and a scatter of the model for which χ² equals the degrees of freedom
    std::optional<WorkEstimate> with_extra_scatter;
    std::optional<WorkEstimate>
        errors_in_both;  ///< with standard errors of measured and predicted values, and the remaining scatter
    std::optional<Estimate> likelihood;  ///< 95 % profile likelihood over the extra scatter
    GeneralisedFit generalised;          ///< fit with the covariance of all known errors
    std::optional<Estimate> posterior;   ///< WorkPosterior::work_of_adhesion(), where it is requested

    /// The reported value: the posterior where there is one, else generalised least squares.
    [[nodiscard]] Estimate stated() const { return posterior ? *posterior : generalised.estimate(); }
};

/// Least squares in W >= 0; the global minimum, found exactly from the kinks of the floored predictions.
/// The weighted variants need a standard error at every pair.
/// @throws InvalidArgument for fewer than two pairs or slopes <= 0.
/// Source: THEORY §10; clustered errors: Cameron, Gelbach, Miller, J. Bus. Econ. Stat. 29 (2011) 238.
[[nodiscard]] WorkFit fit_work_of_adhesion(const std::vector<PairPoint>& pairs);

/// A straight line through points: y = slope · x + intercept, ordinary least squares.
struct LineFit {
    Estimate slope, intercept;  ///< n − 2 degrees of freedom
    double r_squared = 0.0;
    int n = 0;
};

/// @throws InvalidArgument for fewer than three points or equal x.
[[nodiscard]] LineFit fit_line(const std::vector<double>& x, const std::vector<double>& y);

/// E_loss against A_true = r A, with the largest contact area A, by the four methods of THEORY §10.
struct LossFits {
    WorkFit through_origin;
    std::optional<WorkFit> through_origin_without_ideal_loss;  ///< with the loss of the smooth sphere subtracted
    std::optional<LineFit> with_intercept;
    std::optional<LineFit> with_intercept_without_ideal_loss;
};

/// pairs: measured E_loss [J] against A_true [m²] as slope; whole, and without the loss of an ideal smooth sphere where
/// that is known. Lines need three points of different areas.
/// @throws InvalidArgument for fewer than two whole pairs.
[[nodiscard]] LossFits fit_losses(const std::vector<PairPoint>& whole,
                                  const std::vector<PairPoint>& without_ideal_loss);

}  // namespace setae::adhesion
