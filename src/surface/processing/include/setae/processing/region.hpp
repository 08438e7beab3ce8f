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

/// From one position, height or percentile to another, both ends included; an end that is absent is open.
struct Range {
    std::optional<double> from;
    std::optional<double> to;

    friend bool operator==(const Range&, const Range&) = default;
};

/// Points with x and y in ranges [m]; of lines x alone.
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

/// Points of a map inside a polygon; where it crosses itself, by the even-odd rule. Corners in either sense, the last
/// joined to the first.
struct Polygon {
    std::vector<std::array<double, 2>> corners;  ///< [m], at least three

    friend bool operator==(const Polygon&, const Polygon&) = default;
};

/// Points whose height [m], as it is before the step, lies in a range.
struct HeightRange {
    Range heights;

    friend bool operator==(const HeightRange&, const HeightRange&) = default;
};

/// Points whose height lies between two percentiles (0 … 100) of the defined heights.
struct PercentileRange {
    Range percentiles;

    friend bool operator==(const PercentileRange&, const PercentileRange&) = default;
};

/// A choice of points, and by how many pixels it is grown: a point within so many rows and columns of a chosen one is
/// chosen too.
struct Shape {
    std::variant<Rectangle, Ellipse, Polygon, HeightRange, PercentileRange> outline;
    Index grow = 0;  ///< >= 0; of polylines points instead of pixels

    friend bool operator==(const Shape&, const Shape&) = default;
};

/// Which points count: those of any included shape (all points where none is given), less those of excluded shapes.
///
/// Positions are x_i = i · pixel size from the first point; of polylines the positions themselves.
struct Region {
    std::vector<Shape> include;
    std::vector<Shape> exclude;

    [[nodiscard]] bool everything() const { return include.empty() && exclude.empty(); }
    friend bool operator==(const Region&, const Region&) = default;
};

/// The points of a region, defined or not: 1 = chosen; shape (nx, ny) of a map, (n, 1) of a line or polyline. Undefined
/// points belong to no range of heights.
/// @throws InvalidArgument for a shape outside its domain, and for an ellipse, a polygon or a range of y on a line.
/// Cost: linear; percentiles select (linear too), polygons cost points × corners within their bounding box.
[[nodiscard]] topography::Mask mask_of(const Region& region, const topography::HeightMap& map,
                                       parallel::Threads threads = {});
[[nodiscard]] topography::Mask mask_of(const Region& region, const topography::LineScan& scan,
                                       parallel::Threads threads = {});
[[nodiscard]] topography::Mask mask_of(const Region& region, const topography::Profile& profile,
                                       parallel::Threads threads = {});

/// A region from text, as pipeline files and the command line have it: shapes separated by ";", each
///
///   include|exclude SHAPE [grow N]
///   SHAPE: rectangle 1 um to 5 um, 0 um to 2 um  ·  rectangle 1 um to 5 um  ·  ellipse 5 um, 5 um, 2 um, 1 um, 30 deg
///   (centre, semi-axes,
///          angle; the angle may be left out)  ·  polygon 0 um, 0 um, 4 um, 0 um, 2 um, 3 um  ·  heights above 20 nm  ·
///          heights below 5 nm  · heights 5 nm to 20 nm  ·  percentiles 5 to 95  ·  percentiles above 95
/// @throws InvalidArgument that names the shape it cannot read.
[[nodiscard]] Region region_from_text(std::string_view text);

/// The text region_from_text() reads back to the same region.
[[nodiscard]] std::string text(const Region& region);

/// The points of a region become undefined.
struct MaskOut {
    Region region;  ///< at least one shape
};

inline constexpr std::string_view step_name(const MaskOut&) { return "mask_out"; }
template <class Visitor>
void visit_parameters(MaskOut& step, Visitor& visitor) {
    visitor.region("region", step.region, "points that become undefined");
}

/// Points of a polyline are left out instead, since polylines hold no undefined heights.
/// @throws InvalidArgument for an empty region; UndefinedDataError where no defined point would be left.
[[nodiscard]] Processed apply(const MaskOut& step, topography::Measurement measurement, parallel::Threads threads = {});

}  // namespace setae::processing
