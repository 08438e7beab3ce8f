// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/traced_value.hpp"
#include "setae/fields/describe.hpp"
#include "setae/hysteresis/moving_edge.hpp"

namespace setae::hysteresis {

/// What a smooth edge of an elastomer needs over its W_app, with everything it rests on.
///
///   φ(v) = φ(0) [1 + (v/v0)^n]
struct TracedEdgeSpeed {
    TracedValue reference_speed;    ///< v0 [m/s]
    TracedValue exponent;           ///< n
    TracedValue rest_factor = 1.0;  ///< φ(0)
};

/// contact::RelaxationTerm likewise.
struct TracedRelaxation {
    TracedValue share;  ///< g
    TracedValue time;   ///< τ [s]
};

/// φ = W_ret as it is read over the W that roughness alone asks for, of one sphere in one machine, about one such W.
///
///   φ(W) = φ (W/W_0)^s
struct SpeedFactor {
    TracedValue factor;       ///< φ at W_0
    double work = 0.0;        ///< W_0 [J/m²]
    double slope = 0.0;       ///< s: < 0 as a rule
    bool of_reading = false;  ///< W_0 is where W_ret was read, and moves as φ does

    /// φ(W), of another value φ at W_0 within its ±. W <= 0 counts as W_0.
    [[nodiscard]] double at(double factor_there, double of_work) const;
    /// Where W_ret as it was read stays: as φ rises W_0 = W_ret/φ falls, and φ follows it.
    [[nodiscard]] double at_reading(double factor_there) const;
};

/// What an edge is pulled from: inputs of speed_factor().
struct TracedSphere {
    TracedValue radius, contact_modulus;  ///< R [m], E* [Pa]
    TracedValue contact_radius;           ///< a_max [m], where the edge begins to recede
    TracedValue machine_stiffness = std::numeric_limits<double>::infinity();  ///< [N/m]
};

/// How an edge is pulled and its W_ret read.
struct EdgePull {
    double motor_speed = 0.0;   ///< [m/s], > 0
    double reading_time = 0.0;  ///< of the last points [s]
    Reading reading = Reading::last_points;
};

/// φ about a W [J/m²], with its derivatives.
/// @throws InvalidArgument as recession().
[[nodiscard]] SpeedFactor speed_factor(const TracedSphere& sphere, const TracedEdgeSpeed& edge, const EdgePull& pull,
                                       double work);

/// φ where W_ret as it was read [J/m²] is known: W_0 = W_ret/φ. Derivatives are those at constant W_0.
/// @throws InvalidArgument as work_at_rest().
[[nodiscard]] SpeedFactor speed_factor_of_reading(const TracedSphere& sphere, const TracedEdgeSpeed& edge,
                                                  const EdgePull& pull, double work_read);

}  // namespace setae::hysteresis

namespace setae::fields {

template <>
struct Described<hysteresis::TracedRelaxation> {
    using T = hysteresis::TracedRelaxation;
    static constexpr std::array rows{quantity<&T::share>("share", "g", "1", "g"),
                                     quantity<&T::time>("time", "τ", "s", "τ")};
    static constexpr Description description{"", "term of E(t)/E∞ = 1 + Σ g e^(−t/τ)", rows};
};
static_assert(complete<hysteresis::TracedRelaxation>);

}  // namespace setae::fields
