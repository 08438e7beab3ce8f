// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "setae/topography/measurement.hpp"

namespace setae::formats {

/// Writes a map (feature type SUR), a line or a profile (PRF) as X3P: float64 heights in metres, NaN where undefined as
/// openGPS has it for floats, checksums of the points and of main.xml. Positions of a profile stand among the points.
/// The same bytes each time. A date is mandatory beside the instrument: where none is known, or it is not written as
/// ISO 8601, the first of January 1970 stands there.
/// @throws FileError; InvalidArgument for a profile that knows the errors or the response of its trace.
/// Source: ISO 25178-72:2017, annex A.
void write_x3p(const std::string& path, const topography::Measurement& measurement);

}  // namespace setae::formats
