// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

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
/// docs/measured/crack-front.md.
/// @throws InvalidArgument outside the domain.
[[nodiscard]] PinningConstants pinning_constants(double energy_share, double larkin_lengths);

/// k of a front without end, pinning_constants(energy_share, infinity).
[[nodiscard]] PinningCoefficient pinning_coefficient(double energy_share);

/// The factor by which k may be wrong: relative standard error of pinning_coefficient() at this share.
[[nodiscard]] double pinning_uncertainty(double energy_share);

/// Beyond this share of what it gains, roughness does not come into full contact of itself.
inline constexpr double conforming_energy_share = 0.3;

/// (W_ret − W_app) of roughness whose bands pin one after the other, finest first, each with its own k [J/m²].
///
///   Σ_b 2 k(U_b/(A W)) U_b/A
///
/// stored_energy: U_el/A of all waves [J/m²], >= 0.  band_shares: of it, by bands of a factor of 4.  work: W [J/m²], >
/// 0.
[[nodiscard]] double pinning_by_bands(double stored_energy, const std::vector<double>& band_shares, double work);

}  // namespace setae::hysteresis
