// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "raster.hpp"
#include "setae/bytes/source.hpp"
#include "setae/formats/channel.hpp"

namespace setae::formats {

/// An entry of a TIFF directory: where its values lie in the file. Private tags are entries as others.
struct TiffTag {
    std::uint16_t id = 0;
    std::uint16_t type = 0;    ///< of TIFF 6.0: 1 byte, 2 text, 3 short, 4 long, 12 double …
    std::uint64_t count = 0;   ///< values
    std::uint64_t offset = 0;  ///< of the first value, in the file

    [[nodiscard]] std::uint64_t bytes() const;
};

struct TiffPage {
    std::uint64_t offset = 0;  ///< of its directory
    std::vector<TiffTag> tags;

    [[nodiscard]] const TiffTag* find(std::uint16_t id) const;
};

/// The directories of a TIFF or BigTIFF file of either byte order. Values, pixels and what private tags hold stay in
/// the file until asked for.
struct TiffFile {
    bytes::Source source;
    std::string format;  ///< begins messages
    std::endian order = std::endian::little;
    std::vector<TiffPage> pages;

    /// The first number of a tag; nothing where the page has none or it is no number.
    [[nodiscard]] std::optional<double> number(const TiffPage& page, std::uint16_t id) const;
    /// All numbers of a tag. @throws FormatError for more than `most`.
    [[nodiscard]] std::vector<std::uint64_t> integers(const TiffPage& page, std::uint16_t id, std::uint64_t most) const;
    /// A tag's bytes as text, of which the first MiB is read; empty where there is none.
    [[nodiscard]] std::string text(const TiffPage& page, std::uint16_t id) const;
    /// The directory a tag points to, such as Exif's. @throws FormatError where it breaks the format or there is no
    /// such tag.
    [[nodiscard]] TiffPage directory_of(const TiffPage& page, std::uint16_t id) const;
};

[[nodiscard]] bool is_tiff(std::string_view head);

/// The directories, or the first `most_pages` of them.
/// @throws FormatError "<format>: …" with offset where a directory or the values of a tag lie beyond the end of the
/// file, or directories form a loop.
[[nodiscard]] TiffFile open_tiff(const bytes::Source& source, const std::string& format,
                                 std::size_t most_pages = std::numeric_limits<std::size_t>::max());

/// Why a TIFF file is none of the formats that keep heights in TIFF: it is damaged, or a picture. @throws FormatError
/// always.
[[noreturn]] void refuse_tiff(const bytes::Source& source);

/// Where the samples of a page lie. Strips side by side and not compressed are a raster of the file itself, read where
/// asked; all others become a source in memory that libtiff expands at its first read.
struct TiffPixels {
    bytes::Source source;
    Raster raster;
};

/// Pixels of one sample each. @throws FormatError for several samples a pixel, a type that is no number of 1, 2, 4 or 8
/// bytes, strips or tiles beyond the end of the file or fewer than the page needs, or a page that announces more than
/// most_expanded of its bytes.
[[nodiscard]] TiffPixels tiff_pixels(const TiffFile& file, const TiffPage& page);

}  // namespace setae::formats
