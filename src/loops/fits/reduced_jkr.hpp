// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/arrays.hpp"

/// JKR with one shape parameter, in which the others are linear.
///
/// With f = F/F_s for a scale F_s, p² = P/F_s, P = 3/2 πRW and L³ = 3RF_s/(4E*):
///
///   a = L A(f; p),  A = (p + √(f + p²))^(2/3)
///   δ = (L²/R) D(f; p) + δ0,  D = A² − 4/3 p √A
///
/// p = 0 is Hertz, where both are regular, and p < 0 continues them to contacts smaller than Hertz's (W < 0), so that a
/// fit near W = 0 needs no bound. Below the pull-off, f < −p², A and D keep their values there.
namespace setae::loops::reduced {

/// A value with its derivatives in p and f.
struct Point {
    double value = 0.0;
    double by_shape = 0.0;
    double by_force = 0.0;
};

[[nodiscard]] Point radius(double force, double shape);
[[nodiscard]] Point depth(double force, double shape);

/// Values along a branch, with their derivatives in p.
struct Curve {
    Array1D value;
    Array1D by_shape;
};
[[nodiscard]] Curve radii(const Array1D& force, double shape);
[[nodiscard]] Curve depths(const Array1D& force, double shape);

/// Values of the shape parameter that a search for the best one tries: 0 and logarithmic steps to 10, so that W from
/// far below to a hundred times what the force scale stands for is met.
[[nodiscard]] Array1D shape_candidates();

/// E* [Pa] from L [m], and W [J/m²] from p with the sign of p.
[[nodiscard]] double contact_modulus(double length, double force_scale, double sphere_radius);
[[nodiscard]] double work_of_adhesion(double shape, double force_scale, double sphere_radius);

}  // namespace setae::loops::reduced
