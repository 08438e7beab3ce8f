// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include <Eigen/Core>

#include "setae/imaging/contour_trace.hpp"

namespace setae::imaging {

/// One value a pixel: 1 sample, 0 vacuum.
using PixelMask = Eigen::Array<std::uint8_t, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// A picture divided into vacuum and sample.
struct TwoPhases {
    PixelMask sample;
    double vacuum_level = 0, vacuum_noise = 0;  ///< robust mean and standard deviation of a pixel
    double sample_level = 0, sample_noise = 0;
    Vacuum vacuum = Vacuum::bright;
    bool vacuum_assumed = false;  ///< neither brightness nor structure told which phase is vacuum
    double gain = 0;   ///< by how much two phases explain the picture better than one: ln of the likelihoods' ratio
    double cells = 0;  ///< independent places that gain rests on
};

/// Divides a picture into two phases of different grey level or structure.
///
/// Over squares of pixels the mean m and ln of the variance, v, are taken. A phase has a level that varies over the
/// picture (the illumination's quadratic surface, the sample's plane on it), a scatter of m and of v:
///
///   energy = Σ [½ ((m − level)/σ_m)² + ln σ_m + ½ ((v − v̄)/σ_v)² + ln σ_v] + 2 · length of the border in squares
///
/// with squares of at most 16; levels and scatter are those of squares away from the border. That
/// energy's least is found by minimum cuts and new levels in turns, from a dozen starts (grey levels, variances, half
/// planes). The border is then cut anew in squares of half the size within a band of ±3, down to single pixels, each
/// against the levels and scatter of its surroundings. Source: Boykov, Kolmogorov, IEEE Trans. Pattern Anal. Mach.
/// Intell. 26 (2004) 1124 (minimum cuts); Lombaert et al., ICCV 2005 (bands); Rother, Kolmogorov, Blake, ACM Trans.
/// Graph. 23 (2004) 309 (turns). pixels: defined. hidden: 1 where the picture shows no sample.
[[nodiscard]] TwoPhases divide(const FramePixels& pixels, const PixelMask& hidden, Vacuum vacuum);

/// A picture of two grey levels. The one with more of the picture's rim is vacuum, of equal ones the darker, unless
/// `vacuum` says.
[[nodiscard]] TwoPhases divide_binary(const FramePixels& pixels, const PixelMask& hidden, Vacuum vacuum);

/// Parts smaller than `min_area` [px], but the largest of either phase, become what surrounds them.
void remove_islands(PixelMask& sample, double min_area);

}  // namespace setae::imaging
