// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/adhesion/generalised_fit.hpp"

namespace setae::adhesion {

/// The fit with one input held off what is told of it.
struct ProfilePoint {
    double shift = 0.0;           ///< of the input from what is told, in its standard errors
    Estimate work_of_adhesion;    ///< W with that value for exact [J/m²]
    double log_likelihood = 0.0;  ///< of the pairs, as GeneralisedFit has it
};

/// What W, and the likelihood of the pairs, owe to the value of one input.
struct InputProfile {
    std::string input;
    std::vector<ProfilePoint> points;  ///< shifts of −2, −1, 0, 1, 2
    /// What the pairs alone say of the input, in its standard errors from what is told: where the likelihood has its
    /// maximum, and 1/√(−d²lnL/dt²) there, from the middle three points. Standard error NaN where the pairs do not
    /// tell.
    Estimate by_pairs;
};

/// The profile of each input over all pairs.
///
///   measured + t u_m,  slope + t u_s,  offset + t u_o,  u: components of the input;  W fitted anew, the input taken
///   for exact, the scatter of the fit held
///
/// An input that has more than one direction, or that no pair rests on, has no profile.
/// @throws as fit_generalised().
[[nodiscard]] std::vector<InputProfile> profile_inputs(const std::vector<PairPoint>& pairs, const GeneralisedFit& fit,
                                                       const std::vector<std::string>& inputs);

}  // namespace setae::adhesion
