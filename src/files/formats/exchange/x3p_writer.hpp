// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "setae/topography/measurement.hpp"

namespace setae::formats {

/// Writes a map (feature type SUR), a line or a profile (PRF) as X3P: float64 heights in metres, NaN if undefined as in
/// openGPS for floats, checksums of the points and of main.xml. Positions of a profile are among the points. The output
/// is reproducible byte by byte. A date is mandatory in addition to the instrument: if it is unknown or not in ISO
/// 8601, it is the first of January 1970.
/// @throws FileError; InvalidArgument for a profile with errors or response of its trace.
/// Source: ISO 25178-72:2017, annex A.
void write_x3p(const std::string& path, const topography::Measurement& measurement);

}  // namespace setae::formats
