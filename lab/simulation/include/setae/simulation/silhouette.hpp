// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/topography/measurement.hpp"

namespace setae::simulation {

/// Projection of a foil along y: at each x the highest point over the foil's thickness.
///
///   s(x) = max_{start_y <= y <= start_y + thickness} h(x, y)
///
/// thickness [m], >= 0: 0 is the line scan through the surface at start_y [m]. Grid points within the interval are
/// included, at least the one nearest start_y; a periodic map is continued along y, and for any other map the interval
/// must lie inside. Undefined heights are ignored; a column with only undefined heights is undefined.
/// @throws InvalidArgument for a negative or infinite thickness, or an interval outside a map that is not periodic.
[[nodiscard]] topography::LineScan silhouette(const topography::HeightMap& surface, double thickness,
                                              double start_y = 0.0);

}  // namespace setae::simulation
