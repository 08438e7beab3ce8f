// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace setae::hysteresis {

/// k of W_ret − W_app = 2k U_el/A.
struct PinningCoefficient {
    double value = 0.0;           ///< k
    double standard_error = 0.0;  ///< between simulations and between bands
};

/// k of straight fronts on roughness that stores energy_share = U_el/(A W), >= 0, W what conforming gains.
///
///   k = 3.70 ± 0.4, 3.2 ± 0.3, 2.7 ± 0.15, 2.02 ± 0.05, 1.54 ± 0.05 at 0.003, 0.01, 0.03, 0.1, 0.3
///
/// linear in the logarithm between, constant beyond. Fronts on bands of 4 to 16 that are many Larkin lengths long.
/// Source of the law: Sanner, Kumar, Dhinojwala, Jacobs, Pastewka, Sci. Adv. 10 (2024) eadl1277; of k: simulated fronts
/// with the linear field of that paper; docs/measured/crack-front.md.
[[nodiscard]] PinningCoefficient pinning_coefficient(double energy_share);

/// The factor by which k may be wrong: relative standard error of pinning_coefficient() at this share.
[[nodiscard]] double pinning_uncertainty(double energy_share);

/// Both constants of simulated fronts.
///
///   W_appr = W − k_approach U_el/A,   W_ret = W + k_retraction U_el/A
struct PinningConstants {
    PinningCoefficient approach, retraction;
    bool measured = true;  ///< false outside the simulated range: the value is that of its border
};

/// Both constants of a front of a given number of Larkin lengths on roughness that stores a given share.
///
/// energy_share: U_el/(A W), >= 0.  larkin_lengths: π/(q_κ L_c), >= 0, with q_κ the stiffness of the sphere against
/// its contact radius; crack_front::larkin_lengths().
[[nodiscard]] PinningConstants pinning_constants(double energy_share, double larkin_lengths);

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
