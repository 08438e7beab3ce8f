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

/// What a fit and its simulated probes (by name) say of the inputs of its groups: one response for each name, those
/// without an error left out, in the order of names. band: that of the spectrum.
///
/// A probe's size moves what is read by ∂ ln T/∂ ln(size). Of factors, true = f × stated, at f = 1:
///
///   heights: P → f² P, and of traces their noise as stated;  lengths: P(q) → f P at q/f, E[P] by the response on nodes
///   q/f over f, what tips follow and add, what light and foils leave at the wavevectors where waves then are
///
/// Source: scaling of C1D, |h̃|²/L; derived here.
[[nodiscard]] std::vector<InputResponse> input_responses(const std::vector<ObservedGroup>& groups,
                                                         const std::map<std::string, TipResponse>& responses,
                                                         const WhittleFit& fit, const LogSpline& spline,
                                                         const Smoothness& smoothness);

}  // namespace setae::spectral_fit
