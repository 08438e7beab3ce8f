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

/// Degrees of the polynomials by which a step is identified.
struct Smoothness {
    Index degree = 1;     ///< degree of the curve with the step
    Index rivalling = 3;  ///< degree of the curve without step that must fit worse
};

/// The step of a series, if it has one: where a polynomial with a step fits better than a smooth one of a higher
/// degree, and the step exceeds six standard errors, with correlated noise of the series or the known noise. At least
/// eight samples remain on both sides.
///
///   size = Σ_(after) r/|h|²,  r: residuals of the polynomial, h: a unit step minus the polynomial through it
///
/// Cost: linear.
[[nodiscard]] std::optional<Step> step_in(const Array1D& series, const Smoothness& smoothness,
                                          const SampleNoise& known = {});

}  // namespace setae::loops
