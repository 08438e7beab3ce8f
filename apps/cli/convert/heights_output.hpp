// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/answers/heights_file.hpp"

namespace setae::cli {

using answers::endings_of_heights;
using answers::require_heights_ending;
using answers::write_heights;

/// What files of heights look like, for --explain.
inline constexpr const char* heights_output_explanation =
    ".x3p  ISO 25178-72: float64 heights [m], checksums; maps, lines and profiles\n"
    ".sdf  ISO 25178-71, binary: float64 heights [m]; maps and lines of at most 65535 points along a direction\n"
    ".gwy  Gwyddion: one channel of float64 heights [m], undefined points under its mask; maps\n"
    ".gsf  Gwyddion Simple Field: float32 heights [m], NaN undefined; maps\n"
    ".nc   NetCDF: heights(x[, y]), x, y [m] with length and periodicity; read back without --size and --unit\n"
    ".npy  heights [m], float64, C order, shape (nx, ny) or (n); NaN undefined\n"
    ".txt  a map: rows from the top behind its size and unit, as Gwyddion exports them; a line: columns x [m], h [m]\n"
    ".csv  a map: one line for each x, no header; a line: columns x [m], h [m]\n";

}  // namespace setae::cli
