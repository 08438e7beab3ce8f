// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "setae/topography/measurement.hpp"

namespace setae::cli {

/// Writes the heights [m] of a measurement in the format its path ends with: one of the table of formats, or
///
/// .csv: a map as a matrix, one line for each x, no header; a line with columns x [m], h [m]. NaN is undefined.
/// @throws InvalidArgument for another ending and for what the format cannot hold; FileError.
void write_heights(const std::string& path, const topography::Measurement& measurement);

/// @throws InvalidArgument where write_heights would for the path's ending, before heights are dear to make.
/// others: what else the verb writes, for the message.
void require_heights_ending(const std::string& path, const std::string& others = {});

/// ".x3p, … or .csv", for messages.
[[nodiscard]] std::string endings_of_heights();

/// What they look like, for --explain.
inline constexpr const char* heights_output_explanation =
    ".x3p  ISO 25178-72: float64 heights [m], checksums; maps, lines and profiles\n"
    ".sdf  ISO 25178-71, binary: float64 heights [m]; maps and lines of at most 65535 points along a direction\n"
    ".gwy  Gwyddion: one channel of float64 heights [m], undefined points under its mask; maps\n"
    ".nc   NetCDF: heights(x[, y]), x, y [m] with length and periodicity; read back without --size and --unit\n"
    ".npy  heights [m], float64, C order, shape (nx, ny) or (n); NaN undefined\n"
    ".txt  a map: rows from the top behind its size and unit, as Gwyddion exports them; a line: columns x [m], h [m]\n"
    ".csv  a map: one line for each x, no header; a line: columns x [m], h [m]\n";

}  // namespace setae::cli
