// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <opencv2/core.hpp>

namespace setae::imaging {

/// A picture of 8 bits, grey or blue, green and red, as the bytes of a PNG file.
[[nodiscard]] std::string png_of(const cv::Mat& picture);

}  // namespace setae::imaging
