// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/adhesion/generalised_fit.hpp"

namespace setae::adhesion {

/// The fit with one input fixed at a distance from its stated value.
struct ProfilePoint {
    double shift = 0.0;           ///< distance of the input from its stated value, in standard errors of the input
    Estimate work_of_adhesion;    ///< W with that value taken as exact [J/m²]
    double log_likelihood = 0.0;  ///< log-likelihood of the pairs, as in GeneralisedFit
};

/// W and the likelihood of the pairs as functions of one input.
struct InputProfile {
    std::string input;
    std::vector<ProfilePoint> points;  ///< shifts of −2, −1, 0, 1, 2
    /// The input as the pairs support it, relative to the stated value, in standard errors of the input: position of
    /// the maximum of the likelihood, and 1/√(−d²lnL/dt²) there, from the middle three points. The standard error is
    /// NaN where the pairs do not determine the input.
    Estimate by_pairs;
};

/// The profile of each input over all pairs.
///
///   measured + t u_m,  slope + t u_s,  offset + t u_o,  u: components of the input;  W is fitted again with the
///   input taken as exact and the scatter of the fit fixed
///
/// An input with more than one direction, or without influence on the pairs, has no profile.
/// @throws as fit_generalised().
[[nodiscard]] std::vector<InputProfile> profile_inputs(const std::vector<PairPoint>& pairs, const GeneralisedFit& fit,
                                                       const std::vector<std::string>& inputs);

}  // namespace setae::adhesion
