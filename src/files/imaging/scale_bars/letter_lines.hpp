// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <opencv2/core.hpp>

namespace setae::imaging {

/// Adjacent letters, as connected pixels of a mask.
struct LetterLine {
    cv::Rect box;                   ///< of the letters, in the mask
    std::vector<cv::Rect> letters;  ///< from left to right, without points
    std::vector<cv::Rect> points;   ///< dots on the baseline
    int specks = 0;                 ///< number of other small parts within the box
    cv::Mat1b ink;                  ///< only letters and points, 255 on 0, of the size of the box
};

/// Lines of at least two letters among the connected parts of a mask (255 on 0), without parts that touch
/// `not_letters`.
[[nodiscard]] std::vector<LetterLine> letter_lines(const cv::Mat1b& mask, const std::vector<cv::Rect>& not_letters);

/// The first letter of a unit of two letters by its shape, compared with the m after it: 'p' if it is closed, 'm' with
/// three stems, 'n' if it is open below, 'u' (also for µ) if it is open above, 0 if uncertain.
[[nodiscard]] char prefix_by_shape(const LetterLine& line);

/// Whether the last letter has a closed part, as A does.
[[nodiscard]] bool last_letter_closed(const LetterLine& line);

}  // namespace setae::imaging
