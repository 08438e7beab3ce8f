// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/traced_value.hpp"
#include "setae/fields/describe.hpp"
#include "setae/hysteresis/moving_edge.hpp"

namespace setae::hysteresis {

/// Work of a smooth edge of an elastomer divided by its W_app, with all inputs.
///
///   φ(v) = φ(0) [1 + (v/v0)^n]
struct TracedEdgeSpeed {
    TracedValue reference_speed;    ///< v0 [m/s]
    TracedValue exponent;           ///< n
    TracedValue rest_factor = 1.0;  ///< φ(0)
};

/// contact::RelaxationTerm with all inputs.
struct TracedRelaxation {
    TracedValue share;  ///< g
    TracedValue time;   ///< τ [s]
};

/// φ = measured W_ret divided by W from roughness, for one sphere in one testing machine, about one such W.
///
///   φ(W) = φ (W/W_0)^s
struct SpeedFactor {
    TracedValue factor;       ///< φ at W_0
    double work = 0.0;        ///< W_0 [J/m²]
    double slope = 0.0;       ///< s, usually < 0
    bool of_reading = false;  ///< W_0 is the W at which W_ret was measured, and changes with φ

    /// φ(W), of another value φ at W_0 within its ±. W <= 0 counts as W_0.
    [[nodiscard]] double at(double factor_there, double of_work) const;
    /// φ at constant measured W_ret: as φ increases, W_0 = W_ret/φ decreases, and φ changes with it.
    [[nodiscard]] double at_reading(double factor_there) const;
};

/// Sphere of a rate-dependent edge: inputs of speed_factor().
struct TracedSphere {
    TracedValue radius, contact_modulus;  ///< R [m], E* [Pa]
    TracedValue contact_radius;           ///< a_max [m], where the edge begins to retract
    TracedValue machine_stiffness = std::numeric_limits<double>::infinity();  ///< [N/m]
};

/// Motion of an edge and the reading of its W_ret.
struct EdgePull {
    double motor_speed = 0.0;   ///< [m/s], > 0
    double reading_time = 0.0;  ///< time of the last points [s]
    Reading reading = Reading::last_points;
};

/// φ about a W [J/m²], with its derivatives.
/// @throws InvalidArgument as edge_retraction().
[[nodiscard]] SpeedFactor speed_factor(const TracedSphere& sphere, const TracedEdgeSpeed& edge, const EdgePull& pull,
                                       double work);

/// φ for a known measured W_ret [J/m²]: W_0 = W_ret/φ. Derivatives are those at constant W_0.
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
