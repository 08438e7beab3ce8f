// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "picture.hpp"
#include "setae/bytes/source.hpp"

namespace setae::imaging {

/// Whether `first` comes before `second` where runs of digits count as numbers: "a2" before "a10".
[[nodiscard]] bool natural_order(std::string_view first, std::string_view second);

/// Files of a folder accepted by `wanted`, in natural order; hidden files are left out. @throws FileError.
[[nodiscard]] std::vector<std::string> files_in(const std::string& folder,
                                                const std::function<bool(const bytes::Source&)>& wanted);

/// Pictures in a folder, in natural order; hidden files and all except PNG, JPEG, TIFF or BMP are left out.
/// @throws FileError; FormatError for a folder without pictures.
[[nodiscard]] std::vector<std::string> pictures_in(const std::string& folder);

/// Numbers of frames.
struct FrameNumbers {
    std::vector<long> numbers;
    std::vector<long> missing;
    std::string note;  ///< why names are not used as numbers although they contain some
};

/// The last number of each name if names differ only by it, in increasing order; otherwise 1, 2, 3 …
[[nodiscard]] FrameNumbers numbers_of(const std::vector<std::string>& paths);

/// A picture of a file, or the reason for its absence; a frame of more than `max_pixels` is not decoded.
[[nodiscard]] FrameRead read_picture(const std::string& path, long max_pixels);

/// The size in the header of a file. @throws FileError.
[[nodiscard]] std::optional<PictureSize> size_of_picture(const std::string& path);

}  // namespace setae::imaging
