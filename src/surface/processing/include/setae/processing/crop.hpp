// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include "setae/parallel/for_each.hpp"
#include "setae/processing/processed.hpp"

namespace setae::processing {

/// A window of the measurement: from and to [m], ends included, open if absent; or numbers of points removed at each
/// side.
///
/// Positions are x_i = i · pixel size. Positions of the result begin at 0; the record contains the position in the map.
/// Polylines keep their positions. The result is periodic only if nothing was removed.
struct Crop {
    std::optional<double> x_from, x_to, y_from, y_to;
    Index cut_left = 0;   ///< at the beginning of x, >= 0
    Index cut_right = 0;  ///< at the end of x
    Index cut_first = 0;  ///< at the beginning of y
    Index cut_last = 0;   ///< at the end of y
};

inline constexpr std::string_view step_name(const Crop&) { return "crop"; }
template <class Visitor>
void visit_parameters(Crop& step, Visitor& visitor) {
    visitor.optional_length("x_from", step.x_from, "beginning of the window along x");
    visitor.optional_length("x_to", step.x_to, "its end");
    visitor.optional_length("y_from", step.y_from, "beginning of the window along y");
    visitor.optional_length("y_to", step.y_to, "its end");
    visitor.count("cut_left", step.cut_left, "points cut off at the beginning of x");
    visitor.count("cut_right", step.cut_right, "points cut off at the end of x");
    visitor.count("cut_first", step.cut_first, "scan lines cut off at the beginning of y");
    visitor.count("cut_last", step.cut_last, "scan lines cut off at the end of y");
}

/// @throws InvalidArgument for a window with fewer than two points along a direction, for a direction given in metres
/// and points at once, for y of a line.
[[nodiscard]] Processed apply(const Crop& step, topography::Measurement measurement, parallel::Threads threads = {});

}  // namespace setae::processing
