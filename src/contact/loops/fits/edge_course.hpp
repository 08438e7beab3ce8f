// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include <Eigen/Core>

#include "setae/contact/crack_speed.hpp"
#include "setae/loops/crack_speed_fit.hpp"

namespace setae::loops {

/// Parameters of the course of an edge.
struct EdgeParameters {
    double first_radius = 0.0;     ///< a at the first sample [m]
    double contact_modulus = 0.0;  ///< E* [Pa]
    contact::crack_speed::Law law;
};

/// a(t) of a retracting edge at every sample, and its derivatives by ln a(0), ln E*, ln G0, ln v0 and ln n.
struct EdgeCourse {
    static constexpr int parameters = 5;
    Array1D contact_radius;                                          ///< [m]; NaN from where the edge ran away
    Array1D speed;                                                   ///< v [m/s]
    Eigen::Matrix<double, Eigen::Dynamic, parameters> by_logarithm;  ///< [m]
};

/// da/dt = −v(G(a, F(t))) by the trapezoidal rule, F straight between its samples, at least 2000 steps in all; the
/// derivatives are those of the rule's own solution.
[[nodiscard]] EdgeCourse edge_course(const RetractingEdge& edge, double radius, const EdgeParameters& parameters);

}  // namespace setae::loops
