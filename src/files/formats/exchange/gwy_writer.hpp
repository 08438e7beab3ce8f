// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "setae/topography/measurement.hpp"

namespace setae::formats {

/// Metadata entries of a channel that setae writes and recognises.
inline constexpr const char* gwy_undefined_key = "Undefined points (setae)";
inline constexpr const char* gwy_instrument_type = "instrument type";  ///< in lower case

/// Writes a map as the only channel of a Gwyddion file: heights and sizes in metres, title, metadata, rows from the
/// top. The format allows no NaN: undefined points have the mean height and are marked in the mask of the channel, as
/// in Gwyddion's import; from an entry of the metadata open() restores them as undefined.
/// @throws FileError; InvalidArgument for a line or profile, and for heights of 4 GiB and more.
/// Source: Gwyddion user guide, Format of Gwyddion Files.
void write_gwy(const std::string& path, const topography::Measurement& measurement);

}  // namespace setae::formats
