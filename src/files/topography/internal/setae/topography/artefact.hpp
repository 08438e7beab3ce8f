// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "setae/topography/measurement.hpp"

namespace setae::topography {

/// The artefact of an instrument, from scans of a smooth reference: each scan minus its best line, averaged point by
/// point over defined heights on the grid of the first.
/// @throws InvalidArgument for an empty list, or for steps or lengths that differ by more than a tenth of a step.
[[nodiscard]] LineScan average_reference(std::span<const LineScan> references);

/// A scan minus the artefact, interpolated linearly at the points of the scan. Points outside the artefact are
/// undefined and are removed at the ends.
/// @throws UndefinedDataError if the two overlap in fewer than two points.
[[nodiscard]] LineScan subtract_artefact(const LineScan& scan, const LineScan& artefact);

}  // namespace setae::topography
