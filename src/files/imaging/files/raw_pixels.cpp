// SPDX-License-Identifier: GPL-3.0-or-later
#include "raw_pixels.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <vector>

#include <fmt/format.h>

#include "setae/bytes/stored_numbers.hpp"
#include "setae/core/errors.hpp"

namespace setae::imaging {
namespace {

constexpr std::uint64_t block_bytes = 1 << 20;

/// IEEE 754 binary16.
float half(std::uint16_t bits) {
    const int exponent = (bits >> 10) & 31, fraction = bits & 1023;
    const float magnitude = exponent == 0    ? std::ldexp(static_cast<float>(fraction), -24)
                            : exponent == 31 ? (fraction ? NAN : INFINITY)
                                             : std::ldexp(static_cast<float>(1024 + fraction), exponent - 25);
    return bits & 0x8000 ? -magnitude : magnitude;
}

template <class Value>
void convert(const char* from, std::endian order, std::uint64_t count, float* to) {
    for (std::uint64_t i = 0; i < count; ++i)
        to[i] = static_cast<float>(bytes::load<Value>(from + i * sizeof(Value), order));
}

template <class Part>
void convert_complex(const char* from, std::endian order, std::uint64_t count, float* to) {
    for (std::uint64_t i = 0; i < count; ++i) {
        const auto* at = from + 2 * i * sizeof(Part);
        to[i] = static_cast<float>(std::hypot(static_cast<double>(bytes::load<Part>(at, order)),
                                              static_cast<double>(bytes::load<Part>(at + sizeof(Part), order))));
    }
}

/// Packed colours are numbers 0xAARRGGBB in the byte order of the file.
void convert_colour(const char* from, std::endian order, std::uint64_t count, float* to) {
    for (std::uint64_t i = 0; i < count; ++i) {
        const auto packed = bytes::load<std::uint32_t>(from + 4 * i, order);
        to[i] = luminance_of((packed >> 16) & 255, (packed >> 8) & 255, packed & 255);
    }
}

void convert_samples(const char* from, SampleType type, bool big_endian, std::uint64_t count, float* to) {
    const auto order = big_endian ? std::endian::big : std::endian::little;
    switch (type) {
        case SampleType::int8: return convert<std::int8_t>(from, order, count, to);
        case SampleType::uint8: return convert<std::uint8_t>(from, order, count, to);
        case SampleType::int16: return convert<std::int16_t>(from, order, count, to);
        case SampleType::uint16: return convert<std::uint16_t>(from, order, count, to);
        case SampleType::int32: return convert<std::int32_t>(from, order, count, to);
        case SampleType::uint32: return convert<std::uint32_t>(from, order, count, to);
        case SampleType::int64: return convert<std::int64_t>(from, order, count, to);
        case SampleType::uint64: return convert<std::uint64_t>(from, order, count, to);
        case SampleType::float32: return convert<float>(from, order, count, to);
        case SampleType::float64: return convert<double>(from, order, count, to);
        case SampleType::complex_int16: return convert_complex<std::int16_t>(from, order, count, to);
        case SampleType::complex_float32: return convert_complex<float>(from, order, count, to);
        case SampleType::complex_float64: return convert_complex<double>(from, order, count, to);
        case SampleType::bgra: return convert_colour(from, order, count, to);
        case SampleType::float16:
            for (std::uint64_t i = 0; i < count; ++i) to[i] = half(bytes::load<std::uint16_t>(from + 2 * i, order));
            return;
    }
    throw InternalError("a type of samples without a conversion");
}

}  // namespace

std::uint64_t bytes_of(SampleType type) {
    switch (type) {
        case SampleType::int8:
        case SampleType::uint8: return 1;
        case SampleType::int16:
        case SampleType::uint16:
        case SampleType::float16: return 2;
        case SampleType::int32:
        case SampleType::uint32:
        case SampleType::float32:
        case SampleType::complex_int16:
        case SampleType::bgra: return 4;
        case SampleType::int64:
        case SampleType::uint64:
        case SampleType::float64:
        case SampleType::complex_float32: return 8;
        case SampleType::complex_float64: return 16;
    }
    throw InternalError("a type of samples without a size");
}

bool is_complex(SampleType type) {
    return type == SampleType::complex_int16 || type == SampleType::complex_float32 ||
           type == SampleType::complex_float64;
}

FramePixels read_pixels(const bytes::Source& file, const RawPixels& layout) {
    const auto count = static_cast<std::uint64_t>(layout.size.width) * static_cast<std::uint64_t>(layout.size.height),
               unit = bytes_of(layout.type);
    if (layout.offset > file.size || count > (file.size - layout.offset) / unit)
        throw FormatError(
            file.name, {.offset = layout.offset},
            fmt::format("{} × {} pixels of {} bytes reach beyond the end of the file at byte {}; the file is truncated",
                        layout.size.width, layout.size.height, unit, file.size));
    FramePixels pixels(layout.size.height, layout.size.width);
    if (layout.type == SampleType::float32 && !layout.big_endian && std::endian::native == std::endian::little) {
        file.read_into(layout.offset, 4 * count, reinterpret_cast<char*>(pixels.data()));
        return pixels;
    }
    std::vector<char> block(std::min(block_bytes, count * unit));
    for (std::uint64_t done = 0; done < count;) {
        const auto some = std::min(count - done, block_bytes / unit);
        file.read_into(layout.offset + done * unit, some * unit, block.data());
        convert_samples(block.data(), layout.type, layout.big_endian, some, pixels.data() + done);
        done += some;
    }
    return pixels;
}

std::optional<FramePixels> pixels_in(std::string_view bytes, const RawPixels& layout, int channels) {
    const auto width = static_cast<std::uint64_t>(layout.size.width),
               samples = width * static_cast<std::uint64_t>(channels), row_bytes = samples * bytes_of(layout.type);
    const auto rows = static_cast<std::uint64_t>(layout.size.height);
    if (row_bytes == 0 || rows > bytes.size() / row_bytes) return std::nullopt;
    FramePixels pixels(layout.size.height, layout.size.width);
    std::vector<float> row(channels > 1 ? samples : 0);
    for (std::uint64_t i = 0; i < rows; ++i) {
        float* to = pixels.data() + i * width;
        convert_samples(bytes.data() + i * row_bytes, layout.type, layout.big_endian, samples,
                        channels > 1 ? row.data() : to);
        for (std::uint64_t j = 0; channels > 1 && j < width; ++j) {
            const float* at = row.data() + j * static_cast<std::uint64_t>(channels);
            to[j] = channels < 3 ? at[0]
                                 : luminance_of(static_cast<double>(at[0]), static_cast<double>(at[1]),
                                                static_cast<double>(at[2]));
        }
    }
    return pixels;
}

}  // namespace setae::imaging
