// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "setae/topography/measurement.hpp"

namespace setae::topography {

/// The artefact of an instrument, from scans of a smooth reference: each detrended by its best line, averaged point by
/// point over defined heights on the grid of the first.
/// @throws InvalidArgument for no scan, or for steps or lengths that differ by more than a tenth of a step.
[[nodiscard]] LineScan average_reference(std::span<const LineScan> references);

/// A scan minus the artefact, the artefact interpolated linearly at the scan's points. Points the artefact does not
/// reach become undefined at the ends and are cut off.
/// @throws UndefinedDataError where the two do not overlap in at least two points.
[[nodiscard]] LineScan subtract_artefact(const LineScan& scan, const LineScan& artefact);

}  // namespace setae::topography
