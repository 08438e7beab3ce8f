// SPDX-License-Identifier: GPL-3.0-or-later
#include "format_list.hpp"
#include "jpk_image.hpp"

namespace setae::formats {

Format jpk_qi_format() {
    return {
        .identifier = "jpk-qi",
        .name = "JPK QI image",
        .extensions = ".jpk-qi-image .jpk-force-map-image",
        .description =
            "JPK Instruments (Bruker), quantitative imaging and force maps: the image made of the force curve of each pixel, TIFF as of JPK images",
        .heights =
            "multiplier times raw plus offset of the slot 'calibrated', else of the file's default slot; no point is undefined",
        .orientation = "rows stored from the bottom, turned; as stored where the grid is reflected",
        .not_read =
            "channels that are not heights (adhesion, slope, force) are listed; the curves themselves are "
            "in .jpk-qi-data",
        .reference = "Gwyddion's module jpkscan, written by JPK Instruments, and TIFF 6.0",
        .tested_on_real_files = true,
        .carries_scale = true,
        .detect = [](std::string_view head,
                     const bytes::Source& source) { return detect_jpk_image(head, source, JpkImage::force_curves); },
        .open = [](const bytes::Source& source,
                   const ReadOptions& options) { return open_jpk_image(source, "jpk-qi", options); }};
}

}  // namespace setae::formats
