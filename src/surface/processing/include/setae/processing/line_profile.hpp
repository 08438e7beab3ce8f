// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "setae/topography/measurement.hpp"

namespace setae::processing {

/// A straight line on a map; point (i, j) lies at (i Δx, j Δy).
struct ProfileLine {
    std::array<double, 2> from{};  ///< x, y [m]
    std::array<double, 2> to{};    ///< [m]
    double width =
        0.0;  ///< heights are averaged across it over this width [m]; below one and a half pixels: the line alone
    std::optional<Index> points;  ///< along it; absent: about one a pixel
};

/// Heights along a line.
struct LineProfile {
    topography::LineScan
        scan;          ///< heights at equal steps from `from` to `to` [m]; its size is n steps, as of every scan
    Array1D x, y;      ///< of its points [m]
    Index tracks = 1;  ///< parallel lines averaged, a pixel apart
};

/// Heights of a map along a line, linear between points (interpolation.hpp); exactly those stored where a point of the
/// line is one of the grid.
///
///   step = about 1/√((cos φ/Δx)² + (sin φ/Δy)²), tracks = width over the same of φ + π/2
///
/// Points without a height are undefined; an average leaves undefined tracks out.
/// @throws InvalidArgument for ends that are equal, not finite or, of a map that is not periodic, outside it; for a
/// width that is negative or fewer than two points.
[[nodiscard]] LineProfile line_profile(const topography::HeightMap& map, const ProfileLine& line);

}  // namespace setae::processing
