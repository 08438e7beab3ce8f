// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/contact_line/contact_line.hpp"
#include "setae/core/table.hpp"

namespace setae::contact_line {

/// Columns "time" [s], "frame", "radius_1" … "radius_N" [m] at θ = 0, 2π/N …, one row per frame; metadata "place_error"
/// in metres. frames: numbers, M of them.
/// @throws InvalidArgument as require_valid, or for other than M numbers.
[[nodiscard]] Table as_table(const ContactLine& line, const std::vector<long>& frames);

/// The line of such a table, from pictures or a simulation; other columns are ignored. The error of a position is 0
/// where the table states none.
/// @throws InvalidArgument without "time" or "radius_1", where the numbers of radii have a gap, and as require_valid.
[[nodiscard]] ContactLine line_of(const Table& table);

}  // namespace setae::contact_line
