// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <opencv2/core.hpp>

namespace setae::imaging {

/// Letters beside each other, as connected pixels of a mask.
struct LetterLine {
    cv::Rect box;                   ///< of the letters, in the mask
    std::vector<cv::Rect> letters;  ///< from left to right, without points
    std::vector<cv::Rect> points;   ///< dots on the baseline
    int specks = 0;                 ///< other small things within the box
    cv::Mat1b ink;                  ///< the letters and points alone, 255 on 0, of the size of the box
};

/// Lines of at least two letters among the connected parts of a mask (255 on 0); parts that touch `not_letters` are
/// none.
[[nodiscard]] std::vector<LetterLine> letter_lines(const cv::Mat1b& mask, const std::vector<cv::Rect>& not_letters);

/// The first letter of a unit of two letters by its shape, beside the m that follows it: 'p' where it encloses
/// something, 'm' where it has three stems, 'n' where it is open below, 'u' (for µ, too) where it is open above, 0
/// where none is sure.
[[nodiscard]] char prefix_by_shape(const LetterLine& line);

/// Whether the last letter encloses something, as A does.
[[nodiscard]] bool last_letter_closed(const LetterLine& line);

}  // namespace setae::imaging
