// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/adhesion/balance_comparison.hpp"
#include "setae/adhesion/prediction.hpp"

namespace setae::adhesion {

/// Rough contact without load, approached from separated bodies.
struct UnloadedContact {
    double area_fraction = 1.0;  ///< contact area divided by the nominal area
    double area_error = 0.0;     ///< standard error of `area_fraction`
    /// gained energy divided by W, the gain of full contact; the full-contact balance (Eq. 7) gives 1 − e
    double gain = 1.0;
    double gain_error = 0.0;  ///< standard error of `gain`
    /// Mean pressure for contact on 99 % of the area, divided by U_el/(A h_rms); 0 for spontaneous full contact.
    double closing_pressure = 0.0;
};

/// The energy share up to which roughness comes into contact spontaneously on 99 % of its area.
inline constexpr double closing_energy_share = 0.25;

/// Unloaded contact from simulated patches that store energy_share = U_el/(A W) in full contact, e >= 0; W = W_int r −
/// γ1 (r − 1).
///
///   gain = 1 − e and area 1 up to e = 0.15; e = 0.5: 0.51 and 0.89; 1: 0.20 and 0.56; monotone cubics between
///
/// Self-affine patches, H = 0.8, in bands of 4 to 16, gain linear in ρ/h_rms and taken at 0.05; gain_error: difference
/// to the shortest simulated range, and error of the mean; area_error: half the span of ranges below 0.35 h_rms. Beyond
/// e = 3 gain and area decrease as e⁻³.
/// Source: docs/validation/conformity.md, `setae lab conform`.
[[nodiscard]] UnloadedContact unloaded_contact(double energy_share);

/// W_app = W gain(U_el/(A W)): the full-contact balance (Eq. 7) in full contact, and the gain of partial contact
/// otherwise.
/// gain: W = W_int r − γ1 (r − 1) [J/m²].  stored_energy: U_el/A [J/m²] >= 0.  0 for W <= 0.
/// patches: deviation of the simulated gain, in units of gain_error.
[[nodiscard]] double partial_balance(double gain, double stored_energy, double patches = 0.0);

/// A pair for the balance with partial contact.
struct PartialContactPoint {
    PairPoint gained;            ///< W as a line in W_int: slope r, offset γ1 (r − 1)
    double stored_energy = 0.0;  ///< U_el/A [J/m²]

    [[nodiscard]] double prediction(double work_of_adhesion) const;  ///< W_app [J/m²]
};

/// W_int by least squares. @throws InvalidArgument for fewer than two pairs.
[[nodiscard]] BalanceScore score_partial_contact(const std::vector<PartialContactPoint>& pairs);

/// W_app of a pair by that balance with all its inputs: linear about their values, with the error of the table as an
/// additional input.
[[nodiscard]] TracedValue partial_prediction(const RoughSide& rough, const SoftSide& soft, const TracedValue& work);

/// Name of the input that represents gain_error and area_error.
inline constexpr const char* simulated_patches_input = "simulated patches";

}  // namespace setae::adhesion
