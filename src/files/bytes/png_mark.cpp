// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/bytes/png_mark.hpp"

namespace setae::bytes {
namespace {

constexpr std::string_view png_signature("\x89PNG\r\n\x1a\n", 8);
constexpr std::size_t first_chunk = 25;  ///< IHDR: length, kind, 13 bytes, checksum
/// Length, kind, "Software", 0, "setae" and the checksum of all but the length.
constexpr std::string_view png_mark(
    "\0\0\0\x0e"
    "tEXtSoftware\0setae"
    "\x08\x1e\x88\x11",
    26);

}  // namespace

std::string with_png_mark(std::string png) {
    if (png.starts_with(png_signature) && png.size() > png_signature.size() + first_chunk && !has_png_mark(png))
        png.insert(png_signature.size() + first_chunk, png_mark);
    return png;
}

bool has_png_mark(std::string_view head) {
    return head.starts_with(png_signature) && head.size() > png_signature.size() + first_chunk &&
           head.substr(png_signature.size() + first_chunk).starts_with(png_mark);
}

}  // namespace setae::bytes
