// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/parallel/for_each.hpp"
#include "setae/texture/measurement_view.hpp"

namespace setae::texture {

/// What is counted.
enum class Counted {
    height,     ///< h [m]
    slope_x,    ///< differences of neighbours along x [1]; of several directions with tests:
                ///< roughness/slope_distribution.hpp
    slope_y,    ///< maps alone [1]
    curvature,  ///< maps: half the five-point Laplacian; lines: second differences; polylines: by three points [1/m]
};

/// How often values occur, with the Gaussian of the same mean and rms beside it.
struct Distribution {
    Array1D centre;    ///< of the bins
    Array1D density;   ///< share of the values a width: its integral is 1
    Array1D gaussian;  ///< mean density of the Gaussian over each bin
    double mean = 0.0;
    double rms = 0.0;       ///< about the mean
    double skewness = 0.0;  ///< NaN where rms is 0
    double kurtosis = 0.0;  ///< 3 for a Gaussian; NaN where rms is 0
    double median = 0.0;
    double mad = 0.0;                  ///< 1.4826 times the median of |x − median|: the rms of a Gaussian
    double interquartile_range = 0.0;  ///< Q3 − Q1; 1.349 rms for a Gaussian
    double robust_skewness = 0.0;      ///< (Q3 + Q1 − 2 median)/(Q3 − Q1), Bowley; 0 where Q3 = Q1
    double gaussian_distance = 0.0;    ///< largest difference of cumulated shares at the bins' edges (Kolmogorov)
    Index values = 0;                  ///< counted
};

/// bins: equal ones from the least to the greatest value; 0: 2 IQR/n^(1/3) wide (Freedman, Diaconis 1981), 8 … 512 of
/// them. Undefined values are left out; differences wrap in periodic data. Slopes and curvatures of polylines count
/// with their length; their heights are those of the straight segments, exactly. Cost: linear. Memory beside the
/// measurement: twice the values.
/// @throws UndefinedDataError for fewer than two values; InvalidArgument for slope_y of a line, bins < 0 or a
/// re-entrant profile.
[[nodiscard]] Distribution distribution(const MeasurementView& measurement, Counted counted, Index bins = 0);

/// Central moment ⟨(h − ⟨h⟩)^k⟩ of heights [m^k], k = 1 … 8: over points, or over the straight segments of a polyline.
/// @throws InvalidArgument for another k; UndefinedDataError where no height is defined.
[[nodiscard]] double central_moment(const MeasurementView& measurement, int order);

}  // namespace setae::texture
