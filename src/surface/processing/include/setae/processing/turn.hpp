// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "setae/parallel/for_each.hpp"
#include "setae/processing/direction.hpp"

namespace setae::processing {

/// Exchanges x and y of a map: h'(x, y) = h(y, x).
struct Transpose {};

/// Reverses the order of points along a direction; lines and polylines have x only.
struct Flip {
    Direction direction = Direction::x;
};

/// Rotates a map by multiples of 90° from x towards y: h'(x, y) = h(y, L − x) for one quarter turn, L the extent along
/// x afterwards.
struct QuarterTurns {
    Index turns = 1;  ///< any integer, modulo 4
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

/// @throws InvalidArgument for lines if the step needs a map.
[[nodiscard]] Processed apply(const Transpose& step, topography::Measurement measurement,
                              parallel::Threads threads = {});
[[nodiscard]] Processed apply(const Flip& step, topography::Measurement measurement, parallel::Threads threads = {});
[[nodiscard]] Processed apply(const QuarterTurns& step, topography::Measurement measurement,
                              parallel::Threads threads = {});

}  // namespace setae::processing
