// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "setae/core/arrays.hpp"

namespace setae::formats {

/// Writes an array as NPY version 1, little-endian float64 in C order; first index x. As a whole.
/// @throws FileError.
/// Source: NumPy Enhancement Proposal 1.
void write_npy(const std::string& path, const Array2D& values);
void write_npy(const std::string& path, const Array1D& values);

}  // namespace setae::formats
