// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include "setae/core/quantity.hpp"
#include "setae/processing/pipeline.hpp"

namespace setae::processing {

/// What of the waves along x a pipeline leaves as they were, so that a spectrum may still be learnt from them.
struct Untouched {
    Index trend_degree = 0;                                   ///< of the polynomial of x that lines have lost, 0 … 12
    Band band{0.0, std::numeric_limits<double>::infinity()};  ///< [1/m] where a wave keeps 99 % of its power and more
};

/// Of the steps that are on, for heights of this step along x [m].
///
///   polynomials: their degree in x.  Filters of cutoff λc, waves kept to 99 %: Gaussian λ > 11.8 λc (low-pass), λ <
///   λc/2.77 (high-pass); robust of order 2: 4.1 λc, 0.475 λc; spline: 3.76 λc, λc/3.76, with tension 14.1.
///   Fourier cut: its limits.  Resampling and turning by interpolation: q < 0.35/step, the coarser one.
///
/// Steps that move single heights (despiking, scars, masks) and whole lines are taken to leave all.
/// Source: transmissions as the filters state them.
[[nodiscard]] Untouched untouched(const Pipeline& pipeline, double step);

}  // namespace setae::processing
