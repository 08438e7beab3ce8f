// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/arrays.hpp"

namespace setae::processing {

/// How heights rise from a point to the next, down the rows and along the columns.
struct Tilt {
    double down = 0.0, along = 0.0;
};

/// Points of a row whose medians are found side by side, so that comparisons become vector instructions.
constexpr Index medians_together = 8;

/// Farthest point on each side that a median looks at.
constexpr Index largest_reach = 10;

/// A square (near the border of the rows a rectangle) of (2 rows + 1) × (2 columns + 1) points around a point.
struct Reach {
    Index rows, columns;
};

/// Medians of h − h(here) over the points around, without the point itself, the tilt taken off: of `medians_together`
/// times `groups` points of a row, whose surroundings lie inside the array and are defined.
void find_local_medians(const double* here, Index row_length, const Tilt& tilt, const Reach& reach, Index groups,
                        double* medians);

}  // namespace setae::processing
