// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "setae/core/quantity.hpp"
#include "setae/imaging/micrograph.hpp"

namespace setae::imaging {

/// What a picture or a recording says of itself.
struct PictureContent {
    std::string format;  ///< identifier in micrograph_formats(), or "avi"
    long width = 0, height = 0;
    std::size_t frames = 1;  ///< of one size
    std::optional<PixelSize> pixel_size;
    std::optional<double> frame_rate;  ///< [1/s]
    std::string instrument, acquisition_time;
    std::vector<ImageEntry> images;  ///< of the file
    std::size_t image = 0;           ///< the one described
    std::vector<Alert> alerts;
};

/// The same of a file; nothing where its first bytes are those of no picture.
/// @throws as read_micrograph, for a damaged picture.
[[nodiscard]] std::optional<PictureContent> picture_content(const std::string& path);

}  // namespace setae::imaging
