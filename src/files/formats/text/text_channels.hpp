// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

#include "setae/bytes/source.hpp"
#include "setae/formats/channel.hpp"

namespace setae::formats {

/// Interpretation of columns of numbers: rows of a map or one line of heights, points x, y, z on a grid, a curve x, h,
/// or x and several profiles.
enum class TextContent { none, matrix, points, curve, profiles };

/// Presumed content of a text.
struct TextGuess {
    TextContent content = TextContent::none;
    bool certain = false;  ///< stated by its header
};

/// From the first bytes; open_text reads all of it.
[[nodiscard]] TextGuess guess_text(std::string_view head, const bytes::Source& source);

/// The channels of columns of numbers.
///
/// A header of a map, or more than three columns, or one: a matrix, in which labels are no heights (find_labels()).
/// Named columns with x first: profiles. Two columns: a curve. Three: points if x and y are on a regular grid; x and
/// height after an index if the first counts up and the second is monotonic; two profiles if the first is evenly
/// spaced; for a few rows a matrix. If only the numbers decide, a warning AMBIGUOUS_COLUMNS states the choice and the
/// alternative; ReadOptions::layout has priority.
/// @throws FormatError for text that is none of these: named columns of a table, incomplete numbers.
[[nodiscard]] std::vector<Channel> open_text(const bytes::Source& source, const ReadOptions& options);

/// Writes lines and profiles as x [m], h [m], or in the profile format of setae if the trace is known. A map becomes a
/// matrix with Gwyddion's header, or, by write_text_curve, one of comma-separated numbers in metres, without size.
void write_text_matrix(const std::string& path, const topography::Measurement& measurement);
void write_text_curve(const std::string& path, const topography::Measurement& measurement);

}  // namespace setae::formats
