// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/imaging/picture_content.hpp"

#include "avi_file.hpp"
#include "micrograph_file.hpp"
#include "picture.hpp"
#include "setae/bytes/source.hpp"
#include "setae/imaging/micrograph.hpp"
#include "tiff_stack.hpp"

namespace setae::imaging {
namespace {

PictureContent content_of_avi(const std::string& path) {
    const AviFile avi(path);
    const auto size = avi.picture_size();
    return {.format = "avi",
            .width = size.width,
            .height = size.height,
            .frames = avi.size(),
            .pixel_size = {},
            .frame_rate = avi.frame_rate()};
}

/// Pages as large as the first; thumbnails are smaller.
void count_frames(PictureContent& content, const std::string& path) {
    const TiffStack stack(path);
    content.frames = 0;
    for (std::size_t i = 0; i < stack.size(); ++i) content.frames += stack.size_of(i) == stack.size_of(0) ? 1 : 0;
    content.frame_rate = stack.frame_rate();
}

}  // namespace

std::optional<PictureContent> picture_content(const std::string& path) {
    const auto head = bytes::file_source(path).head(picture_head_bytes);
    if (is_avi(head)) return content_of_avi(path);
    if (!is_micrograph(head)) return std::nullopt;
    const auto micrograph = read_micrograph(path);
    PictureContent content{.format = micrograph.format,
                           .width = micrograph.pixels.cols(),
                           .height = micrograph.pixels.rows(),
                           .pixel_size = micrograph.pixel_size,
                           .frame_rate = {},
                           .instrument = micrograph.instrument,
                           .acquisition_time = micrograph.acquisition_time,
                           .images = micrograph.images,
                           .image = micrograph.image,
                           .alerts = micrograph.alerts};
    if (picture_kind(head) == PictureKind::tiff) count_frames(content, path);
    return content;
}

}  // namespace setae::imaging
