// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "setae/bytes/source.hpp"

namespace setae::bytes {

/// An entry of a TIFF directory: the place of its values in the file. Private tags are ordinary entries.
struct TiffTag {
    std::uint16_t id = 0;
    std::uint16_t type = 0;    ///< of TIFF 6.0: 1 byte, 2 text, 3 short, 4 long, 12 double …
    std::uint64_t count = 0;   ///< values
    std::uint64_t offset = 0;  ///< of the first value, in the file
    /// the values themselves, if they fit into the entry
    std::optional<std::array<char, 8>> here = {};

    [[nodiscard]] std::uint64_t bytes() const;
};

struct TiffPage {
    std::uint64_t offset = 0;  ///< of its directory
    std::vector<TiffTag> tags;
    std::string fault = {};  ///< why the directory cannot be read, if reading of pages continues
    std::string lost = {};   ///< why a tag, which is left out, cannot be read

    [[nodiscard]] const TiffTag* find(std::uint16_t id) const;
};

/// The directories of a TIFF or BigTIFF file of either byte order. Values, pixels and content of private tags are read
/// from the file on request.
struct TiffFile {
    Source source;
    std::string format;  ///< begins messages
    std::endian order = std::endian::little;
    std::vector<TiffPage> pages;

    /// The first number of a tag; empty if the page lacks the tag or it is no number.
    [[nodiscard]] std::optional<double> number(const TiffPage& page, std::uint16_t id) const;
    /// All numbers of a tag. @throws FormatError for more than `most`.
    [[nodiscard]] std::vector<std::uint64_t> integers(const TiffPage& page, std::uint16_t id, std::uint64_t most) const;
    /// The bytes of a tag as text, at most the first MiB; empty if there is none.
    [[nodiscard]] std::string text(const TiffPage& page, std::uint16_t id) const;
    /// The directory that a tag points to, such as that of Exif. @throws FormatError if it violates the format or there
    /// is no such tag.
    [[nodiscard]] TiffPage directory_of(const TiffPage& page, std::uint16_t id) const;
};

[[nodiscard]] bool is_tiff(std::string_view head);

/// Treatment of a damaged directory, or of a tag whose values are beyond the end of the file: an error, or a note in
/// the page, which is then the last one.
enum class Damage { refused, noted };

/// The directories, or the first `max_pages` of them.
/// @throws FormatError "<format>: …" with offset if a directory or the values of a tag are beyond the end of the file,
/// directories form a loop, or are too many for the size of the file.
[[nodiscard]] TiffFile open_tiff(const Source& source, const std::string& format,
                                 std::size_t max_pages = std::numeric_limits<std::size_t>::max(),
                                 Damage damage = Damage::refused);

}  // namespace setae::bytes
