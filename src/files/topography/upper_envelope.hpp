// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/core/arrays.hpp"

namespace setae::topography {

/// A part of a segment of a polyline, over the range of x where it is the highest.
struct VisiblePiece {
    Index segment = 0;              ///< from point `segment` to the next
    double begin = 0.0, end = 0.0;  ///< [m], begin < end
};

/// Height of a segment of the polyline (x, y) at a position within it, exact at its points [m].
[[nodiscard]] double height_of_segment(const Array1D& x, const Array1D& y, Index segment, double position);

/// The highest part of a polyline over each x, exactly: pieces from left to right that touch if the curve has no gap.
/// Vertical segments have no piece. O(n log m) for m parts between turning points.
[[nodiscard]] std::vector<VisiblePiece> upper_envelope(const Array1D& x, const Array1D& y);

}  // namespace setae::topography
