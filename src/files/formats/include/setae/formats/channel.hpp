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

/// What is known of a channel before its heights are read.
struct ChannelInfo {
    std::string name;
    std::string format;        ///< identifier in formats()
    std::vector<Index> shape;  ///< (nx, ny) of a map, (n) of a line
    std::vector<double>
        size;  ///< extent [m] along each direction: n · pixel size, for profiles x_last − x_first; empty: nobody said
    std::string unit;  ///< the file's unit of heights, spelled as parse_unit knows it; empty: nobody said
    std::string
        orientation;  ///< how rows and columns came to lie as they do: "rows from the bottom, turned"; empty for lines
    bool is_height = true;    ///< false for phase, amplitude, current …: listed, but no heights
    std::string not_heights;  ///< why it is taken for no heights; empty where it is, or its name and unit say so
    topography::Metadata metadata;
    std::optional<topography::Trend> recommended_trend;  ///< what a container says to remove
    std::vector<Alert> alerts;
};

/// A channel and the function that reads its heights [m]: scaled once, not levelled, NaN = undefined.
///
/// lines: heights of the scan lines first … first + count − 1 alone, shape (nx, count), for maps larger than memory;
/// empty where the format has to be read as a whole.
/// @throws (read, lines) FormatError for content that breaks the format, UndefinedDataError where no height is defined,
/// InvalidArgument for a channel that holds no heights.
struct Channel {
    ChannelInfo info;
    std::function<topography::Measurement()> read;
    std::function<Array2D(Index first, Index count)> lines = {};
    /// what was made of heights that `lines` gives, as the metadata's alerts tell it of what `read` gives; may be empty
    std::function<std::vector<Alert>()> alerts_of_lines = {};
    std::vector<double> no_data_codes = {};  ///< [m]: what the extremes of the file's type of number would be
};

/// The map of a channel by bands of scan lines, read when asked; nothing where it is no map, a size or unit is missing,
/// or the format has to be read as a whole.
[[nodiscard]] std::optional<topography::TiledMap> tiled(const Channel& channel);

/// What the file of a channel does not say: "size" and "unit", without which heights cannot be read, then "instrument"
/// and "date".
[[nodiscard]] std::vector<std::string> missing(const ChannelInfo& info);

/// How text is to be read whose columns have two meanings: three columns of numbers are a narrow map, or points x, y,
/// z.
enum class TextLayout { matrix, columns };

/// What a file may leave open and the user must say. Where the file says it itself, the file wins, and a difference
/// becomes an alert (SIZE_MISMATCH above 1e-4, UNIT_MISMATCH).
struct ReadOptions {
    std::optional<std::vector<double>> size;  ///< extent [m] of npy arrays and text matrices
    std::optional<std::string> unit;  ///< of x and heights in text, of heights in npy arrays and text matrices; "mm,
                                      ///< um": of x, then of heights
    std::optional<TextLayout> layout =
        {};                    ///< of text; nothing: from the numbers, with an alert AMBIGUOUS_COLUMNS where both fit
    bool keep_values = false;  ///< values that mark missing heights (topography/no_data.hpp) stay heights
};

/// The channels of a file. The format is detected by content, never by name; truncated files and files whose header
/// announces more than they hold are refused here. A container gives one channel a measurement, and one bad member
/// becomes a channel with the alert UNREADABLE_MEMBER whose `read` throws what was wrong. Heights are read by `read`,
/// not here: of binary files only headers are. Values that mark missing heights become undefined when they are read. A
/// missing size or unit is told by missing(), and by `read` as InvalidArgument.
/// @throws FileError for a path that cannot be read; FormatError for unknown or broken content; InvalidArgument for
/// sizes that do not fit the data.
[[nodiscard]] std::vector<Channel> open(const std::string& path, const ReadOptions& options = {});

/// A channel as a user names it, as chosen_by_name() takes it: its number, counted from 0, or its name or the beginning
/// of it. Nothing: the preferred one.
using ChannelChoice = std::optional<std::string>;

/// The channel of heights that is taken where nobody chose. In this order: a map before a line; a name of heights
/// (height, topography, topo, z, surface, elevation) before others; one whose size and unit are known; trace or forward
/// before retrace or backward; the order of the file. Nothing where no channel holds heights.
[[nodiscard]] std::optional<std::size_t> preferred_channel(const std::vector<Channel>& channels);

/// Which of a file's channels are meant: the one wanted, else the preferred one, or all of heights.
/// @throws InvalidArgument that begins with the path where there is none.
[[nodiscard]] std::vector<std::size_t> chosen_channels(const std::string& path, const std::vector<Channel>& channels,
                                                       const ChannelChoice& wanted, bool all = false);

/// The channels meant where a file is named: the one wanted, else of a container all of heights, of another file the
/// preferred one. @throws as open; InvalidArgument where there is none.
[[nodiscard]] std::vector<Channel> open_chosen(const std::string& path, const ChannelChoice& wanted,
                                               const ReadOptions& options = {});

/// The heights of one channel, without a choice the preferred one.
/// @throws InvalidArgument where the file has no such channel or it holds no heights; else as open.
[[nodiscard]] topography::Measurement read(const std::string& path, const ChannelChoice& channel = std::nullopt,
                                           const ReadOptions& options = {});
/// The same by number, counted from 0.
[[nodiscard]] topography::Measurement read(const std::string& path, std::size_t channel,
                                           const ReadOptions& options = {});

}  // namespace setae::formats
