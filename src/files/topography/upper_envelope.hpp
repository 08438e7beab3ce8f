// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/core/arrays.hpp"

namespace setae::topography {

/// A part of a polyline's segment, from the x where it is the highest to the x where it no longer is.
struct VisiblePiece {
    Index segment = 0;              ///< from point `segment` to the next
    double begin = 0.0, end = 0.0;  ///< [m], begin < end
};

/// Height of a segment of the polyline (x, y) at a position within it, that of its points at their x [m].
[[nodiscard]] double height_of_segment(const Array1D& x, const Array1D& y, Index segment, double position);

/// The highest of a polyline over each x, exactly: pieces from left to right that touch where the curve has no gap.
/// Vertical segments have no piece.  O(n log m) for m stretches between turning points.
[[nodiscard]] std::vector<VisiblePiece> upper_envelope(const Array1D& x, const Array1D& y);

}  // namespace setae::topography
