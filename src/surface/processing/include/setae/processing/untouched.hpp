// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include "setae/core/quantity.hpp"
#include "setae/processing/pipeline.hpp"

namespace setae::processing {

/// The waves along x that a pipeline does not change, from which a spectrum can still be determined.
struct Untouched {
    Index trend_degree = 0;  ///< degree of the polynomial of x removed from lines, 0 …
                             ///< 12
    Band band{0.0, std::numeric_limits<double>::infinity()};  ///< [1/m] in which a wave keeps at least 99 % of its
                                                              ///< power
};

/// Result for the enabled steps, for heights with this step along x [m].
///
///   polynomials: their degree in x
///   filters of cutoff λc, waves kept to 99 %: Gaussian λ > 11.8 λc (low-pass), λ < λc/2.77 (high-pass);
///     robust of order 2: 4.1 λc, 0.475 λc; spline: 3.76 λc, λc/3.76, with tension 14.1
///   Fourier cut: its limits
///   resampling and rotation with interpolation: q < 0.35/step, the coarser one
///
/// Steps that change single heights (despiking, scars, masks) or shift whole lines count as changing nothing. Source:
/// transmissions of the filters.
[[nodiscard]] Untouched untouched(const Pipeline& pipeline, double step);

}  // namespace setae::processing
