// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/core/arrays.hpp"

namespace setae::formats::tests {

/// A VK3 or VK4 file with images of heights; pitch 500 nm and 250 nm, 2 nm per digit.
struct VkFile {
    std::vector<Array2D> heights;  ///< raw, up to three
    int version = 4, bits = 16;
    bool light = false;
    int minutes_ahead_of_utc = 540;
};

[[nodiscard]] std::string vk4_file(const VkFile& file);
/// A VK file after a picture, as VK6 or VK7.
[[nodiscard]] std::string vk6_file(const VkFile& file, char version = '6');
/// A picture of 2 × 2 points as BMP.
[[nodiscard]] std::string bmp_picture();

}  // namespace setae::formats::tests
