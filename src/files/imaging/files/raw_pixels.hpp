// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "picture.hpp"
#include "setae/bytes/source.hpp"

namespace setae::imaging {

/// How a file stores one number of a pixel; complex numbers count as their magnitude, bgra as luminance.
enum class SampleType {
    int8,
    uint8,
    int16,
    uint16,
    int32,
    uint32,
    int64,
    uint64,
    float16,
    float32,
    float64,
    complex_int16,
    complex_float32,
    complex_float64,
    bgra
};

[[nodiscard]] std::uint64_t bytes_of(SampleType type);
[[nodiscard]] bool is_complex(SampleType type);

/// Uncompressed pixels, row by row without padding, beginning at a place in a file.
struct RawPixels {
    std::uint64_t offset = 0;
    SampleType type = SampleType::uint8;
    bool big_endian = false;
    PictureSize size;
};

/// Grey levels of pixels in a file.
/// @throws FormatError, before memory is allocated, if they extend beyond the end of the file.
[[nodiscard]] FramePixels read_pixels(const bytes::Source& file, const RawPixels& layout);

/// Grey levels of pixels in memory, `channels` numbers each: one, two (the second is ignored), or red, green, blue and
/// more. Empty if `bytes` are fewer than the size needs.
[[nodiscard]] std::optional<FramePixels> pixels_in(std::string_view bytes, const RawPixels& layout, int channels);

}  // namespace setae::imaging
