// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/arrays.hpp"

namespace setae::processing {

/// Rise of heights from a point to the next, down the rows and along the columns.
struct Tilt {
    double down = 0.0, along = 0.0;
};

/// Points of a row whose medians are computed together, with vector instructions.
constexpr Index medians_together = 8;

/// Maximum distance of points in a median, on each side.
constexpr Index largest_reach = 10;

/// A square (near the border of the rows a rectangle) of (2 rows + 1) × (2 columns + 1) points around a point.
struct Reach {
    Index rows, columns;
};

/// Medians of h − h(here) over the surrounding points, without the point itself, minus the tilt, for `medians_together`
/// times `groups` points of a row whose surroundings are inside the array and defined.
void find_local_medians(const double* here, Index row_length, const Tilt& tilt, const Reach& reach, Index groups,
                        double* medians);

}  // namespace setae::processing
