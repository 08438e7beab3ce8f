// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include <opencv2/core.hpp>

#include "drawn_bars.hpp"
#include "label_recogniser.hpp"

namespace setae::imaging {

/// Text next to a scale bar.
struct BarLabel {
    std::string text;              ///< empty if none is legible
    std::optional<double> length;  ///< [m]
    std::optional<cv::Rect> box;   ///< of the line of letters
    std::string fault;             ///< why there is no length
};

/// Reads the label of a bar: a line of letters drawn in the level of the bar or of its outline, the nearest first.
///
/// A length is returned if three readings agree, in two masks and at two magnifications, no other contradicts them, the
/// first letter of the unit has the shape read (µ, n, p and m differ by open and closed parts) and a point, if any, is
/// a dot on the baseline and the only speck there.
[[nodiscard]] BarLabel read_label(const cv::Mat1f& levels, const DrawnBar& bar, LabelRecogniser& reader);

}  // namespace setae::imaging
