// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <vector>

#include "setae/contact/elasticity.hpp"

namespace setae::hysteresis {

/// Pinning coefficient k of W_ret − W_app = 2k U_el/A.
struct PinningCoefficient {
    double value = 0.0;           ///< k
    double standard_error = 0.0;  ///< standard error, including that of the simulated fronts and that between bands
};

/// Both constants of simulated fronts.
///
///   W_appr = W − k_approach U_el/A,   W_ret = W + k_retraction U_el/A
struct PinningConstants {
    PinningCoefficient approach, retraction;
    bool measured = true;  ///< false outside the range of the simulated fronts: standard errors include the distance
};

/// Both constants of a front of a given number of Larkin lengths on roughness with a given energy share.
///
///   k = k∞ exp(−(N0/N)^0.68),   k∞ = 3.56/(1 + 2.66 s^0.70),   N0 = 0.965 (1 + 5.3 s^0.655)
///
/// energy_share: s = U_el/(A W), >= 0, W the energy gained in full contact.  larkin_lengths: N = ℓ/L_c, >= 0, infinity
/// for an endless front, by crack_front::larkin_lengths(). The field of the fronts is symmetric about W, so both
/// constants are equal. The formula is fitted to 48 sets of fronts at rest on roughness of a band of 4, s = 0.001 … 0.3
/// and N = 0.23 … 62, and agrees with each within its error. Fronts on bands of 16 and 32 have the k of 1.3 to 1.45
/// times as many Larkin lengths; the standard error includes this.
/// Source of the pinning model: Sanner, Kumar, Dhinojwala, Jacobs, Pastewka, Sci. Adv. 10 (2024) eadl1277; of k:
/// docs/validation/crack-front.md.
/// @throws InvalidArgument outside the domain.
[[nodiscard]] PinningConstants pinning_constants(double energy_share, double larkin_lengths);

/// The value of both constants, without their errors.
[[nodiscard]] double pinning_constant(double energy_share, double larkin_lengths);

/// Lengths [m] over which the sphere allows the contact edge to bend, crack_front::free_length(). Infinity for an
/// unknown sphere: an endless edge.
struct EdgeLengths {
    double approach = std::numeric_limits<double>::infinity();  ///< length at the largest load
    /// length at pull-off under a dead load, (9πWR²/8E*)^⅓
    double retraction = std::numeric_limits<double>::infinity();
};

/// Edge lengths of JKR's contact. largest_radius: a [m] at the largest load, > 0; contact: R, E*, W > 0.
/// @throws InvalidArgument outside the domain.
[[nodiscard]] EdgeLengths edge_lengths(double largest_radius, const contact::AdhesiveContact& contact);

/// Number N of Larkin lengths of an edge within free_length.
///
///   N = ℓ/L_c,   L_c = λ̄ AW/(4 U_el)
///
/// free_length: ℓ [m]; infinity has N infinite.  mean_wavelength: λ̄ [m].  energy_share: U_el/(A W), >= 0; 0 has N = 0.
/// @throws InvalidArgument for λ̄ <= 0, unless ℓ is infinite or the energy share is 0.
[[nodiscard]] double edge_larkin_lengths(double free_length, double mean_wavelength, double energy_share);

/// Waves within a factor of 4 in wavevector.
struct PinningBand {
    double share = 0.0;            ///< share of U_el
    double mean_wavelength = 0.0;  ///< mean wavelength λ̄ [m], weighted by U_el
};

/// Energy share above which roughness does not come into full contact spontaneously.
inline constexpr double full_contact_energy_share = 0.3;

/// Decrease of W on approach, or increase on retraction [J/m²], for roughness whose bands pin one after the other,
/// finest first, each with its own k.
///
///   Σ_b k(U_b/(A W), N_b) U_b/A
///
/// stored_energy: U_el/A of all waves [J/m²], >= 0.  work: W [J/m²], > 0.  free_length: ℓ [m] of the edge.
[[nodiscard]] double pinning_by_bands(double stored_energy, const std::vector<PinningBand>& bands, double work,
                                      double free_length);

}  // namespace setae::hysteresis
