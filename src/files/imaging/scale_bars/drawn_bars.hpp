// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include <opencv2/core.hpp>

#include "setae/imaging/frames.hpp"

namespace setae::imaging {

/// Grey levels scaled so that all but the darkest and the brightest thousandth are in [0, 1]; pixels without a number
/// are 0. A picture of one level is 0.
[[nodiscard]] cv::Mat1f scaled_levels(const FramePixels& pixels);

/// A tick at an end of a bar, where the bar is higher.
struct BarTick {
    double middle = 0, width = 0;  ///< [px]; as FramePixels
    int reach = 0;                 ///< height in rows beyond the bar
};

/// A rectangle drawn into a picture, without its label. Lengths in pixels, coordinates as FramePixels.
struct DrawnBar {
    double begin_x = 0, end_x = 0;
    double y = 0, thickness = 0;
    double length_standard_error = 0;
    cv::Rect box;         ///< whole pixels, with outline and ticks
    double level = 0;     ///< of its pixels, as scaled_levels
    double contrast = 0;  ///< median difference from the surroundings, as scaled_levels
    std::optional<double> outline_level;
    std::optional<cv::Rect> gap;                   ///< between two halves, with the label
    std::optional<BarTick> left_tick, right_tick;  ///< of only one end; equal ticks at both ends limit the length
    double quality = 0;                            ///< in [0, 1]
};

/// Bars of a picture, best first. levels: as scaled_levels.
[[nodiscard]] std::vector<DrawnBar> drawn_bars(const cv::Mat1f& levels);

/// One end of a bar.
struct BarEnd {
    double place = 0;           ///< [px] beyond the edge of the last whole pixel, which is 0
    double standard_error = 0;  ///< 0 if the bar ends with a whole pixel
};

/// End of a bar, by the likelihood of its rows.
///
///   g(x) = c m + (1 − c) o + noise,  variance s² + (1 − c)² u²
///
/// c: coverage of the pixel by a bar with the edge at `place`, blurred by a normal kernel; m, s: level and deviation of
/// the bar; o, u: mean and deviation of the surroundings. Edges between whole pixels have prior odds of 50:1, as
/// programs draw them; otherwise place and error are those of the posterior. rows: those of the bar, columns from
/// `inside` pixels before the edge of the last whole pixel outwards. outline: o if it is known.
[[nodiscard]] BarEnd bar_end(const cv::Mat1f& rows, int inside, double level, double deviation,
                             const std::optional<double>& outline = {});

}  // namespace setae::imaging
