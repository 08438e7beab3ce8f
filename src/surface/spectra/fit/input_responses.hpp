// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "observed_groups.hpp"
#include "setae/spectral_fit/likelihood_spectrum.hpp"
#include "setae/spectral_fit/tip_response.hpp"
#include "whittle_fit.hpp"

namespace setae::spectral_fit {

/// Response of a fit and its simulated probes (by name) to the inputs of its groups: one per name, without inputs that
/// have no error, in the order of names. band: that of the spectrum.
///
/// The size of a probe changes the measured power by ∂ ln T/∂ ln(size). For factors, true = f × stated, at f = 1:
///
///   heights: P → f² P, and for traces their stated noise;  lengths: P(q) → f P at q/f, E[P] by the response on nodes
///   q/f over f, response and additional power of tips, transfer of light and foils at the wavevectors of the scaled
///   waves
///
/// Source: scaling of C1D, |h̃|²/L; derived here.
[[nodiscard]] std::vector<InputResponse> input_responses(const std::vector<ObservedGroup>& groups,
                                                         const std::map<std::string, TipResponse>& responses,
                                                         const WhittleFit& fit, const LogSpline& spline,
                                                         const Smoothness& smoothness);

}  // namespace setae::spectral_fit
