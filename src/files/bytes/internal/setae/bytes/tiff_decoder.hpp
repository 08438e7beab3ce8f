// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "setae/bytes/source.hpp"

namespace setae::bytes {

/// Where libtiff finds the strips or tiles of a page, and how many rows and columns it has.
struct TiffPieces {
    std::uint64_t directory = 0;  ///< offset of the page's directory
    std::uint64_t nx = 0, ny = 0;
    std::uint64_t pixel_bytes = 1;  ///< of all samples of a pixel, one beside the other
    bool tiled = false;
    std::uint64_t piece_nx = 0, piece_ny = 0;  ///< of a strip or tile

    [[nodiscard]] std::uint64_t row_bytes() const { return nx * pixel_bytes; }
    [[nodiscard]] std::uint64_t bytes() const { return row_bytes() * ny; }
    [[nodiscard]] std::uint64_t across() const { return (nx + piece_nx - 1) / piece_nx; }
    [[nodiscard]] std::uint64_t down() const { return (ny + piece_ny - 1) / piece_ny; }
};

/// All rows of a page, expanded by libtiff, in the byte order of this machine. It may take `max_memory` at once.
/// @throws FormatError "<format>: …" at the directory or piece that cannot be expanded.
[[nodiscard]] std::string expanded_tiff(const Source& source, const std::string& format, const TiffPieces& pieces,
                                        std::uint64_t max_memory);

/// A page of 1 to 8 bits a sample in any colours libtiff knows, rows from the top: red in the lowest byte of a pixel,
/// green, blue and opacity above it. @throws as expanded_tiff.
[[nodiscard]] std::vector<std::uint32_t> tiff_colours(const Source& source, const std::string& format,
                                                      const TiffPieces& pieces, std::uint64_t max_memory);

}  // namespace setae::bytes
