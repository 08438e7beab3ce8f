// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "setae/parallel/for_each.hpp"
#include "setae/processing/direction.hpp"
#include "setae/processing/region.hpp"
#include "setae/topography/polynomial_surface.hpp"

namespace setae::processing {

/// Subtracts the mean height of the region.
struct LevelMean {
    Region region;
};

/// Subtracts the plane (for lines: the straight line) that fits the region best.
struct LevelPlane {
    Region region;
};

/// Subtracts the polynomial of x^a y^b, a + b <= degree, a <= degree_x, b <= degree_y, that fits the region best.
struct LevelPolynomial {
    Index degree = 2;                             ///< 0 … 24
    Index degree_x = topography::highest_degree;  ///< 0 … 12
    Index degree_y = topography::highest_degree;
    Region region;
};

/// Subtracts the plane parallel to most facets of the surface: terraces become horizontal for any height of the steps
/// between them.
///
///   b −> Σ v w/Σ w,  w = exp(−20 |v − b|²/β²),  β² = mean |v − b|²
///
/// v: gradients of cells of four points (lines: of neighbouring points); b: slope of the plane, from the mean of v,
/// until it changes by less than 1e-6 β, at most 100 times; without convergence the result has a warning. The mean
/// height of the region is 0 afterwards. Source: facet levelling of Gwyddion's user guide, "Levelling"; Nečas and
/// Klapetek, Cent. Eur. J. Phys. 10 (2012) 181.
struct LevelFacet {
    Region region;
};

/// Subtracts from each scan line its best fitting polynomial; lines with too few points become undefined.
struct LevelLines {
    Index degree = 1;                    ///< 0 … 12
    Direction direction = Direction::x;  ///< direction of the lines
    Region region;
};

inline constexpr std::string_view step_name(const LevelMean&) { return "level_mean"; }
inline constexpr std::string_view step_name(const LevelPlane&) { return "level_plane"; }
inline constexpr std::string_view step_name(const LevelPolynomial&) { return "level_polynomial"; }
inline constexpr std::string_view step_name(const LevelFacet&) { return "level_facet"; }
inline constexpr std::string_view step_name(const LevelLines&) { return "level_lines"; }

template <class Visitor>
void visit_parameters(LevelMean& step, Visitor& visitor) {
    visitor.region("region", step.region, "points whose mean counts");
}
template <class Visitor>
void visit_parameters(LevelPlane& step, Visitor& visitor) {
    visitor.region("region", step.region, "points the plane is fitted to");
}
template <class Visitor>
void visit_parameters(LevelPolynomial& step, Visitor& visitor) {
    visitor.count("degree", step.degree, "largest sum of the powers of x and y");
    visitor.count("degree_x", step.degree_x, "largest power of x");
    visitor.count("degree_y", step.degree_y, "largest power of y");
    visitor.region("region", step.region, "points the polynomial is fitted to");
}
template <class Visitor>
void visit_parameters(LevelFacet& step, Visitor& visitor) {
    visitor.region("region", step.region, "points whose facets count");
}
template <class Visitor>
void visit_parameters(LevelLines& step, Visitor& visitor) {
    visitor.count("degree", step.degree, "of each line's polynomial");
    visitor.choice("direction", step.direction, direction_names, "direction along which lines run");
    visitor.region("region", step.region, "points that count");
}

/// Undefined points remain undefined and are ignored. Periodic data are no longer periodic after subtraction of a plane
/// or a higher polynomial. Records: mean slopes in x and y and mean radii of curvature of the subtracted polynomial,
/// the mean height, the number of points used. @throws InvalidArgument and UndefinedDataError as fitted_polynomial().
[[nodiscard]] Processed apply(const LevelMean& step, topography::Measurement measurement,
                              parallel::Threads threads = {});
[[nodiscard]] Processed apply(const LevelPlane& step, topography::Measurement measurement,
                              parallel::Threads threads = {});
[[nodiscard]] Processed apply(const LevelPolynomial& step, topography::Measurement measurement,
                              parallel::Threads threads = {});
/// @throws UndefinedDataError also if no cell has four points of the region.
[[nodiscard]] Processed apply(const LevelFacet& step, topography::Measurement measurement,
                              parallel::Threads threads = {});
/// A line or polyline is a single scan line.
/// @throws UndefinedDataError if every line has too few points.
[[nodiscard]] Processed apply(const LevelLines& step, topography::Measurement measurement,
                              parallel::Threads threads = {});

}  // namespace setae::processing
