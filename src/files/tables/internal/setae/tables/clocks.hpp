// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/table.hpp"

namespace setae::tables {

/// A force record with the contact radii of a camera with a separate clock.
///
///   time of a frame on the force clock = time of the camera + offset
///
/// Each frame is assigned to the nearest sample of force, a shift of at most half a sample; samples between frames have
/// NaN, without interpolation. If several frames are nearest to one sample, the closest is used. Frames beyond the
/// record are left out. metadata: "camera_clock_offset", "frames_used", "frames_outside", "frames_crowded" (replaced by
/// a closer one) and "largest_frame_shift".
///
/// force_table: column "time" [s], any others. camera_table: "time" [s], "contact_radius" [m]. offset [s].
/// @throws InvalidArgument for a missing column or wrong unit, a force table that already has a contact radius, a time
/// that is undefined or not increasing (the message contains the row), clocks that do not overlap, an infinite offset.
[[nodiscard]] Table merged_by_time(const Table& force_table, const Table& camera_table, double offset);

/// Checks that the columns of a table have one length and that its time, if any, increases.
/// @throws InvalidArgument with column and rows. `subject` begins the message.
void require_one_clock(const Table& table, const std::string& subject);

}  // namespace setae::tables
