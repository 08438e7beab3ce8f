// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "setae/adhesion/pair_point.hpp"

namespace setae::adhesion {

/// Scatter of pairs about the balance beyond all known errors: standard deviations of effects of a pair, of all pairs
/// of a surface, of all pairs of an elastomer, in the unit of the measured quantity.
struct ModelScatter {
    double pair = 0.0, surface = 0.0, elastomer = 0.0;
};

/// Degrees of freedom of the estimated scatter.
struct ScatterFreedom {
    double pair = 0.0, surface = 0.0, elastomer = 0.0;
};

/// W by generalised least squares.
struct GeneralisedFit {
    TracedValue work_of_adhesion;  ///< W with all its inputs, including measured values and the scatter
    ModelScatter scatter;
    ScatterFreedom freedom;                  ///< number of pairs, surfaces and elastomers, each minus one
    double r_squared = 0.0;                  ///< 1 − SS_res/SS_tot at this W, with equal weights
    double restricted_log_likelihood = 0.0;  ///< restricted log-likelihood of the scatter, without its constant
    /// log-likelihood of the measured values at this W and scatter, normal: ln density [(J/m²)^−n]
    double log_likelihood = 0.0;
    int n = 0;
    std::set<std::string> surfaces, elastomers;  ///< names in the order of the directions of the effects

    /// W with its standard error.
    [[nodiscard]] Estimate estimate() const;
};

/// W from all pairs with the covariance of all errors.
///
///   minimise (y − f(W))ᵀ V⁻¹ (y − f(W)),  f_i = max(0, r_i W − o_i)
///   V = own noise + Σ_inputs c cᵀ + τ² 1 + τ_s² (pairs of one surface) + τ_e² (pairs of one elastomer)
///
/// c: change of y − f for a change of one input by one standard error, through measured values and through predictions.
/// Relative errors of measured values are relative to the prediction. Relative to the measured values, they would bias
/// W to low values where inputs are shared. Inputs of a prediction and effects of surfaces and elastomers are errors of
/// the balance; a pair below its floor shows share_through_floor() of them; τ is the scatter of pairs. τ, τ_s, τ_e by
/// restricted maximum likelihood; τ_s (τ_e) requires three surfaces (elastomers), some of them with several pairs. W
/// and V are iterated to a common solution. The components of W are hᵀ times those of y − f, h = V⁻¹g/(gᵀV⁻¹g), g =
/// ∂f/∂W.
/// @throws InvalidArgument for fewer than two pairs.
/// Source: Patterson, Thompson, Biometrika 58 (1971) 545; JCGM 102:2011; on relative errors: D'Agostini, Nucl. Instrum.
/// Methods A 346 (1994) 306.
[[nodiscard]] GeneralisedFit fit_generalised(const std::vector<PairPoint>& pairs);

/// The fit for some of the pairs of `whole`. `whole` gives the scatter between surfaces (elastomers) where these pairs
/// cannot.
[[nodiscard]] GeneralisedFit fit_some_generalised(const std::vector<PairPoint>& pairs, const GeneralisedFit& whole);

/// The fit with fixed scatter.
[[nodiscard]] GeneralisedFit fit_generalised(const std::vector<PairPoint>& pairs, const ModelScatter& scatter);

/// The fit at a given W and a given scatter: inputs of W with the weights of the pairs there.
[[nodiscard]] GeneralisedFit generalised_at(const std::vector<PairPoint>& pairs, double work_of_adhesion,
                                            const ModelScatter& scatter);

/// The scatter at a fixed W, for a model without a fitted parameter.
[[nodiscard]] GeneralisedFit fit_scatter(const std::vector<PairPoint>& pairs, double work_of_adhesion);

/// Deviation of a pair that was not in the fit from its balance, by the scatter of the fit. Effects of a surface
/// (elastomer) that also has pairs in the fit are those in W; effects of another surface, and of the pair itself, are
/// drawn independently.
///
///   variance of slope · W − offset − true value, one level of scatter, n equal surfaces, slope 1: τ_s² (1 − 1/n) on a
///   surface of the fit, τ_s² (1 + 1/n) on another
///
/// share: share of the effects of surfaces and elastomers that passes the floor, share_through_floor().
[[nodiscard]] Components departure_from(const GeneralisedFit& fit, const PairPoint& pair, double share);

}  // namespace setae::adhesion
