// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "setae/topography/measurement.hpp"

namespace setae::processing {

/// A straight line on a map; point (i, j) is at (i Δx, j Δy).
struct ProfileLine {
    std::array<double, 2> from{};  ///< x, y [m]
    std::array<double, 2> to{};    ///< [m]
    double width =
        0.0;  ///< heights are averaged across the line over this width [m]; below one and a half pixels: no average
    std::optional<Index> points;  ///< points along the line; absent: about one per pixel
};

/// Heights along a line.
struct LineProfile {
    topography::LineScan
        scan;          ///< heights at equal steps from `from` to `to` [m]; the size is n steps, as for every scan
    Array1D x, y;      ///< positions of its points [m]
    Index tracks = 1;  ///< parallel lines averaged, a pixel apart
};

/// Heights of a map along a line, linear between points (interpolation.hpp); exactly the stored heights at grid points.
///
///   step = about 1/√((cos φ/Δx)² + (sin φ/Δy)²), tracks = width over this step for φ + π/2
///
/// Points without a height are undefined; an average excludes undefined tracks. Positions on a map that is not periodic
/// are within its size, n Δx by m Δy. The last point is one pixel before the edge; an end after it is moved to it.
/// @throws InvalidArgument for ends that are equal, not finite or outside a map that is not periodic; for a width that
/// is negative or fewer than two points.
[[nodiscard]] LineProfile line_profile(const topography::HeightMap& map, const ProfileLine& line);

}  // namespace setae::processing
