// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

#include "setae/bytes/source.hpp"
#include "setae/formats/channel.hpp"

namespace setae::formats {

/// What columns of numbers are taken for: rows of a map or one line of heights, points x, y, z on a grid, a curve x, h,
/// or x and several profiles.
enum class TextContent { none, matrix, points, curve, profiles };

/// What a text seems to hold.
struct TextGuess {
    TextContent content = TextContent::none;
    bool certain = false;  ///< its header says so
};

/// From the first bytes; open_text looks at all of it.
[[nodiscard]] TextGuess guess_text(std::string_view head, const bytes::Source& source);

/// The channels of columns of numbers.
///
/// A header of a map, or more than three columns, or one: a matrix, in which labels are no heights (find_labels()).
/// Named columns of which the first is x: the profiles that the others are. Two columns: a curve. Three: points where x
/// and y lie on a regular grid; x and height behind an index where the first counts up and the second runs on; two
/// profiles where the first runs evenly; of a few rows a matrix. Where nothing but the numbers says so, an alert
/// AMBIGUOUS_COLUMNS tells what was chosen and how to have it otherwise; ReadOptions::layout decides before all.
/// @throws FormatError for text that is none of these: named columns of a table, numbers that break off.
[[nodiscard]] std::vector<Channel> open_text(const bytes::Source& source, const ReadOptions& options);

/// Writes lines and profiles as x [m], h [m], or as setae's own profile where the trace is known. A map becomes a
/// matrix with Gwyddion's header, or, by write_text_curve, one of numbers in metres between commas, without size.
void write_text_matrix(const std::string& path, const topography::Measurement& measurement);
void write_text_curve(const std::string& path, const topography::Measurement& measurement);

}  // namespace setae::formats
