// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "setae/topography/measurement.hpp"

namespace setae::formats {

/// Entries of a channel's metadata that setae writes and knows again.
inline constexpr const char* gwy_undefined_key = "Undefined points (setae)";
inline constexpr const char* gwy_instrument_type = "instrument type";  ///< in lower case

/// Writes a map as the only channel of a Gwyddion file: heights and sizes in metres, title, metadata, rows from the
/// top. The format allows no NaN: undefined points have the mean height and are marked in the channel's mask, as
/// Gwyddion does on import, and an entry of the metadata says so, by which open() makes them undefined again.
/// @throws FileError; InvalidArgument for a line or profile, and for heights of 4 GiB and more.
/// Source: Gwyddion user guide, Format of Gwyddion Files.
void write_gwy(const std::string& path, const topography::Measurement& measurement);

}  // namespace setae::formats
