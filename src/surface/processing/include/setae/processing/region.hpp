// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "setae/parallel/for_each.hpp"
#include "setae/processing/processed.hpp"
#include "setae/topography/mask.hpp"

namespace setae::processing {

/// From one position, height or percentile to another, both ends included; an absent end is open.
struct Range {
    std::optional<double> from;
    std::optional<double> to;

    friend bool operator==(const Range&, const Range&) = default;
};

/// Points with x and y in ranges [m]; for lines x only.
struct Rectangle {
    Range x;
    Range y;

    friend bool operator==(const Rectangle&, const Rectangle&) = default;
};

/// Points of a map within an ellipse whose first semi-axis makes an angle with x.
struct Ellipse {
    std::array<double, 2> centre{};     ///< [m]
    std::array<double, 2> semi_axes{};  ///< [m], > 0
    double angle = 0.0;                 ///< [rad], from x towards y

    friend bool operator==(const Ellipse&, const Ellipse&) = default;
};

/// Points of a map inside a polygon; by the even-odd rule if it crosses itself. Corners in either sense, the last
/// joined to the first.
struct Polygon {
    std::vector<std::array<double, 2>> corners;  ///< [m], at least three

    friend bool operator==(const Polygon&, const Polygon&) = default;
};

/// Points whose height [m], before the step, is in a range.
struct HeightRange {
    Range heights;

    friend bool operator==(const HeightRange&, const HeightRange&) = default;
};

/// Points whose height is between two percentiles (0 … 100) of the defined heights.
struct PercentileRange {
    Range percentiles;

    friend bool operator==(const PercentileRange&, const PercentileRange&) = default;
};

/// A selection of points, and its growth in pixels: a point within so many rows and columns of a selected point is
/// selected, too.
struct Shape {
    std::variant<Rectangle, Ellipse, Polygon, HeightRange, PercentileRange> outline;
    Index grow = 0;  ///< >= 0; for polylines points instead of pixels

    friend bool operator==(const Shape&, const Shape&) = default;
};

/// Selected points: those of any included shape (all points without one), except those of excluded shapes.
///
/// Positions are x_i = i · pixel size from the first point; for polylines the positions are their own.
struct Region {
    std::vector<Shape> include;
    std::vector<Shape> exclude;

    [[nodiscard]] bool everything() const { return include.empty() && exclude.empty(); }
    friend bool operator==(const Region&, const Region&) = default;
};

/// The points of a region, defined or not: 1 = selected; shape (nx, ny) for a map, (n, 1) for a line or polyline.
/// Undefined points are in no range of heights.
/// @throws InvalidArgument for a shape outside its domain, and for an ellipse, a polygon or a range of y on a line.
/// Cost: linear; percentiles by selection (also linear), polygons points × corners within their bounding box.
[[nodiscard]] topography::Mask mask_of(const Region& region, const topography::HeightMap& map,
                                       parallel::Threads threads = {});
[[nodiscard]] topography::Mask mask_of(const Region& region, const topography::LineScan& scan,
                                       parallel::Threads threads = {});
[[nodiscard]] topography::Mask mask_of(const Region& region, const topography::Profile& profile,
                                       parallel::Threads threads = {});

/// A region from text, as in pipeline files and on the command line: shapes separated by ";", each
///
///   include|exclude SHAPE [grow N]
///   SHAPE: rectangle 1 um to 5 um, 0 um to 2 um  ·  rectangle 1 um to 5 um  ·
///          ellipse 5 um, 5 um, 2 um, 1 um, 30 deg (centre, semi-axes, optional angle)  ·
///          polygon 0 um, 0 um, 4 um, 0 um, 2 um, 3 um  ·
///          heights above 20 nm  ·  heights below 5 nm  ·  heights 5 nm to 20 nm  ·
///          percentiles 5 to 95  ·  percentiles above 95
/// @throws InvalidArgument with the invalid shape.
[[nodiscard]] Region region_from_text(std::string_view text);

/// The text from which region_from_text() restores the region.
[[nodiscard]] std::string text(const Region& region);

/// Sets the points of a region undefined.
struct MaskOut {
    Region region;  ///< at least one shape
};

inline constexpr std::string_view step_name(const MaskOut&) { return "mask_out"; }
template <class Visitor>
void visit_parameters(MaskOut& step, Visitor& visitor) {
    visitor.region("region", step.region, "points that become undefined");
}

/// Points of a polyline are removed instead, since polylines contain no undefined heights.
/// @throws InvalidArgument for an empty region; UndefinedDataError if no defined point would remain.
[[nodiscard]] Processed apply(const MaskOut& step, topography::Measurement measurement, parallel::Threads threads = {});

}  // namespace setae::processing
