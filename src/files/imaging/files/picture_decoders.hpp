// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "picture.hpp"

namespace setae::imaging {

// Grey levels of a whole file of each kind, whose header states `size`; a frame with a fault if it does not decode. The
// caller has checked the size.

[[nodiscard]] FrameRead decoded_png(std::string_view bytes, PictureSize size);

/// Refuses files with missing data, which libjpeg would fill with grey.
[[nodiscard]] FrameRead decoded_jpeg(std::string_view bytes, PictureSize size);

/// Source: Microsoft, Bitmap Storage; headers of OS/2 and Windows, 1 to 32 bits per pixel, run lengths.
[[nodiscard]] FrameRead decoded_bmp(std::string_view bytes, PictureSize size);

}  // namespace setae::imaging
