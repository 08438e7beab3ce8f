// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include <Eigen/Core>

#include "setae/imaging/contour_trace.hpp"

namespace setae::imaging {

/// One value per pixel: 1 sample, 0 vacuum.
using PixelMask = Eigen::Array<std::uint8_t, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// A picture divided into vacuum and sample.
struct TwoPhases {
    PixelMask sample;
    double vacuum_level = 0, vacuum_noise = 0;  ///< robust mean and standard deviation of a pixel
    double sample_level = 0, sample_noise = 0;
    Vacuum vacuum = Vacuum::bright;
    bool vacuum_assumed = false;  ///< the phase of vacuum is assumed: neither brightness nor structure shows it
    double gain = 0;              ///< evidence for two phases instead of one: ln of the likelihood ratio
    double cells = 0;             ///< number of independent places in gain
};

/// Divides a picture into two phases of different grey level or structure.
///
/// For squares of pixels the mean m and ln of the variance, v, are computed. A phase has a level that varies over the
/// picture (a quadratic surface of illumination, a plane of the sample on it), a scatter of m and of v:
///
///   energy = Σ [½ ((m − level)/σ_m)² + ln σ_m + ½ ((v − v̄)/σ_v)² + ln σ_v] + 2 · length of the border in squares
///
/// with squares of at most 16; levels and scatter are those of squares away from the border. The energy is minimised by
/// alternating minimum cuts and new levels, from a dozen starts (grey levels, variances, half planes). The cut is then
/// repeated in squares of half the size within a band of ±3, down to single pixels, each against the levels and scatter
/// of its surroundings. Source: Boykov, Kolmogorov, IEEE Trans. Pattern Anal. Mach. Intell. 26 (2004) 1124 (minimum
/// cuts); Lombaert et al., ICCV 2005 (bands); Rother, Kolmogorov, Blake, ACM Trans. Graph. 23 (2004) 309 (turns).
/// pixels: defined. hidden: 1 where the picture shows no sample.
[[nodiscard]] TwoPhases divide(const FramePixels& pixels, const PixelMask& hidden, Vacuum vacuum);

/// A picture of two grey levels. Vacuum is the level with more of the rim of the picture, the darker one if equal,
/// unless `vacuum` is given.
[[nodiscard]] TwoPhases divide_binary(const FramePixels& pixels, const PixelMask& hidden, Vacuum vacuum);

/// Parts smaller than `min_area` [px], except the largest of either phase, take the label of their surroundings.
void remove_islands(PixelMask& sample, double min_area);

}  // namespace setae::imaging
