// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "setae/bytes/source.hpp"
#include "setae/formats/channel.hpp"
#include "setae/tables/table_file.hpp"

namespace setae::formats {

/// Positions and heights, with the units in the file.
struct HeightCurve {
    tables::RawTable::RawColumn x;
    tables::RawTable::RawColumn heights;
    std::optional<tables::RawTable::RawColumn> standard_error = {};
};

/// The channels of a curve, one per pass of its positions (PASSES_SPLIT if there are several), by traced(). A missing
/// unit comes from the user, or from the other column with a warning; without either, `read` throws InvalidArgument.
/// `info` has name, format, metadata and alerts.
/// @throws FormatError for units that are no lengths, undefined positions, positions of scattered points and fewer than
/// two points; UndefinedDataError if no height is defined.
[[nodiscard]] std::vector<Channel> curve_channels(ChannelInfo info, const HeightCurve& curve,
                                                  const ReadOptions& options, const bytes::Source& source);

/// Whether each value is greater than the one before.
[[nodiscard]] bool increases(const Array1D& values);

/// Whether text is a unit of length; "A" counts as Å.
[[nodiscard]] bool is_length_unit(const std::string& text);

/// Adds a warning UNIT_MISMATCH if the user gave a unit other than that of the file.
void compare_unit(ChannelInfo& info, const ReadOptions& options, const bytes::Source& source);

/// Units of positions and of heights of a map.
struct MapUnits {
    std::string positions, heights;  ///< empty if not given
};

/// Units from the file, otherwise those given. If the file states one of them and the other is not given, it applies to
/// both, with a warning UNIT_ASSUMED. Sets the unit of the channel.
[[nodiscard]] MapUnits units_of_map(ChannelInfo& info, MapUnits stated, const ReadOptions& options,
                                    const bytes::Source& source);

/// A length such as "2.5 µm", or nothing.
[[nodiscard]] std::optional<double> try_length(std::string_view text);

}  // namespace setae::formats
