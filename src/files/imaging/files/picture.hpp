// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "setae/imaging/frames.hpp"

namespace setae::imaging {

struct PictureSize {
    long width = 0, height = 0;

    friend bool operator==(const PictureSize&, const PictureSize&) = default;
};

enum class PictureKind { none, png, jpeg, bmp, tiff };

/// By the first bytes.
[[nodiscard]] PictureKind picture_kind(std::string_view head);

/// Size in the header of a PNG, JPEG or BMP; empty if it is incomplete or another kind.
[[nodiscard]] std::optional<PictureSize> stated_size(std::string_view bytes);

/// Grey levels of a picture in memory; a frame with a fault if it does not decode.
[[nodiscard]] FrameRead decoded_picture(std::string_view bytes);

/// Grey level of a colour, ITU-R BT.601.
[[nodiscard]] constexpr float luminance_of(double red, double green, double blue) {
    return static_cast<float>(0.299 * red + 0.587 * green + 0.114 * blue);
}

/// Luminance of interleaved channels: 1, 2 (grey, alpha), 3 or 4 values per pixel, in the order red, green, blue[,
/// alpha].
template <class Value>
[[nodiscard]] FramePixels luminance(const Value* values, PictureSize size, int channels, long row_stride) {
    FramePixels pixels(size.height, size.width);
    for (long row = 0; row < size.height; ++row) {
        const Value* at = values + row * row_stride;
        for (long column = 0; column < size.width; ++column, at += channels)
            pixels(row, column) = channels < 3 ? static_cast<float>(at[0])
                                               : luminance_of(static_cast<double>(at[0]), static_cast<double>(at[1]),
                                                              static_cast<double>(at[2]));
    }
    return pixels;
}

}  // namespace setae::imaging
