// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <opencv2/core.hpp>

#include "setae/imaging/scale_bar.hpp"

namespace setae::imaging {

/// A scale bar, and why its label is no length.
struct FoundBar {
    ScaleBar bar;
    std::string label_fault;
};

/// Result of find_scale_bars, with reasons. levels: as scaled_levels.
[[nodiscard]] std::vector<FoundBar> found_bars(const cv::Mat1f& levels);

}  // namespace setae::imaging
