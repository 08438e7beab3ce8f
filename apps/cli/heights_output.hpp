// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "setae/topography/measurement.hpp"

namespace setae::cli {

/// Writes the heights [m] of a measurement in the format its path ends with.
///
/// .npy: float64 in C order, shape (nx, ny) or (n). .csv: a map as a matrix, one line for each x, no header; a line with
/// columns x [m], h [m]. .nc: NetCDF with size, unit and periodicity. NaN is undefined.
/// @throws InvalidArgument for another ending; FileError.
void write_heights(const std::string& path, const topography::Measurement& measurement);

/// @throws InvalidArgument where write_heights would for the path's ending, before heights are dear to make.
void require_heights_ending(const std::string& path);

/// What they look like, for --explain.
inline constexpr const char* heights_output_explanation =
    ".npy  heights [m], float64, C order, shape (nx, ny) or (n); NaN undefined\n"
    ".csv  a map: one line for each x, no header; a line: columns x [m], h [m]\n"
    ".nc   NetCDF: heights(x[, y]), x, y [m] with length and periodicity; read back without --size and --unit\n";

}  // namespace setae::cli
