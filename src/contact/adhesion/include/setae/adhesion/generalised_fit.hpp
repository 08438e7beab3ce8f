// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "setae/adhesion/pair_point.hpp"

namespace setae::adhesion {

/// What pairs differ by from the balance beyond all known errors: standard deviations of effects of a pair, of all
/// pairs of a surface, of all pairs of an elastomer, in the unit of what was measured.
struct ModelScatter {
    double pair = 0.0, surface = 0.0, elastomer = 0.0;
};

/// Degrees of freedom that the scatter was estimated with.
struct ScatterFreedom {
    double pair = 0.0, surface = 0.0, elastomer = 0.0;
};

/// W by generalised least squares.
struct GeneralisedFit {
    TracedValue work_of_adhesion;  ///< W with every input it rests on, measured values and the scatter among them
    ModelScatter scatter;
    ScatterFreedom freedom;                  ///< pairs, surfaces and elastomers less one
    double r_squared = 0.0;                  ///< 1 − SS_res/SS_tot at this W, every pair alike
    double restricted_log_likelihood = 0.0;  ///< of the scatter, without its constant
    double log_likelihood = 0.0;  ///< of the measured values at this W and scatter, normal: ln density [(J/m²)^−n]
    int n = 0;
    std::set<std::string> surfaces, elastomers;  ///< of the pairs; directions of their effects are in this order

    /// W with its standard error.
    [[nodiscard]] Estimate estimate() const;
};

/// W from all pairs with the covariance of all errors.
///
///   minimise (y − f(W))ᵀ V⁻¹ (y − f(W)),  f_i = max(0, r_i W − o_i)
///   V = own noise + Σ_inputs c cᵀ + τ² 1 + τ_s² (pairs of one surface) + τ_e² (pairs of one elastomer)
///
/// c: what one input, one standard error off, does to y − f: through measured values and through predictions. Relative
/// errors of measured values are taken of what is predicted, not of what was measured, which would pull W down where
/// inputs are shared. Inputs of a prediction and effects of surfaces and elastomers are errors of the balance, of which
/// a pair below its floor shows share_through_floor(); τ is one of pairs. τ, τ_s, τ_e by restricted maximum likelihood;
/// τ_s (τ_e) needs three surfaces (elastomers), some of them with several pairs. W and V are iterated to a common
/// answer. The components of W are hᵀ times those of y − f, h = V⁻¹g/(gᵀV⁻¹g), g = ∂f/∂W.
/// @throws InvalidArgument for fewer than two pairs.
/// Source: Patterson, Thompson, Biometrika 58 (1971) 545; JCGM 102:2011; on relative errors: D'Agostini, Nucl. Instrum.
/// Methods A 346 (1994) 306.
[[nodiscard]] GeneralisedFit fit_generalised(const std::vector<PairPoint>& pairs);

/// The same for some of the pairs of `whole`, which tells the scatter between surfaces (elastomers) where these cannot.
[[nodiscard]] GeneralisedFit fit_some_generalised(const std::vector<PairPoint>& pairs, const GeneralisedFit& whole);

/// The same with the scatter held.
[[nodiscard]] GeneralisedFit fit_generalised(const std::vector<PairPoint>& pairs, const ModelScatter& scatter);

/// At a W and a scatter that are known from elsewhere: what W rests on with the weights that pairs have there.
[[nodiscard]] GeneralisedFit generalised_at(const std::vector<PairPoint>& pairs, double work_of_adhesion,
                                            const ModelScatter& scatter);

/// The scatter with W held: for a law with nothing to fit.
[[nodiscard]] GeneralisedFit fit_scatter(const std::vector<PairPoint>& pairs, double work_of_adhesion);

/// What a pair that was not in the fit departs from its balance by: the scatter that the fit found. Effects of a
/// surface (elastomer) that pairs of the fit have, too, are the ones W rests on; of another surface, and of the pair
/// itself, they are drawn anew.
///
///   variance of slope · W − offset − truth, one level of scatter, n surfaces alike, slope 1: τ_s² (1 − 1/n) on a
///   surface of the fit, τ_s² (1 + 1/n) on another
///
/// share: of effects of surfaces and elastomers that is seen, share_through_floor().
[[nodiscard]] Components departure_from(const GeneralisedFit& fit, const PairPoint& pair, double share);

}  // namespace setae::adhesion
