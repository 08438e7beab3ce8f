// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>

#include "setae/parallel/for_each.hpp"
#include "setae/processing/parameters.hpp"
#include "setae/processing/processed.hpp"

namespace setae::processing {

enum class Rotation { linear, bicubic };
inline constexpr std::array<Choice<Rotation>, 2> rotation_names{
    {{"linear", Rotation::linear}, {"bicubic", Rotation::bicubic}}};

/// A map turned about its centre, in its own plane.
///
///   h'(x) = h(R(−angle) (x − c) + c),  c: the middle between the first and the last point, R: from x towards y
///
/// A turn from x towards y is clockwise in a picture whose y runs down. Points outside the map are undefined; with
/// `crop` the largest rectangle with the map's centre that lies within the turned map is left, on the same pixels.
/// Otherwise not periodic afterwards; a periodic map ends at its sides. Turns by whole quarters move points without
/// interpolation, exchange the sides and keep periodic maps periodic.
struct Rotate {
    double angle = 0.0;  ///< [rad]
    Rotation method = Rotation::linear;
    bool crop = false;  ///< keep the inscribed rectangle alone
};

/// @throws InvalidArgument for an angle that is not finite, or where cropping leaves fewer than two points a direction.
[[nodiscard]] topography::HeightMap rotated(topography::HeightMap map, const Rotate& turn,
                                            parallel::Threads threads = {});

/// @throws InvalidArgument also for lines, which cannot be turned in a plane.
[[nodiscard]] Processed apply(const Rotate& step, topography::Measurement measurement, parallel::Threads threads = {});

inline constexpr std::string_view step_name(const Rotate&) { return "rotate"; }
template <class Visitor>
void visit_parameters(Rotate& step, Visitor& visitor) {
    visitor.angle("angle", step.angle, "from x towards y");
    visitor.choice("method", step.method, rotation_names, "how heights between points are found");
    visitor.flag("crop", step.crop, "whether only the inscribed rectangle is kept");
}

}  // namespace setae::processing
