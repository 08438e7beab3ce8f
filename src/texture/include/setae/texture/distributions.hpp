// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/parallel/for_each.hpp"
#include "setae/texture/measurement_view.hpp"

namespace setae::texture {

/// What is counted.
enum class Counted {
    height,     ///< h [m]
    slope_x,    ///< forward differences along x [1]
    slope_y,    ///< maps alone [1]
    curvature,  ///< maps: half the five-point Laplacian; lines: second differences; polylines: of three points [1/m]
};

/// How often values occur, with a Gaussian beside it.
struct Distribution {
    Array1D centre;    ///< of the bins
    Array1D density;   ///< share of values a width: its integral is 1
    Array1D gaussian;  ///< density of the Gaussian with the same mean and rms deviation
    double mean = 0.0;
    double rms = 0.0;              ///< about the mean
    double skewness = 0.0;
    double kurtosis = 0.0;         ///< 3 for a Gaussian
    double median = 0.0;
    double mad = 0.0;              ///< 1.4826 × median of |x − median|: the rms of a Gaussian
    double interquartile_range = 0.0;
    double robust_skewness = 0.0;  ///< medcouple-free: (Q3 + Q1 − 2 median)/(Q3 − Q1), Bowley
    double gaussian_distance = 0.0; ///< largest difference of the cumulated share to the Gaussian's (Kolmogorov) [1]
    Index values = 0;
};

/// bins: number over mean ± 5 rms; 0 chooses by the rule of Freedman and Diaconis, at most 512. Values beyond are in the outer bins.
/// Polylines: heights and slopes weighted by length. Undefined values are left out.
/// @throws UndefinedDataError for fewer than two defined values; InvalidArgument for slope_y of a line.
[[nodiscard]] Distribution distribution(const MeasurementView& measurement, Counted counted, Index bins = 0,
                                        parallel::Threads threads = {});

/// Central moment ⟨(h − ⟨h⟩)^k⟩ [m^k] of heights, k = 1 … 8; polylines exact.
[[nodiscard]] double central_moment(const MeasurementView& measurement, int order, parallel::Threads threads = {});

}  // namespace setae::texture
