// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "setae/core/arrays.hpp"
#include "setae/core/quantity.hpp"
#include "setae/topography/detrend.hpp"
#include "setae/topography/measurement.hpp"
#include "setae/topography/tiled_map.hpp"

namespace setae::formats {

/// Properties of a channel, available before its heights are read.
struct ChannelInfo {
    std::string name;
    std::string format;        ///< identifier in formats()
    std::vector<Index> shape;  ///< (nx, ny) of a map, (n) of a line
    std::vector<double>
        size;  ///< extent [m] along each direction: n · pixel size, for profiles x_last − x_first; empty if not given
    std::string unit;         ///< unit of heights in the file, in the spelling of parse_unit; empty if not given
    std::string orientation;  ///< origin of the arrangement of rows and columns: "rows from the bottom, turned"; empty
                              ///< for lines
    bool is_height = true;    ///< false for phase, amplitude, current …: listed, but no heights
    std::string not_heights;  ///< why the channel contains no heights; empty if it does, or if name and unit show it
    topography::Metadata metadata;
    std::optional<topography::Trend> recommended_trend;  ///< trend that a container recommends to remove
    std::vector<Alert> alerts;
};

/// A channel and the function that reads its heights [m]: scaled once, not levelled, NaN = undefined.
///
/// lines: only heights of the scan lines first … first + count − 1, shape (nx, count), for maps larger than memory;
/// empty if the format must be read as a whole.
/// @throws (read, lines) FormatError for content that breaks the format, UndefinedDataError if no height is defined,
/// InvalidArgument for a channel without heights.
struct Channel {
    ChannelInfo info;
    std::function<topography::Measurement()> read;
    std::function<Array2D(Index first, Index count)> lines = {};
    /// warnings on changes to the heights of `lines`, as those in the metadata for `read`; may be empty
    std::function<std::vector<Alert>()> alerts_of_lines = {};
    std::vector<double> no_data_codes = {};  ///< [m]: extremes of the number type of the file
};

/// The map of a channel in bands of scan lines, read on request; empty if the channel is no map, a size or unit is
/// missing, or the format must be read as a whole.
[[nodiscard]] std::optional<topography::TiledMap> tiled(const Channel& channel);

/// Missing metadata of a channel: "size" and "unit", without which heights cannot be read, then "instrument" and
/// "date".
[[nodiscard]] std::vector<std::string> missing(const ChannelInfo& info);

/// Layout of text with ambiguous columns: three columns of numbers are a narrow map, or points x, y, z.
enum class TextLayout { matrix, columns };

/// Metadata given by the user. If the file states a value itself, the value of the file is used, and a difference is a
/// warning (SIZE_MISMATCH above 1e-4, UNIT_MISMATCH).
struct ReadOptions {
    std::optional<std::vector<double>> size;  ///< extent [m] of npy arrays and text matrices
    std::optional<std::string> unit;  ///< of x and heights in text, of heights in npy arrays and text matrices; "mm,
                                      ///< um": x first, then heights
    std::optional<TextLayout> layout = {};  ///< of text; empty: from the numbers, with the warning AMBIGUOUS_COLUMNS if
                                            ///< both layouts fit
    bool keep_values = false;  ///< values that mark missing heights (topography/no_data.hpp) remain heights
};

/// The channels of a file. The format is detected by content, never by name; truncated files and files shorter than
/// their header states are refused here. A container has one channel per measurement. A damaged member becomes a
/// channel with the warning UNREADABLE_MEMBER, whose `read` throws the reason. Heights are read by `read`, not here:
/// only the headers of binary files are read. Values that mark missing heights become undefined when they are read. A
/// missing size or unit is reported by missing(), and by `read` as InvalidArgument.
/// @throws FileError for a path that cannot be read; FormatError for unknown or damaged content; InvalidArgument for
/// sizes that do not fit the data.
[[nodiscard]] std::vector<Channel> open(const std::string& path, const ReadOptions& options = {});

/// A channel chosen by the user, for chosen_by_name(): its number, counted from 0, or its name or the beginning of its
/// name. Empty: the preferred channel.
using ChannelChoice = std::optional<std::string>;

/// The channel of heights that is used without a choice. In this order: a map before a line; a name of heights (height,
/// topography, topo, z, surface, elevation) before others; one whose size and unit are known; trace or forward before
/// retrace or backward; the order of the file. Empty if no channel contains heights.
[[nodiscard]] std::optional<std::size_t> preferred_channel(const std::vector<Channel>& channels);

/// Numbers of the chosen channels: the wanted one, otherwise the preferred one, or all with heights.
/// @throws InvalidArgument that begins with the path if there is none.
[[nodiscard]] std::vector<std::size_t> chosen_channels(const std::string& path, const std::vector<Channel>& channels,
                                                       const ChannelChoice& wanted, bool all = false);

/// The chosen channels of a named file: the wanted one, otherwise all with heights of a container, or the preferred one
/// of another file. @throws as open; InvalidArgument if there is none.
[[nodiscard]] std::vector<Channel> open_chosen(const std::string& path, const ChannelChoice& wanted,
                                               const ReadOptions& options = {});

/// The heights of one channel; without a choice those of the preferred one.
/// @throws InvalidArgument if the file has no such channel or the channel contains no heights; otherwise as open.
[[nodiscard]] topography::Measurement read(const std::string& path, const ChannelChoice& channel = std::nullopt,
                                           const ReadOptions& options = {});
/// The heights of a channel by number, counted from 0.
[[nodiscard]] topography::Measurement read(const std::string& path, std::size_t channel,
                                           const ReadOptions& options = {});

}  // namespace setae::formats
