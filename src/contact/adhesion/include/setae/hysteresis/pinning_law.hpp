// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <vector>

#include "setae/contact/elasticity.hpp"

namespace setae::hysteresis {

/// k of W_ret − W_app = 2k U_el/A.
struct PinningCoefficient {
    double value = 0.0;           ///< k
    double standard_error = 0.0;  ///< of the simulated fronts, and between bands
};

/// Both constants of simulated fronts.
///
///   W_appr = W − k_approach U_el/A,   W_ret = W + k_retraction U_el/A
struct PinningConstants {
    PinningCoefficient approach, retraction;
    bool measured = true;  ///< false outside the range of the simulated fronts: standard errors count the distance
};

/// Both constants of a front of a given number of Larkin lengths on roughness that stores a given share.
///
///   k = k∞ exp(−(N0/N)^0.68),   k∞ = 3.56/(1 + 2.66 s^0.70),   N0 = 0.965 (1 + 5.3 s^0.655)
///
/// energy_share: s = U_el/(A W), >= 0, W what full contact gains.  larkin_lengths: N = ℓ/L_c, >= 0, infinity for a
/// front without end, by crack_front::larkin_lengths(). The field of the fronts is as often above W as below, so both
/// constants are one number. It is fitted to 48 sets of fronts at rest on roughness of a band of 4, s = 0.001 … 0.3 and
/// N = 0.23 … 62, and meets each within its error. Fronts on bands of 16 and 32 have the k of 1.3 to 1.45 times as many
/// Larkin lengths; the standard error counts this.
/// Source of the law: Sanner, Kumar, Dhinojwala, Jacobs, Pastewka, Sci. Adv. 10 (2024) eadl1277; of k:
/// docs/validation/crack-front.md.
/// @throws InvalidArgument outside the domain.
[[nodiscard]] PinningConstants pinning_constants(double energy_share, double larkin_lengths);

/// The value of both constants, without their errors.
[[nodiscard]] double pinning_constant(double energy_share, double larkin_lengths);

/// Lengths [m] over which the sphere lets the edge of its contact bend, crack_front::free_length(). Infinity where no
/// sphere is known: an edge without end.
struct EdgeLengths {
    double approach = std::numeric_limits<double>::infinity();    ///< at the largest load
    double retraction = std::numeric_limits<double>::infinity();  ///< at pull-off under a dead load, (9πWR²/8E*)^⅓
};

/// Of JKR's contact. largest_radius: a [m] at the largest load, > 0; contact: R, E*, W > 0.
/// @throws InvalidArgument outside the domain.
[[nodiscard]] EdgeLengths edge_lengths(double largest_radius, const contact::AdhesiveContact& contact);

/// N of an edge: Larkin lengths within free_length.
///
///   N = ℓ/L_c,   L_c = λ̄ AW/(4 U_el)
///
/// free_length: ℓ [m]; infinity has N infinite.  mean_wavelength: λ̄ [m].  energy_share: U_el/(A W), >= 0; 0 has N = 0.
/// @throws InvalidArgument for a λ̄ that is not above 0, unless ℓ is infinite or nothing is stored.
[[nodiscard]] double edge_larkin_lengths(double free_length, double mean_wavelength, double energy_share);

/// Waves of a factor of 4 in wavevector.
struct PinningBand {
    double share = 0.0;            ///< of U_el
    double mean_wavelength = 0.0;  ///< λ̄ [m], weighed by U_el
};

/// Beyond this share of what it gains, roughness does not come into full contact of itself.
inline constexpr double conforming_energy_share = 0.3;

/// What roughness whose bands pin one after the other, finest first, each with its own k, takes off W on approach or
/// adds to it on retraction [J/m²].
///
///   Σ_b k(U_b/(A W), N_b) U_b/A
///
/// stored_energy: U_el/A of all waves [J/m²], >= 0.  work: W [J/m²], > 0.  free_length: ℓ [m] of the edge.
[[nodiscard]] double pinning_by_bands(double stored_energy, const std::vector<PinningBand>& bands, double work,
                                      double free_length);

}  // namespace setae::hysteresis
