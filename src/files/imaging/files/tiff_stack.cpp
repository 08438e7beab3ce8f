// SPDX-License-Identifier: GPL-3.0-or-later
#include "tiff_stack.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "micrograph_building.hpp"
#include "raw_pixels.hpp"
#include "setae/bytes/stored_numbers.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/number_text.hpp"
#include "setae/core/text.hpp"

namespace setae::imaging {
namespace {

namespace stack_tag {
constexpr std::uint16_t width = 256, height = 257, bits = 258, compression = 259, photometric = 262, description = 270,
                        strip_offsets = 273, samples = 277, rows_per_strip = 278, strip_bytes = 279, x_resolution = 282,
                        y_resolution = 283, planar = 284, resolution_unit = 296, tile_width = 322, tile_height = 323,
                        tile_offsets = 324, tile_bytes = 325, sample_format = 339;
}

constexpr std::size_t max_pages = 1'000'000;
constexpr std::uint64_t max_parts = 1U << 22;
constexpr std::uint64_t longest_side = 1U << 30;
constexpr std::uint64_t max_tile_pixels = 1U << 20;  // the decoder allocates a whole tile

std::optional<double> parsed(std::string_view text) {
    const auto value = leading<double>(text);
    return value && *value > 0 && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<SampleType> sample_type(std::uint64_t bits, std::uint64_t format) {
    switch (10 * bits + format) {
        case 81: return SampleType::uint8;
        case 82: return SampleType::int8;
        case 161: return SampleType::uint16;
        case 162: return SampleType::int16;
        case 163: return SampleType::float16;
        case 321: return SampleType::uint32;
        case 322: return SampleType::int32;
        case 323: return SampleType::float32;
        case 641: return SampleType::uint64;
        case 642: return SampleType::int64;
        case 643: return SampleType::float64;
        default: return std::nullopt;
    }
}

/// Memory limit of libtiff: a picture, its compressed bytes, and a margin.
std::uint64_t memory_for(const bytes::TiffPieces& pieces, std::uint64_t file_bytes) {
    return 4 * pieces.nx * pieces.ny + pieces.bytes() + file_bytes + (std::uint64_t{1} << 26);
}

}  // namespace

TiffStack::TiffStack(const bytes::Source& source)
    : file_(bytes::open_tiff(source, "TIFF", max_pages, bytes::Damage::noted)), pages_(file_.pages.size()) {
    if (auto text = file_.text(file_.pages.front(), stack_tag::description); text.starts_with("ImageJ="))
        description_ = "\n" + std::move(text);
    count_pages_without_directory();
}

/// Bytes of a picture that is not compressed.
std::uint64_t TiffStack::picture_bytes() const {
    const auto& page = file_.pages.front();
    const auto size = size_of(0);
    return static_cast<std::uint64_t>(size.width) * static_cast<std::uint64_t>(size.height) *
           number(page, stack_tag::samples).value_or(1) * number(page, stack_tag::bits).value_or(1) / 8;
}

void TiffStack::count_pages_without_directory() {
    const auto images = description("images");
    const auto count = images ? parsed(*images) : std::nullopt;
    if (!count || *count <= static_cast<double>(pages_) || *count > static_cast<double>(max_pages)) return;
    const auto& first = file_.pages.front();
    if (pages_ == 1 && number(first, stack_tag::compression).value_or(1) == 1 && picture_bytes() > 0)
        first_pixel_ = file_.number(first, stack_tag::strip_offsets);
    pages_ = static_cast<std::size_t>(std::ceil(*count));
}

const bytes::TiffPage& TiffStack::page(std::size_t index) const {
    return file_.pages[index < file_.pages.size() ? index : 0];
}

std::optional<std::uint64_t> TiffStack::number(const bytes::TiffPage& page, std::uint16_t stack_tag) const {
    const auto value = file_.number(page, stack_tag);
    return value && *value >= 0 && *value < 0x1p63 ? std::optional(static_cast<std::uint64_t>(*value)) : std::nullopt;
}

std::optional<double> TiffStack::real(const bytes::TiffPage& page, std::uint16_t stack_tag) const {
    const auto value = file_.number(page, stack_tag);
    return value && std::isfinite(*value) ? value : std::nullopt;
}

PictureSize TiffStack::size_of(std::size_t index) const {
    const auto width = number(page(index), stack_tag::width).value_or(0),
               height = number(page(index), stack_tag::height).value_or(0);
    if (width > longest_side || height > longest_side) return {};
    return {static_cast<long>(width), static_cast<long>(height)};
}

std::optional<std::string> TiffStack::description(const std::string& key) const {
    const auto at = description_.find("\n" + key + "=");
    if (at == std::string::npos) return std::nullopt;
    const auto begin = at + key.size() + 2;
    return std::string(trimmed(std::string_view(description_).substr(begin, description_.find('\n', begin) - begin)));
}

std::optional<double> TiffStack::pixel_size() const {
    const auto& page = file_.pages.front();
    const auto resolution = [&](std::uint16_t stack_tag) {
        const auto value = real(page, stack_tag);
        return value && *value > 0 ? value : std::nullopt;
    };
    const auto x = resolution(stack_tag::x_resolution), y = resolution(stack_tag::y_resolution);
    if (!x) return std::nullopt;
    const auto stated = description("unit");
    const auto tag_unit = number(page, stack_tag::resolution_unit).value_or(2);
    std::optional<double> unit = stated          ? metres_of(*stated)
                                 : tag_unit == 2 ? std::optional(0.0254)
                                 : tag_unit == 3 ? std::optional(0.01)
                                                 : std::nullopt;
    if (!unit) return std::nullopt;
    const double size = *unit / *x;
    if (!stated && size > coarsest_pixel) return std::nullopt;
    if (y && std::abs(*y / *x - 1.0) > 1e-3)
        throw InvalidArgument(fmt::format(
            "{}: pixels are {:.6g} m wide and {:.6g} m high; a contact radius needs square pixels: resample "
            "the frames",
            file_.source.name, size, *unit / *y));
    return size;
}

std::optional<double> TiffStack::frame_rate() const {
    if (const auto rate = description("fps"))
        if (const auto value = parsed(*rate)) return value;
    if (const auto interval = description("finterval"))
        if (const auto value = parsed(*interval)) return 1.0 / *value;
    return std::nullopt;
}

std::string TiffStack::fault(std::size_t index) const {
    if (index < file_.pages.size()) return file_.pages[index].fault;
    const bool there = first_pixel_ && *first_pixel_ + index * picture_bytes() < file_.source.size;
    return there ? ""
                 : fmt::format("ImageJ announces {} images, but the file contains fewer; it is truncated",
                               description("images").value_or(""));
}

std::vector<TiffStack::Part> TiffStack::parts(std::size_t index, std::string& fault) const {
    std::vector<Part> parts;
    const auto bytes = file_.source.size;
    if (first_pixel_) {
        parts.push_back({*first_pixel_ + index * picture_bytes(), picture_bytes()});
    } else {
        const auto& page = file_.pages[index];
        const bool tiled = page.find(stack_tag::tile_offsets) != nullptr;
        const auto offsets =
                       file_.integers(page, tiled ? stack_tag::tile_offsets : stack_tag::strip_offsets, max_parts),
                   counts = file_.integers(page, tiled ? stack_tag::tile_bytes : stack_tag::strip_bytes, max_parts);
        if (offsets.empty() || counts.size() < offsets.size())
            fault = offsets.empty() || counts.empty() ? "its directory names no pixels; the file is damaged"
                                                      : "its directory is incomplete; the file is damaged";
        std::uint64_t total = 0;
        for (std::size_t i = 0; i < offsets.size() && fault.empty(); ++i) {
            total += std::min(counts[i], bytes);
            if (total > bytes) fault = "truncated or damaged: it announces more pixels than the file has bytes for";
            parts.push_back({offsets[i], counts[i]});
        }
    }
    if (!fault.empty()) return {};
    for (const auto& part : parts) {
        const auto there = bytes - std::min(part.offset, bytes);
        if (there >= part.bytes) continue;
        fault = fmt::format("truncated: {} of {} bytes of pixels at byte {}", there, part.bytes, part.offset);
        return {};
    }
    return parts;
}

/// Grey levels of pixels of at most 8 bits in any colours.
FrameRead TiffStack::colours(const bytes::TiffPieces& pieces) const {
    const auto words = bytes::tiff_colours(file_.source, "TIFF", pieces, memory_for(pieces, file_.source.size));
    FramePixels pixels(static_cast<long>(pieces.ny), static_cast<long>(pieces.nx));
    for (std::size_t i = 0; i < words.size(); ++i)
        pixels.data()[i] = luminance_of(words[i] & 255, (words[i] >> 8) & 255, (words[i] >> 16) & 255);
    return {std::move(pixels), {}};
}

FrameRead TiffStack::read(std::size_t index) const {
    auto fault = this->fault(index);
    if (!fault.empty()) return {{}, fault};
    const auto& page = this->page(index);
    const auto size = size_of(index);
    if (size.width <= 0 || size.height <= 0) return {{}, "its directory states no size; the file is damaged"};
    const auto places = parts(index, fault);
    if (!fault.empty()) return {{}, fault};
    const auto channels = number(page, stack_tag::samples).value_or(1),
               bits = number(page, stack_tag::bits).value_or(1),
               photometric = number(page, stack_tag::photometric).value_or(1);
    const bool tiled = page.find(stack_tag::tile_offsets) != nullptr,
               raw = number(page, stack_tag::compression).value_or(1) == 1 && !tiled;
    const auto type = sample_type(bits, number(page, stack_tag::sample_format).value_or(1));
    const bool interleaved =
        channels >= 1 && channels <= 4 && (channels == 1 || number(page, stack_tag::planar).value_or(1) == 1);
    RawPixels layout{.big_endian = file_.order == std::endian::big, .size = size};
    std::string values;
    if (raw && type && interleaved && photometric <= 2) {
        for (const auto& part : places) values += file_.source.bytes(part.offset, part.bytes);
        layout.type = *type;
    } else {
        bytes::TiffPieces pieces{.directory = page.offset,
                                 .nx = static_cast<std::uint64_t>(size.width),
                                 .ny = static_cast<std::uint64_t>(size.height),
                                 .tiled = tiled};
        pieces.piece_nx = tiled ? number(page, stack_tag::tile_width).value_or(0) : pieces.nx;
        pieces.piece_ny = tiled ? number(page, stack_tag::tile_height).value_or(0)
                                : std::min(number(page, stack_tag::rows_per_strip).value_or(pieces.ny), pieces.ny);
        if (pieces.piece_nx == 0 || pieces.piece_ny == 0 ||
            (tiled && (pieces.piece_nx > max_tile_pixels || pieces.piece_ny > max_tile_pixels / pieces.piece_nx)))
            return {{}, fmt::format("tiles of {} × {} pixels; the file is damaged", pieces.piece_nx, pieces.piece_ny)};
        if (bits <= 8) return colours(pieces);
        if (!type || !interleaved)
            return {{}, fmt::format("{} numbers of {} bits per pixel, which is not a picture", channels, bits)};
        pieces.pixel_bytes = channels * bytes_of(*type);
        values = bytes::expanded_tiff(file_.source, "TIFF", pieces, memory_for(pieces, file_.source.size));
        layout.type = *type;
        layout.big_endian = std::endian::native == std::endian::big;
    }
    auto pixels = pixels_in(values, layout, static_cast<int>(channels));
    if (!pixels)
        return {{},
                fmt::format("truncated: {} of {} bytes of pixels", values.size(),
                            static_cast<std::uint64_t>(size.width) * static_cast<std::uint64_t>(size.height) *
                                channels * bits / 8)};
    FrameRead frame{std::move(*pixels), {}};
    if (photometric == 0) frame.pixels = frame.pixels.maxCoeff() - frame.pixels;  // white is 0
    return frame;
}

}  // namespace setae::imaging
