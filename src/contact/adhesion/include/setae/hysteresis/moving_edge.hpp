// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/arrays.hpp"
#include "setae/hysteresis/sphere_loop.hpp"

namespace setae::hysteresis {

/// Rate dependence of the contact edge of an elastomer.
///
///   G(v) = W_ret [1 + (v/v0)^n],  v: speed of the edge,  W_ret: value at zero speed
///
/// Source: contact::crack_speed, whose threshold is W_ret.
struct EdgeSpeed {
    double reference_speed = 0.0;  ///< v0 [m/s], > 0
    double exponent = 0.0;         ///< n, > 0
};

/// A rate-dependent edge with the speeds of the testing machine.
struct MovingEdge {
    EdgeSpeed law;
    double motor_speed = 0.0;   ///< [m/s], > 0
    double reading_time = 0.0;  ///< time before the smallest force over which the experiment determines W_ret [s], >= 0
};

/// Retraction of a rate-dependent edge, from the first motion of the edge to separation.
struct EdgeRetraction {
    double smallest_force = 0.0;  ///< [N]
    double work_read = 0.0;       ///< mean of G over the reading time: W_ret as the experiment determines it [J/m²]
    double edge_work = 0.0;       ///< ∫ G dA, total work at the edge [J]
};

/// Retraction under a motor at constant speed, m = δ + F/k_m,
///
///   dm/da = V/v(G),  G = E* (δ − a²/R)²/(2πa),  F = 2aE* (δ − a²/3R)
///
/// by Euler's implicit rule in steps of a, twice, and extrapolated: forces within 10⁻⁴, work within 10⁻³. The edge has
/// no instability; it moves at a finite speed. v0 → ∞ is sphere_loop(), with the jump's energy in edge_work.
/// sphere.work_retraction: W_ret at zero speed.
/// @throws InvalidArgument as sphere_loop(), and for an edge outside its domain.
[[nodiscard]] EdgeRetraction edge_retraction(const HystereticSphere& sphere, const Pressing& pressing,
                                             const MovingEdge& edge);

/// States of the retracting edge, one per step, from the largest contact radius to 0.
struct EdgeRetractionCourse {
    Array1D motor, displacement, contact_radius;  ///< m, δ, a [m]
    Array1D force;                                ///< [N]
    Array1D energy_release_rate;  ///< G [J/m²]; for the last state, without contact, the value before it
};

/// The same equations with a given number of steps, without extrapolation. @throws as edge_retraction(), and for fewer
/// than 8 steps.
[[nodiscard]] EdgeRetractionCourse edge_retraction_course(const HystereticSphere& sphere, const Pressing& pressing,
                                                          const MovingEdge& edge, int steps);

/// Method by which one W_ret is determined from a rate-dependent edge.
enum class Reading {
    last_points,     ///< EdgeRetraction::work_read, as in Eq. S2
    smallest_force,  ///< 2|F|/(3πR), as in Eq. S1
    loop_area,       ///< W_ret of a rate-independent edge with the same energy loss of the loop
};

/// W_ret [J/m²] by a method of reading. @throws as edge_retraction().
[[nodiscard]] double work_read(const HystereticSphere& sphere, const Pressing& pressing, const MovingEdge& edge,
                               Reading reading);

/// W_ret at zero speed [J/m²] for which the experiment gives work_read; it is smaller than work_read.
/// sphere.work_retraction is not used. @throws as edge_retraction().
[[nodiscard]] double work_at_rest(HystereticSphere sphere, const Pressing& pressing, const MovingEdge& edge,
                                  Reading reading, double work_read);

/// The loop of sphere_loop() with a rate-dependent edge: its smallest force, and speed_loss in addition to the losses
/// of edge and jumps.
/// @throws as edge_retraction().
[[nodiscard]] SphereLoop sphere_loop(const HystereticSphere& sphere, const Pressing& pressing, const MovingEdge& edge);

}  // namespace setae::hysteresis
