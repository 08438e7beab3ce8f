// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "raster.hpp"
#include "setae/bytes/source.hpp"
#include "setae/core/arrays.hpp"
#include "setae/formats/channel.hpp"

namespace setae::formats {

/// What a file says of an array or of itself: a text, or numbers.
struct Attribute {
    std::string name;
    std::string text;
    std::vector<double> numbers;
};

using Attributes = std::vector<Attribute>;

/// The text of an attribute; empty where there is none.
[[nodiscard]] std::string text_of(const Attributes& attributes, const std::string& name);
/// The one number of an attribute; nothing where there is none or more.
[[nodiscard]] std::optional<double> number_of(const Attributes& attributes, const std::string& name);

/// An array of numbers in a file of arrays: its shape, what is said of it, and where its values lie. The last index is
/// the fast one, or the first where `first_fast`.
struct StoredArray {
    std::string name;
    std::vector<Index> shape;
    Attributes attributes;
    bytes::Source data;
    std::uint64_t offset = 0;  ///< of the first value in `data`
    Sample sample = Sample::float64;
    std::endian order = std::endian::little;
    bool first_fast = false;
    std::uint64_t first_distance = 0;  ///< bytes from one first index to the next; 0: no gaps
    /// keeps what has been unpacked for as long as the result lives; nothing where values are read as they lie
    std::function<std::shared_ptr<const void>()> hold = {};
    std::string refusal = {};  ///< why the values cannot be read; empty where they can
};

/// Whether an array can be a map or a line: one or two dimensions, more than one value.
[[nodiscard]] bool is_map_or_line(const StoredArray& array);

/// What the first index of a map counts.
enum class FirstIndex { x_to_the_right, y_downwards };

/// What the user gave, for one of several arrays: without a size that is another array's, one of a map for a line.
[[nodiscard]] ReadOptions options_for(const StoredArray& array, const ReadOptions& options);

/// "first index x, second y downwards, as stored" and its counterpart; empty for a line.
[[nodiscard]] std::string orientation_of(const StoredArray& array, FirstIndex first);

/// The channel of an array for which is_map_or_line holds, as raster_channel makes it. An array that cannot be read is
/// listed with the alert UNREADABLE_ARRAY, and `read` throws FormatError that says why. Sets info.shape and, where it
/// is empty, info.orientation.
/// @throws FormatError for an array that is not wholly in its source.
[[nodiscard]] Channel array_channel(ChannelInfo info, const StoredArray& array, FirstIndex first, const RawScale& scale,
                                    const ReadOptions& options);

/// The same for a raster within the array's values: a frame of a film, rows from the bottom.
[[nodiscard]] Channel array_channel(ChannelInfo info, const StoredArray& array, const Raster& raster,
                                    const RawScale& scale, const ReadOptions& options);

/// Refuses an array that is not wholly in its source. @throws FormatError.
void require_array(const StoredArray& array, const std::string& format);

/// All values of an array of one or two dimensions in the order of its indices, the last fastest.
/// @throws FormatError for an array that is not wholly in its source or cannot be read.
[[nodiscard]] Array1D values_of(const StoredArray& array, const std::string& format);

/// The first and the last value of an array of one dimension.
struct Ends {
    double first = 0.0, last = 0.0;
};
[[nodiscard]] Ends ends_of(const StoredArray& array, const std::string& format);

}  // namespace setae::formats
