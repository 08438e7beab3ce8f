// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/arrays.hpp"

/// Energy release rate of a viscoelastic solid at its moving contact edge.
///
/// Speeds are those of a retracting edge (a shrinking contact), >= 0. Valid while the bulk away from the edge is
/// elastic. Sources: Maugis, Barquins, J. Phys. D 11 (1978) 1989; Gent, Schultz, J. Adhesion 3 (1972) 281.
namespace setae::contact::crack_speed {

/// G(v) = G0 [1 + (v/v0)^n].
struct Law {
    double threshold = 0.0;        ///< G0 [J/m²], > 0: the energy release rate of an edge at rest
    double reference_speed = 0.0;  ///< v0 [m/s], > 0: the speed at which G doubles
    double exponent = 0.0;         ///< n, > 0; 0.1 to 1 are usual, about 0.6 for rubbers
};

/// Energy release rate G(v) = G0 [1 + (v/v0)^n] [J/m²] at speed v [m/s], >= 0.
/// @throws InvalidArgument for v < 0 or a law outside its domain.
[[nodiscard]] double energy_release_rate(double speed, const Law& law);
[[nodiscard]] Array1D energy_release_rate(const ArrayView1D& speed, const Law& law);

/// Speed v = v0 (G/G0 − 1)^(1/n) [m/s] at energy release rate G [J/m²]; NaN for G < G0, where the edge does not
/// retract. @throws InvalidArgument for a law outside its domain.
[[nodiscard]] double speed(double energy_release_rate, const Law& law);
[[nodiscard]] Array1D speed(const ArrayView1D& energy_release_rate, const Law& law);

/// Derivative dG/dv = (n G0/v0) (v/v0)^(n − 1) [J s/m³] at speed v [m/s], >= 0; infinite at v = 0 for n < 1.
/// @throws InvalidArgument for v < 0 or a law outside its domain.
[[nodiscard]] double energy_release_rate_derivative(double speed, const Law& law);

}  // namespace setae::contact::crack_speed
