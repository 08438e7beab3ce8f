// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "setae/bytes/source.hpp"

namespace setae::imaging {

/// A tag: a group of tags, a number, a text, or numbers that are left in the file.
struct DmTag {
    std::string name;         ///< empty for members of a list
    std::vector<DmTag> tags;  ///< of a group
    std::optional<double> number;
    std::string text;          ///< a string, or an array of 16-bit numbers short enough for one
    std::uint64_t offset = 0;  ///< of its data in the file; of a group's, of its first tag
    std::uint64_t bytes = 0;   ///< of an array, a string or a structure

    /// The tag at a path such as "ImageData/Calibrations", members of lists by their place from 0; nullptr where there
    /// is none.
    [[nodiscard]] const DmTag* find(std::string_view path) const;
    [[nodiscard]] std::optional<double> number_at(std::string_view path) const;
    [[nodiscard]] std::string text_at(std::string_view path) const;  ///< empty where there is none
};

/// The tags of a DigitalMicrograph file.
struct DmTags {
    int version = 3;          ///< 3 or 4
    bool big_endian = false;  ///< order of bytes of data; the tree itself is big endian always
    DmTag root;
};

/// Whether bytes begin as a DM3 or DM4.
[[nodiscard]] bool is_dm(std::string_view head);

/// Reads the tree; arrays stay in the file. Depth, counts and sizes are checked against the file before memory is
/// taken.
/// @throws FormatError with the offset of what is damaged.
/// Source: no public specification; B. Schaffer, "How to read DigitalMicrograph file-format" (2014), as openNCEM and
/// RosettaSciIO do.
[[nodiscard]] DmTags read_dm_tags(const bytes::Source& file);

}  // namespace setae::imaging
