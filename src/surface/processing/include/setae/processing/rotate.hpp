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

/// Rotates a map about its centre, in its plane.
///
///   h'(x) = h(R(−angle) (x − c) + c),  c: the middle between the first and the last point, R: from x towards y
///
/// A rotation from x towards y is clockwise in a picture whose y runs down. Points outside the map are undefined; with
/// `crop` only the largest rectangle around the centre inside the rotated map is kept, with the same pixels. The result
/// is not periodic; a periodic map ends at its sides. Rotations by multiples of 90° move points without interpolation,
/// exchange the sides and keep periodic maps periodic.
struct Rotate {
    double angle = 0.0;  ///< [rad]
    Rotation method = Rotation::linear;
    bool crop = false;  ///< keep only the inscribed rectangle
};

/// @throws InvalidArgument for an angle that is not finite, or if cropping leaves fewer than two points per direction.
[[nodiscard]] topography::HeightMap rotated(topography::HeightMap map, const Rotate& turn,
                                            parallel::Threads threads = {});

/// @throws InvalidArgument also for lines, which cannot be rotated in a plane.
[[nodiscard]] Processed apply(const Rotate& step, topography::Measurement measurement, parallel::Threads threads = {});

inline constexpr std::string_view step_name(const Rotate&) { return "rotate"; }
template <class Visitor>
void visit_parameters(Rotate& step, Visitor& visitor) {
    visitor.angle("angle", step.angle, "from x towards y");
    visitor.choice("method", step.method, rotation_names, "how heights between points are found");
    visitor.flag("crop", step.crop, "whether only the inscribed rectangle is kept");
}

}  // namespace setae::processing
