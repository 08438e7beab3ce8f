// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>

#include <opencv2/core.hpp>

#include "drawn_bars.hpp"

namespace setae::imaging {

constexpr int thickest_bar = 40;  ///< px

/// A candidate: its whole pixels, both ends included, and its contrast.
struct BarCandidate {
    int left = 0, right = 0, top = 0, bottom = 0;
    double level = 0, deviation = 0;
    double contrast = 0;  // bar minus surroundings: positive for bright bars
    bool drawn = false;   // uniform enough to be drawn, not photographed
    int outline = 0;
    double outline_level = 0;
    std::optional<BarTick> left_tick, right_tick;
    [[nodiscard]] int length() const { return right - left + 1; }
    [[nodiscard]] int thickness() const { return bottom - top + 1; }
    [[nodiscard]] cv::Rect box() const {
        const int y = std::max({outline, left_tick ? left_tick->reach : 0, right_tick ? right_tick->reach : 0});
        return {left - outline, top - y, length() + 2 * outline, thickness() + 2 * y};
    }
};

/// Something long and thin in a picture.
struct LongRun {
    cv::Rect box;
    double height = 0;  ///< difference from the pixels above and below, in units of scaled_levels
    double sign = 0;    ///< 1 if it is brighter, −1 if it is darker
};

/// The bar within a run: of one level, with straight ends and nothing beyond, separate from the pixels above and below;
/// empty if there is none, it touches the border of the picture or is shorter than min_length [px].
[[nodiscard]] std::optional<BarCandidate> bar_within(const cv::Mat1f& levels, const LongRun& run, int min_length);

}  // namespace setae::imaging
