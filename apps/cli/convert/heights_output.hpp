// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/answers/heights_file.hpp"

namespace setae::cli {

using answers::endings_of_heights;
using answers::require_heights_ending;
using answers::write_heights;

/// Formats of files of heights, for --explain.
inline constexpr const char* heights_output_explanation =
    "The ending of a file determines its format.\n"
    "\n"
    ".x3p  ISO 25178-72: float64 heights [m], checksums; maps, lines and profiles\n"
    ".sdf  ISO 25178-71, binary: float64 heights [m]; maps and lines of at most 65535 points along a direction\n"
    ".gwy  Gwyddion: one channel of float64 heights [m], with a mask of undefined points; maps\n"
    ".gsf  Gwyddion Simple Field: float32 heights [m], NaN undefined; maps\n"
    ".nc   NetCDF: heights(x[, y]), x, y [m] with length and periodicity; read again without --size and --unit\n"
    ".npy  heights [m], float64, C order, shape (nx, ny) or (n); NaN undefined\n"
    ".txt  maps: size and unit, then rows from the top, as exported by Gwyddion; lines: columns x [m], h [m]\n"
    ".csv  maps: one row per x, no header; lines: columns x [m], h [m]\n";

}  // namespace setae::cli
