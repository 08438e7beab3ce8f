// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/table.hpp"

namespace setae::tables {

/// A force record with the contact radii of a camera that kept its own clock.
///
///   time of a frame on the force clock = time of the camera + offset
///
/// Each frame goes to the nearest sample of force, which it moves by half a sample at most; samples between frames have
/// NaN, nothing is interpolated. Of several frames nearest to one sample the closest stays. Frames beyond the record
/// are left out. metadata tells "camera_clock_offset", "frames_used", "frames_outside", "frames_crowded" (left for a
/// closer one) and "largest_frame_shift".
///
/// force_table: column "time" [s], any others. camera_table: "time" [s], "contact_radius" [m]. offset [s].
/// @throws InvalidArgument for a missing column or wrong unit, a force table that already has a contact radius, a time
/// that is undefined or does not run forwards (the message names the row), clocks that do not overlap, an infinite
/// offset.
[[nodiscard]] Table merged_by_time(const Table& force_table, const Table& camera_table, double offset);

/// Checks that a table's columns have one length and that its time, where it has one, runs forwards.
/// @throws InvalidArgument that names column and rows. `subject` begins the message.
void require_one_clock(const Table& table, const std::string& subject);

}  // namespace setae::tables
