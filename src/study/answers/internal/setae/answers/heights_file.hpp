// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "setae/topography/measurement.hpp"

namespace setae::answers {

/// Writes the heights [m] of a measurement in the format its path ends with: one of the table of formats, or
///
/// .csv: a map as a matrix, one line for each x, no header; a line with columns x [m], h [m]. NaN is undefined.
/// @throws InvalidArgument for another ending and for what the format cannot hold; FileError.
void write_heights(const std::string& path, const topography::Measurement& measurement);

/// @throws InvalidArgument where write_heights would for the path's ending, before heights are computed. others:
/// further outputs of the command, for the message.
void require_heights_ending(const std::string& path, const std::string& others = {});

/// ".x3p, … or .csv", for messages.
[[nodiscard]] std::string endings_of_heights();

}  // namespace setae::answers
