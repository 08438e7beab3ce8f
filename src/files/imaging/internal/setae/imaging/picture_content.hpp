// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "setae/core/quantity.hpp"
#include "setae/imaging/micrograph.hpp"

namespace setae::imaging {

/// Metadata of a picture or a recording.
struct PictureContent {
    std::string format;  ///< identifier in micrograph_formats(), or "avi"
    long width = 0, height = 0;
    std::size_t frames = 1;  ///< number of frames of one size
    std::optional<PixelSize> pixel_size;
    std::optional<double> frame_rate;  ///< [1/s]
    std::string instrument, acquisition_time;
    std::vector<ImageEntry> images;  ///< of the file
    std::size_t image = 0;           ///< number of the described image
    std::vector<Alert> alerts;
};

/// Metadata of a file; empty if its first bytes are not those of a picture.
/// @throws as read_micrograph, for a damaged picture.
[[nodiscard]] std::optional<PictureContent> picture_content(const std::string& path);

}  // namespace setae::imaging
