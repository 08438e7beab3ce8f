// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <variant>

#include "setae/core/arrays.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::topography {

/// A sphere: t(r) = R − √(R² − r²) for r <= R, infinite beyond.
struct SphereTip {
    double radius = 0.0;  ///< R [m], > 0
};

/// A cone with a spherical end, tangent to the cone.
///
///   t(r) = R − √(R² − r²)                       for r <= R cos α
///        = R (1 − sin α) + (r − R cos α)/tan α  beyond
struct ConeTip {
    double half_angle = 0.0;  ///< α between axis and flank [rad], 0 < α < π/2
    double radius = 0.0;      ///< R of the end [m], >= 0; 0 is a sharp cone
};

/// A paraboloid: t(r) = r²/(2R).
struct ParabolicTip {
    double radius = 0.0;  ///< R of curvature at the apex [m], > 0
};

/// A measured or estimated tip: t at grid points, apex down.
struct ArrayTip {
    Array2D heights;                     ///< t [m] >= 0, 0 at the centre, infinite outside the tip
    std::array<double, 2> pixel_size{};  ///< along x and y [m]
    Index centre_x = 0, centre_y = 0;    ///< grid point of the apex
};

using Tip = std::variant<SphereTip, ConeTip, ParabolicTip, ArrayTip>;

/// Checks the domains above.
/// @throws InvalidArgument that names the parameter.
void validate(const Tip& tip);

/// Profile of an apex-down tip: its height t(r) >= 0 [m] above the apex at the distance r >= 0 [m] from its axis.
/// Infinite outside the tip.
/// @throws InvalidArgument outside the domain, and for an ArrayTip, which has no axis (see tip_image).
[[nodiscard]] double tip_height(const Tip& tip, double distance);

/// Largest distance [m] from the apex at which t <= `height` [m], height >= 0. For an ArrayTip the distance of the
/// farthest such grid point.
/// @throws InvalidArgument outside the domain.
[[nodiscard]] double tip_reach(const Tip& tip, double height);

/// R [m] of the paraboloid through the apex that fits the pixels within `reach` of it; undefined if they are level.
[[nodiscard]] double apex_radius(const ArrayTip& tip, Index reach = 2);

/// A tip from its picture, apex up, as written by `setae tip`: t below the highest point. Undefined heights are outside
/// the tip. @throws UndefinedDataError if no height is defined.
[[nodiscard]] ArrayTip tip_from_picture(const HeightMap& picture);

/// A tip on the pixels of a map.
struct TipImage {
    Array2D heights;  ///< t [m] at offsets (i − centre_x) pixel_x, (j − centre_y) pixel_y; infinite outside
    Index centre_x = 0, centre_y = 0;  ///< grid point of the apex
};

/// The tip at every grid point within `reach` [m] of its apex along x and along y.
///
/// An ArrayTip with other pixels is interpolated bilinearly; the result is infinite if one of the four neighbours is.
/// pixel_x, pixel_y [m], > 0.  reach >= 0.
/// @throws InvalidArgument outside the domain.
[[nodiscard]] TipImage tip_image(const Tip& tip, double pixel_x, double pixel_y, double reach);

}  // namespace setae::topography
