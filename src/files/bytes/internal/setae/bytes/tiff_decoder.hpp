// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "setae/bytes/source.hpp"

namespace setae::bytes {

/// Strips or tiles of a page for libtiff, and the numbers of rows and columns.
struct TiffPieces {
    std::uint64_t directory = 0;  ///< offset of the page's directory
    std::uint64_t nx = 0, ny = 0;
    std::uint64_t pixel_bytes = 1;  ///< of all samples of a pixel, stored together
    bool tiled = false;
    std::uint64_t piece_nx = 0, piece_ny = 0;  ///< of a strip or tile

    [[nodiscard]] std::uint64_t row_bytes() const { return nx * pixel_bytes; }
    [[nodiscard]] std::uint64_t bytes() const { return row_bytes() * ny; }
    [[nodiscard]] std::uint64_t across() const { return (nx + piece_nx - 1) / piece_nx; }
    [[nodiscard]] std::uint64_t down() const { return (ny + piece_ny - 1) / piece_ny; }
};

/// All rows of a page, expanded by libtiff, in native byte order. It uses at most `max_memory`.
/// @throws FormatError "<format>: …" at the directory or piece that cannot be expanded.
[[nodiscard]] std::string expanded_tiff(const Source& source, const std::string& format, const TiffPieces& pieces,
                                        std::uint64_t max_memory);

/// A page of 1 to 8 bits per sample in any colour space of libtiff, rows from the top: red in the lowest byte of a
/// pixel, green, blue and opacity above it. @throws as expanded_tiff.
[[nodiscard]] std::vector<std::uint32_t> tiff_colours(const Source& source, const std::string& format,
                                                      const TiffPieces& pieces, std::uint64_t max_memory);

}  // namespace setae::bytes
