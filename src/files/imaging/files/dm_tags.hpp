// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "setae/bytes/source.hpp"

namespace setae::imaging {

/// A tag: a group of tags, a number, a text, or numbers that remain in the file.
struct DmTag {
    std::string name;         ///< empty for members of a list
    std::vector<DmTag> tags;  ///< of a group
    std::optional<double> number;
    std::string text;          ///< a string, or an array of 16-bit numbers short enough for one
    std::uint64_t offset = 0;  ///< of its data in the file; for a group, of its first tag
    std::uint64_t bytes = 0;   ///< of an array, a string or a structure

    /// The tag at a path such as "ImageData/Calibrations", members of lists by index from 0; nullptr if there is none.
    [[nodiscard]] const DmTag* find(std::string_view path) const;
    [[nodiscard]] std::optional<double> number_at(std::string_view path) const;
    [[nodiscard]] std::string text_at(std::string_view path) const;  ///< empty if there is none
};

/// The tags of a DigitalMicrograph file.
struct DmTags {
    int version = 3;          ///< 3 or 4
    bool big_endian = false;  ///< byte order of data; the tree itself is always big endian
    DmTag root;
};

/// Whether bytes begin as a DM3 or DM4.
[[nodiscard]] bool is_dm(std::string_view head);

/// Reads the tree; arrays are not read. Depth, counts and sizes are checked against the file before memory is
/// allocated. @throws FormatError with the offset of the damage.
/// Source: no public specification; B. Schaffer, "How to read DigitalMicrograph file-format" (2014), as in openNCEM and
/// RosettaSciIO.
[[nodiscard]] DmTags read_dm_tags(const bytes::Source& file);

}  // namespace setae::imaging
