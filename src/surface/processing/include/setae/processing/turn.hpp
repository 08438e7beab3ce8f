// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "setae/parallel/for_each.hpp"
#include "setae/processing/direction.hpp"

namespace setae::processing {

/// x and y of a map change places: h'(x, y) = h(y, x).
struct Transpose {};

/// Order of points reversed along a direction; lines and polylines have x alone.
struct Flip {
    Direction direction = Direction::x;
};

/// A map turned by 90° so many times from x towards y: h'(x, y) = h(y, L − x) for one turn, L the extent along x
/// afterwards.
struct QuarterTurns {
    Index turns = 1;  ///< any whole number, modulo 4
};

inline constexpr std::string_view step_name(const Transpose&) { return "transpose"; }
inline constexpr std::string_view step_name(const Flip&) { return "flip"; }
inline constexpr std::string_view step_name(const QuarterTurns&) { return "quarter_turns"; }
template <class Visitor>
void visit_parameters(Transpose&, Visitor&) {}
template <class Visitor>
void visit_parameters(Flip& step, Visitor& visitor) {
    visitor.choice("direction", step.direction, direction_names, "direction along which points change order");
}
template <class Visitor>
void visit_parameters(QuarterTurns& step, Visitor& visitor) {
    visitor.count("turns", step.turns, "turns by 90 degrees from x towards y; negative ones the other way");
}

/// @throws InvalidArgument for lines where the step needs a map.
[[nodiscard]] Processed apply(const Transpose& step, topography::Measurement measurement,
                              parallel::Threads threads = {});
[[nodiscard]] Processed apply(const Flip& step, topography::Measurement measurement, parallel::Threads threads = {});
[[nodiscard]] Processed apply(const QuarterTurns& step, topography::Measurement measurement,
                              parallel::Threads threads = {});

}  // namespace setae::processing
