// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "force_minimum.hpp"

namespace setae::loops {

/// A sudden change of a series that is smooth otherwise.
struct Step {
    Index last = 0;     ///< sample before it
    double size = 0.0;  ///< [unit of the series]
};

/// Degrees of the polynomials that a step is told apart by.
struct Smoothness {
    Index degree = 1;     ///< of the curve that the step interrupts
    Index rivalling = 3;  ///< of the curve without step that must fit worse
};

/// The step that a series has, if it has one: where a polynomial that changes its level there fits better than a smooth
/// one of a higher degree, and the change exceeds six standard errors, correlated noise allowed for, that of the series
/// itself or the noise known. Eight samples or more are left on both sides.
///
///   size = Σ_(behind) r/|h|²,  r: residuals of the polynomial, h: a unit step less the polynomial through it
///
/// Cost: linear.
[[nodiscard]] std::optional<Step> step_in(const Array1D& series, const Smoothness& smoothness,
                                          const SampleNoise& known = {});

}  // namespace setae::loops
