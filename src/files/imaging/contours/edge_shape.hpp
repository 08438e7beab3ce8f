// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "edge_band.hpp"

namespace setae::imaging {

/// Transition of grey levels from sample to vacuum, on average over a contour.
///
///   I(d) = level + step/2 erf(t/(√2 width)) + fringe (t/fringe_width) exp(½ − t²/(2 fringe_width²)),   t = d − place
///
/// d: distance from the curve, positive in vacuum [px]. The fringe is odd: the slope is steepest at t = 0, with or
/// without it.
struct EdgeShape {
    double level = 0, step = 0, place = 0, width = 1, fringe = 0, fringe_width = 3;

    [[nodiscard]] double value(double distance) const;  ///< without level, for place 0
    [[nodiscard]] double slope(double distance) const;
    /// The fringe is most of the slope at the edge: the width of the step is then not determined, and taken as that of
    /// the Gaussian with the curvature of the fringe, fringe_width/√3.
    [[nodiscard]] bool fringe_rules() const;
};

/// Mean and scatter of grey levels by distance from a curve, in bins a quarter of a pixel wide.
struct EdgeProfile {
    double reach = 0;                                     ///< bins from −reach to reach [px]
    std::vector<double> count, distance, mean, variance;  ///< distance: mean over the pixels of a bin
};
[[nodiscard]] EdgeProfile edge_profile(const std::vector<BandPixel>& pixels, double reach);

/// Fits the shape by least squares, starting from the steepest slope of the profile, whose sign is that of the step if
/// the ends of the profile differ by more than a quarter of its range; the fringe is kept if it exceeds the noise.
[[nodiscard]] EdgeShape fitted_shape(const EdgeProfile& profile);

/// Fits the shape starting from an approximate one.
[[nodiscard]] EdgeShape fitted_shape(const EdgeProfile& profile, const EdgeShape& start);

}  // namespace setae::imaging
