// SPDX-License-Identifier: GPL-3.0-or-later
#include "plain_picture.hpp"

#include "micrograph_building.hpp"
#include "picture.hpp"
#include "png_chunks.hpp"
#include "setae/bytes/stored_numbers.hpp"
#include "setae/core/errors.hpp"

namespace setae::imaging {
namespace {

/// Width and height of a pixel by the chunk pHYs. Source: PNG specification (third edition), 11.3.4.3.
std::optional<PixelSize> png_pixel_size(std::string_view bytes) {
    const auto chunk = png_chunk(bytes, "pHYs");
    if (chunk.size() != 9 || chunk[8] != 1) return std::nullopt;  // 1: per metre
    const auto x = bytes::number_in(chunk, 0, 4, true), y = bytes::number_in(chunk, 4, 4, true);
    if (x == 0 || y == 0) return std::nullopt;
    return PixelSize{1.0 / static_cast<double>(x), 1.0 / static_cast<double>(y)};
}

std::string format_of(PictureKind kind) {
    return kind == PictureKind::png ? "png" : kind == PictureKind::jpeg ? "jpeg" : "bmp";
}

}  // namespace

Micrograph read_plain_picture(const bytes::Source& file, const MicrographOptions& options) {
    const auto bytes = file.all();
    auto micrograph = unread_micrograph(file, format_of(picture_kind(bytes)));
    (void)choose_image(micrograph, 1, options);
    const auto stated = stated_size(bytes);
    if (!stated || stated->width <= 0 || stated->height <= 0)
        throw FormatError(file.name, {.offset = 0},
                          "the header of the picture states no size; the file is truncated or damaged");
    const auto size = picture_size(file, 0, static_cast<std::uint64_t>(stated->width),
                                   static_cast<std::uint64_t>(stated->height), options);
    auto frame = decoded_picture(bytes);
    if (!frame.fault.empty()) throw FormatError(file.name, {.offset = bytes.size()}, frame.fault);
    if (frame.pixels.cols() != size.width || frame.pixels.rows() != size.height)
        throw FormatError(file.name, {.offset = 0},
                          "the decoded picture has another size than its header states; the file is damaged");
    micrograph.pixels = std::move(frame.pixels);
    if (micrograph.format == "png")
        if (const auto pixel = png_pixel_size(bytes); pixel && pixel->x < coarsest_pixel && pixel->y < coarsest_pixel)
            set_pixel_size(micrograph, {pixel->x, "m"}, {pixel->y, "m"}, "PNG pHYs");
    return micrograph;
}

}  // namespace setae::imaging
