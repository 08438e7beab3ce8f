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

/// An attribute of a file or an array: a text, or numbers.
struct Attribute {
    std::string name;
    std::string text;
    std::vector<double> numbers;
};

using Attributes = std::vector<Attribute>;

/// The text of an attribute; empty if there is none.
[[nodiscard]] std::string text_of(const Attributes& attributes, const std::string& name);
/// The only number of an attribute; empty if there is none or several.
[[nodiscard]] std::optional<double> number_of(const Attributes& attributes, const std::string& name);

/// An array of numbers in a file of arrays: shape, attributes, and place of its values. The last index is the fast one,
/// or the first if `first_fast`.
struct StoredArray {
    std::string name;
    std::vector<Index> shape;
    Attributes attributes;
    bytes::Source data;
    std::uint64_t offset = 0;  ///< of the first value in `data`
    Sample sample = Sample::float64;
    std::endian order = std::endian::little;
    bool first_fast = false;
    std::uint64_t first_distance = 0;  ///< bytes between first indices; 0: no gaps
    /// keeps unpacked values during the lifetime of the result; empty if values are read directly
    std::function<std::shared_ptr<const void>()> hold = {};
    std::string refusal = {};  ///< why the values cannot be read; empty if they can
};

/// Whether an array can be a map or a line: one or two dimensions, more than one value.
[[nodiscard]] bool is_map_or_line(const StoredArray& array);

/// Meaning of the first index of a map.
enum class FirstIndex { x_to_the_right, y_downwards };

/// Options of the user for one of several arrays, without a size that applies to another array, such as that of a map
/// for a line.
[[nodiscard]] ReadOptions options_for(const StoredArray& array, const ReadOptions& options);

/// "first index x, second y downwards, as stored" and its counterpart; empty for a line.
[[nodiscard]] std::string orientation_of(const StoredArray& array, FirstIndex first);

/// The channel of an array that satisfies is_map_or_line, see raster_channel. An array that cannot be read is listed
/// with the warning UNREADABLE_ARRAY, and `read` throws FormatError with the reason. Sets info.shape and, if it is
/// empty, info.orientation.
/// @throws FormatError for an array that is not completely in its source.
[[nodiscard]] Channel array_channel(ChannelInfo info, const StoredArray& array, FirstIndex first, const RawScale& scale,
                                    const ReadOptions& options);

/// The channel of a raster within the values of the array: a frame of a film, rows from the bottom.
[[nodiscard]] Channel array_channel(ChannelInfo info, const StoredArray& array, const Raster& raster,
                                    const RawScale& scale, const ReadOptions& options);

/// Refuses an array that is not completely in its source. @throws FormatError.
void require_array(const StoredArray& array, const std::string& format);

/// All values of an array of one or two dimensions in the order of its indices, the last fastest.
/// @throws FormatError for an array that is not completely in its source or cannot be read.
[[nodiscard]] Array1D values_of(const StoredArray& array, const std::string& format);

/// The first and the last value of an array of one dimension.
struct Ends {
    double first = 0.0, last = 0.0;
};
[[nodiscard]] Ends ends_of(const StoredArray& array, const std::string& format);

}  // namespace setae::formats
