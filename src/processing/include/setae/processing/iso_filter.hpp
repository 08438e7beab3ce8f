// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>

#include "setae/parallel/for_each.hpp"
#include "setae/processing/parameters.hpp"
#include "setae/processing/processed.hpp"

namespace setae::processing {

/// Which part of the heights a filter leaves.
enum class Kept {
    long_waves,   ///< the mean line or surface: waviness, S-filter
    short_waves,  ///< heights minus it: roughness, L-filter
};
inline constexpr std::array<Choice<Kept>, 2> kept_names{{{"long_waves", Kept::long_waves}, {"short_waves", Kept::short_waves}}};

/// The Gaussian filter of ISO 16610-21 (lines) and 16610-61 (maps), 50 % transmission at the cutoff.
///
///   s(x) = exp(−π (x/(α λc))²)/(α λc),  α = sqrt(ln 2/π);  maps: the product along x and y
///
/// Non-periodic data: near ends and undefined points the weights that fall on defined points are scaled to sum 1 (zero-order) or the
/// local line is fitted with them (first-order, so that a plane passes unchanged up to the border). Undefined points stay undefined.
/// Equally spaced data alone. Cost O(n) a line and direction whatever the cutoff.
struct GaussianFilter {
    double cutoff = 0.0;  ///< nesting index λc [m], > 0
    Kept keep = Kept::long_waves;
    Index order = 0;      ///< 0 or 1: of the local polynomial at ends and holes
};

/// The robust Gaussian regression filter of ISO 16610-31 (lines) and 16610-71 (maps): local polynomial of order 0 or 2 (lines), weights
/// by Tukey's biweight with 4.4478 times the median of absolute residuals, iterated until it changes by less than 1e-4.
struct RobustGaussianFilter {
    double cutoff = 0.0;
    Kept keep = Kept::long_waves;
    Index order = 2;      ///< 0 or 2 on lines; maps take 0, or 2 along both directions
};

/// The spline filter of ISO 16610-22 on open profiles, natural ends; maps line by line along x, then along y.
///
///   (1 + β α² P + (1 − β) α⁴ Q) w = z,  α = 1/(2 sin(π Δ/λc));  transmission 50 % at λc
///
/// Robust: ISO 16610-32, the same with weights as RobustGaussianFilter.
struct SplineFilter {
    double cutoff = 0.0;
    Kept keep = Kept::long_waves;
    double tension = 0.0;  ///< β, 0 … 1
    bool robust = false;
};

[[nodiscard]] Processed apply(const GaussianFilter& filter, topography::Measurement measurement, parallel::Threads threads = {});
[[nodiscard]] Processed apply(const RobustGaussianFilter& filter, topography::Measurement measurement, parallel::Threads threads = {});
[[nodiscard]] Processed apply(const SplineFilter& filter, topography::Measurement measurement, parallel::Threads threads = {});

}  // namespace setae::processing
