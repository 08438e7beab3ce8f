// SPDX-License-Identifier: GPL-3.0-or-later
#include <tiffio.h>

#include <algorithm>

#include <fmt/format.h>

#include "setae/bytes/expand.hpp"
#include "setae/bytes/expanded_source.hpp"
#include "setae/bytes/tiff_decoder.hpp"
#include "setae/core/errors.hpp"
#include "tiff_pixels.hpp"

namespace setae::formats {
namespace {

constexpr std::uint64_t max_pieces = 1 << 22;
constexpr std::uint64_t allocation_floor = 1 << 24;  ///< minimum limit of memory for libtiff

/// Data needed to find and expand the pixels of a page.
struct Layout {
    bytes::TiffPieces pieces;
    Sample sample = Sample::uint8;
    std::uint64_t compression = 1;
    std::vector<std::uint64_t> offsets, byte_counts;
};

[[noreturn]] void broken(const bytes::TiffFile& file, std::uint64_t offset, const std::string& what) {
    throw FormatError(file.source.name, {.offset = offset}, fmt::format("{}: {}", file.format, what));
}

std::uint64_t entry(const bytes::TiffFile& file, const bytes::TiffPage& page, std::uint16_t id,
                    std::uint64_t fallback) {
    const auto values = file.integers(page, id, max_pieces);
    return values.empty() ? fallback : values.front();
}

Sample sample_of(const bytes::TiffFile& file, const bytes::TiffPage& page) {
    const auto bits = entry(file, page, TIFFTAG_BITSPERSAMPLE, 1),
               kind = entry(file, page, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_UINT),
               samples = entry(file, page, TIFFTAG_SAMPLESPERPIXEL, 1);
    if (samples != 1) broken(file, page.offset, fmt::format("{} samples per pixel, expected one", samples));
    switch (1000 * kind + bits) {
        case 1000 * SAMPLEFORMAT_UINT + 8: return Sample::uint8;
        case 1000 * SAMPLEFORMAT_UINT + 16: return Sample::uint16;
        case 1000 * SAMPLEFORMAT_UINT + 32: return Sample::uint32;
        case 1000 * SAMPLEFORMAT_INT + 8: return Sample::int8;
        case 1000 * SAMPLEFORMAT_INT + 16: return Sample::int16;
        case 1000 * SAMPLEFORMAT_INT + 32: return Sample::int32;
        case 1000 * SAMPLEFORMAT_IEEEFP + 32: return Sample::float32;
        case 1000 * SAMPLEFORMAT_IEEEFP + 64: return Sample::float64;
        default:
            broken(
                file, page.offset,
                fmt::format(
                    "pixels of {} bits in sample format {}, expected integers of 8, 16 or 32 bits or floats of 32 or 64",
                    bits, kind));
    }
}

Layout layout_of(const bytes::TiffFile& file, const bytes::TiffPage& page) {
    Layout layout{.sample = sample_of(file, page),
                  .compression = entry(file, page, TIFFTAG_COMPRESSION, COMPRESSION_NONE)};
    const auto width = entry(file, page, TIFFTAG_IMAGEWIDTH, 0), height = entry(file, page, TIFFTAG_IMAGELENGTH, 0);
    if (width == 0 || height == 0 || width > (1u << 30) || height > (1u << 30))
        broken(file, page.offset, fmt::format("a page of {} × {} pixels", width, height));
    const bool tiled = page.find(TIFFTAG_TILEWIDTH) != nullptr;
    layout.pieces = {.directory = page.offset,
                     .nx = width,
                     .ny = height,
                     .pixel_bytes = bytes_of(layout.sample),
                     .tiled = tiled,
                     .piece_nx = tiled ? entry(file, page, TIFFTAG_TILEWIDTH, 0) : width,
                     .piece_ny = tiled ? entry(file, page, TIFFTAG_TILELENGTH, 0)
                                       : std::min(entry(file, page, TIFFTAG_ROWSPERSTRIP, height), height)};
    layout.offsets = file.integers(page, tiled ? TIFFTAG_TILEOFFSETS : TIFFTAG_STRIPOFFSETS, max_pieces);
    layout.byte_counts = file.integers(page, tiled ? TIFFTAG_TILEBYTECOUNTS : TIFFTAG_STRIPBYTECOUNTS, max_pieces);
    const auto nx = layout.pieces.piece_nx, ny = layout.pieces.piece_ny;
    if (nx == 0 || ny == 0 || nx > (1u << 30) || ny > (1u << 30))
        broken(file, page.offset, fmt::format("pieces of {} × {} pixels", nx, ny));
    return layout;
}

/// Refuses pieces that are not in the file, are too few, or state an implausible size.
void require_pieces(const bytes::TiffFile& file, const Layout& layout) {
    const auto needed = layout.pieces.across() * layout.pieces.down();
    if (layout.offsets.size() < needed || layout.byte_counts.size() < needed)
        broken(file, layout.pieces.directory,
               fmt::format("{} of the {} strips or tiles of {} × {} pixels are present",
                           std::min(layout.offsets.size(), layout.byte_counts.size()), needed, layout.pieces.nx,
                           layout.pieces.ny));
    std::uint64_t stored = 0;
    for (std::size_t k = 0; k < needed; ++k) {
        if (layout.offsets[k] > file.source.size || layout.byte_counts[k] > file.source.size - layout.offsets[k])
            broken(file, file.source.size,
                   fmt::format("the file ends here, expected the end of a strip or tile at byte {}; it is truncated",
                               layout.offsets[k] + layout.byte_counts[k]));
        stored += layout.byte_counts[k];
    }
    stored = std::min(stored, file.source.size);
    // pixels become heights of 8 bytes: those of one byte count as two
    const auto width = std::max<std::uint64_t>(bytes_of(layout.sample), 2);
    const auto announced =
        width * std::max(layout.pieces.nx * layout.pieces.ny, layout.pieces.piece_nx * layout.pieces.piece_ny);
    if (announced > bytes::max_expanded(stored))
        broken(file, layout.pieces.directory,
               fmt::format("{} bytes of strips or tiles announce {} × {} pixels; it is damaged", stored,
                           layout.pieces.nx, layout.pieces.ny));
}

/// Whether rows are stored uncompressed and contiguous.
bool side_by_side(const Layout& layout) {
    if (layout.compression != COMPRESSION_NONE || layout.pieces.tiled) return false;
    const auto strip_bytes = layout.pieces.row_bytes() * layout.pieces.piece_ny;
    std::uint64_t left = layout.pieces.bytes();
    for (std::size_t k = 0; k < layout.pieces.down(); ++k) {
        const auto bytes = std::min(left, strip_bytes);
        if (layout.byte_counts[k] < bytes || (k > 0 && layout.offsets[k] != layout.offsets[k - 1] + strip_bytes))
            return false;
        left -= bytes;
    }
    return true;
}

}  // namespace

TiffPixels tiff_pixels(const bytes::TiffFile& file, const bytes::TiffPage& page) {
    const auto layout = layout_of(file, page);
    require_pieces(file, layout);
    Raster raster{.nx = static_cast<Index>(layout.pieces.nx),
                  .ny = static_cast<Index>(layout.pieces.ny),
                  .sample = layout.sample};
    if (side_by_side(layout)) {
        raster.offset = layout.offsets.front();
        raster.order = file.order;
        return {file.source, raster};
    }
    raster.order = std::endian::native;
    // the reader of pixels does not keep the directories: a file may have many pages
    return {bytes::expanded_source(file.source.name, layout.pieces.bytes(),
                                   [source = file.source, format = file.format, pieces = layout.pieces] {
                                       return bytes::expanded_tiff(source, format, pieces,
                                                                   2 * source.size + allocation_floor);
                                   }),
            raster};
}

void refuse_tiff(const bytes::Source& source) {
    (void)bytes::open_tiff(source, "TIFF");
    throw FormatError(source.name, {.offset = 0},
                      "a TIFF picture without the tags in which JPK, Park Systems and Olympus LEXT store heights; "
                      "`setae contour` traces outlines in pictures; heights exported as grey values have lost their "
                      "scale: export the original format of the instrument");
}

}  // namespace setae::formats
