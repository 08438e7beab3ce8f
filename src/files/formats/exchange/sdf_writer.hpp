// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "setae/topography/measurement.hpp"

namespace setae::formats {

/// Writes a map, or a line as its only profile, as binary SDF: float64 heights in metres (Zscale 1), NaN if undefined
/// as Gwyddion reads them. The ten bytes of the manufacturer contain the name of the instrument; a date not in ISO 8601
/// becomes zeros (no date).
/// @throws FileError; InvalidArgument for a profile, whose steps differ, and for more than 65535 points along a
/// direction. Source: ISO 25178-71:2012.
void write_sdf(const std::string& path, const topography::Measurement& measurement);

}  // namespace setae::formats
