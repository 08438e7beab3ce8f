// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture.hpp"

#include <fmt/format.h>

#include "picture_decoders.hpp"
#include "png_chunks.hpp"
#include "setae/bytes/source.hpp"
#include "setae/bytes/stored_numbers.hpp"

namespace setae::imaging {
namespace {

std::optional<PictureSize> jpeg_size(std::string_view bytes) {
    std::size_t at = 2;
    while (at + 9 < bytes.size()) {
        if (static_cast<unsigned char>(bytes[at]) != 0xFF) return std::nullopt;
        const auto marker = static_cast<unsigned char>(bytes[at + 1]);
        if (marker == 0xFF) {
            ++at;  // fill byte
            continue;
        }
        const bool start_of_frame =
            marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
        if (start_of_frame)
            return PictureSize{static_cast<long>(bytes::number_in(bytes, at + 7, 2, true)),
                               static_cast<long>(bytes::number_in(bytes, at + 5, 2, true))};
        at += 2 + bytes::number_in(bytes, at + 2, 2, true);
    }
    return std::nullopt;
}

/// Whether a picture ends as defined by its format; decoders fill missing data with grey.
bool ends_whole(std::string_view bytes) {
    switch (picture_kind(bytes)) {
        case PictureKind::png: return png_is_whole(bytes);
        case PictureKind::jpeg: return bytes.rfind("\xFF\xD9") != std::string_view::npos;
        case PictureKind::bmp: return bytes.size() >= bytes::number_in(bytes, 2, 4);
        default: return true;
    }
}

}  // namespace

PictureKind picture_kind(std::string_view head) {
    using namespace std::string_view_literals;
    if (head.starts_with("\x89PNG\r\n\x1A\n"sv)) return PictureKind::png;
    if (head.starts_with("\xFF\xD8\xFF"sv)) return PictureKind::jpeg;
    if (head.starts_with("BM"sv) && head.size() > 26) return PictureKind::bmp;
    if (head.starts_with("II*\0"sv) || head.starts_with("MM\0*"sv) || head.starts_with("II+\0"sv) ||
        head.starts_with("MM\0+"sv))
        return PictureKind::tiff;
    return PictureKind::none;
}

std::optional<PictureSize> stated_size(std::string_view bytes) {
    switch (picture_kind(bytes)) {
        case PictureKind::png:
            if (bytes.size() < 24) return std::nullopt;
            return PictureSize{static_cast<long>(bytes::number_in(bytes, 16, 4, true)),
                               static_cast<long>(bytes::number_in(bytes, 20, 4, true))};
        case PictureKind::bmp: {
            if (bytes::number_in(bytes, 14, 4) == 12)  // as in OS/2
                return PictureSize{static_cast<long>(bytes::number_in(bytes, 18, 2)),
                                   static_cast<long>(bytes::number_in(bytes, 20, 2))};
            const auto height = static_cast<std::int32_t>(bytes::number_in(bytes, 22, 4));
            return PictureSize{static_cast<std::int32_t>(bytes::number_in(bytes, 18, 4)),
                               height < 0 ? -static_cast<long>(height) : height};
        }
        case PictureKind::jpeg: return jpeg_size(bytes);
        default: return std::nullopt;
    }
}

FrameRead decoded_picture(std::string_view bytes) {
    if (!ends_whole(bytes))
        return {{},
                fmt::format("truncated or damaged: {} bytes without the end that the format requires", bytes.size())};
    const auto size = stated_size(bytes);
    if (!size || size->width <= 0 || size->height <= 0) return {{}, "its header states no size; the file is damaged"};
    switch (picture_kind(bytes)) {
        case PictureKind::png: return decoded_png(bytes, *size);
        case PictureKind::jpeg: return decoded_jpeg(bytes, *size);
        default: return decoded_bmp(bytes, *size);
    }
}

}  // namespace setae::imaging
