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

/// An entry of a TIFF directory: where its values lie in the file. Private tags are entries as others.
struct TiffTag {
    std::uint16_t id = 0;
    std::uint16_t type = 0;    ///< of TIFF 6.0: 1 byte, 2 text, 3 short, 4 long, 12 double …
    std::uint64_t count = 0;   ///< values
    std::uint64_t offset = 0;  ///< of the first value, in the file
    /// the values themselves, where they have room in the entry
    std::optional<std::array<char, 8>> here = {};

    [[nodiscard]] std::uint64_t bytes() const;
};

struct TiffPage {
    std::uint64_t offset = 0;  ///< of its directory
    std::vector<TiffTag> tags;
    std::string fault = {};  ///< why the directory cannot be read, where pages go on being asked for
    std::string lost = {};   ///< the same of a tag, which is left out

    [[nodiscard]] const TiffTag* find(std::uint16_t id) const;
};

/// The directories of a TIFF or BigTIFF file of either byte order. Values, pixels and what private tags hold stay in
/// the file until asked for.
struct TiffFile {
    Source source;
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

/// What a damaged directory, or a tag whose values lie beyond the end of the file, does: it is refused, or noted in its
/// page, where directories then end.
enum class Damage { refused, noted };

/// The directories, or the first `max_pages` of them.
/// @throws FormatError "<format>: …" with offset where a directory or the values of a tag lie beyond the end of the
/// file, or directories form a loop, or are more than the file has bytes for.
[[nodiscard]] TiffFile open_tiff(const Source& source, const std::string& format,
                                 std::size_t max_pages = std::numeric_limits<std::size_t>::max(),
                                 Damage damage = Damage::refused);

}  // namespace setae::bytes
