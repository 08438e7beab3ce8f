// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/arrays.hpp"
#include "setae/hysteresis/sphere_loop.hpp"

namespace setae::hysteresis {

/// How much more energy an edge asks for the faster it recedes: an elastomer's.
///
///   G(v) = W_ret [1 + (v/v0)^n],  v: speed of the edge,  W_ret: what it needs at rest
///
/// Source: contact::crack_speed, whose threshold is W_ret.
struct EdgeSpeed {
    double reference_speed = 0.0;  ///< v0 [m/s], > 0
    double exponent = 0.0;         ///< n, > 0
};

/// Such an edge as a machine pulls it.
struct MovingEdge {
    EdgeSpeed law;
    double motor_speed = 0.0;   ///< [m/s], > 0
    double reading_time = 0.0;  ///< before the smallest force, over which experiment reads W_ret [s], >= 0
};

/// What such an edge does from where it begins to recede until nothing touches.
struct Recession {
    double smallest_force = 0.0;  ///< [N]
    double work_read = 0.0;       ///< mean of G over the reading time: W_ret as experiment reads it [J/m²]
    double edge_work = 0.0;       ///< ∫ G dA, what the edge takes in all [J]
};

/// Under a motor that recedes at constant speed, m = δ + F/k_m,
///
///   dm/da = V/v(G),  G = E* (δ − a²/R)²/(2πa),  F = 2aE* (δ − a²/3R)
///
/// by Euler's implicit rule in steps of a, twice, and extrapolated: forces within 10⁻⁴, work within 10⁻³. The edge has
/// no instability to jump over; it runs. v0 → ∞ is sphere_loop(), with the jump's energy in edge_work.
/// sphere.work_retraction: W_ret at rest.
/// @throws InvalidArgument as sphere_loop(), and for an edge outside its domain.
[[nodiscard]] Recession recession(const HystereticSphere& sphere, const Pressing& pressing, const MovingEdge& edge);

/// States of the receding edge, one a step, from the largest contact radius to 0.
struct RecessionCourse {
    Array1D motor, displacement, contact_radius;  ///< m, δ, a [m]
    Array1D force;                                ///< [N]
    Array1D energy_release_rate;                  ///< G [J/m²]; of the last state, without contact, that before it
};

/// The same equations in so many steps, not extrapolated. @throws as recession(), and for fewer than 8 steps.
[[nodiscard]] RecessionCourse recession_course(const HystereticSphere& sphere, const Pressing& pressing,
                                               const MovingEdge& edge, int steps);

/// How one W_ret is read from an edge that needs another at every speed.
enum class Reading {
    last_points,     ///< Recession::work_read, as (S2) does
    smallest_force,  ///< 2|F|/(3πR), as (S1) does
    loop_area,       ///< that of an edge at rest with which the loop would lose as much
};

/// W_ret [J/m²] as it is read. @throws as recession().
[[nodiscard]] double work_read(const HystereticSphere& sphere, const Pressing& pressing, const MovingEdge& edge,
                               Reading reading);

/// W_ret at rest [J/m²] of which experiment reads work_read: below it. sphere.work_retraction is not looked at.
/// @throws as recession().
[[nodiscard]] double work_at_rest(HystereticSphere sphere, const Pressing& pressing, const MovingEdge& edge,
                                  Reading reading, double work_read);

/// The loop of sphere_loop() with such an edge: its smallest force, and speed_loss beside the edge's and the jumps'
/// own.
/// @throws as recession().
[[nodiscard]] SphereLoop sphere_loop(const HystereticSphere& sphere, const Pressing& pressing, const MovingEdge& edge);

}  // namespace setae::hysteresis
