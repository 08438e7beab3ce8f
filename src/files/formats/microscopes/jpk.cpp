// SPDX-License-Identifier: GPL-3.0-or-later
#include "format_list.hpp"
#include "jpk_image.hpp"

namespace setae::formats {

Format jpk_format() {
    return {
        .identifier = "jpk",
        .name = "JPK image",
        .extensions = ".jpk",
        .description =
            "JPK Instruments (Bruker): TIFF whose private tags tell of the scan, one page a channel and direction of scanning",
        .heights =
            "multiplier times raw plus offset of the slot 'calibrated', else of the file's default slot; no point is undefined",
        .orientation = "rows stored from the bottom, turned; as stored where the grid is reflected",
        .not_read =
            "channels that are no heights are listed; heights in slots other than the one read, which the attributes name",
        .reference = "Gwyddion's module jpkscan, written by JPK Instruments, and TIFF 6.0",
        .tested_on_real_files = true,
        .carries_scale = true,
        .detect = [](std::string_view head,
                     const bytes::Source& source) { return detect_jpk_image(head, source, JpkImage::scan); },
        .open = [](const bytes::Source& source,
                   const ReadOptions& options) { return open_jpk_image(source, "jpk", options); }};
}

}  // namespace setae::formats
