// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/simulation/loop_truth.hpp"

namespace setae::simulation {

/// What pins the edge of a contact.
struct PinningRoughness {
    double work_approach = 0.0;  ///< W_app [J/m²], > 0
    double mean_work = 0.0;      ///< W the roughness modulates [J/m²], > 0
    double stored_energy = 0.0;  ///< U_el/A [J/m²], >= 0
};

/// W_ret [J/m²] of a contact edge that the roughness pins.
///
///   W_ret = W_app + 2 k U_el/A,   k(U_el/(A W)) = 3.70, 3.2, 2.7, 2.02, 1.54 at 0.003, 0.01, 0.03, 0.1, 0.3
///
/// k is linear in the logarithm between these values of simulated fronts (they scatter by ±0.15) and constant beyond.
/// @throws InvalidArgument outside the domains.
/// Source of the law: Sanner, Kumar, Dhinojwala, Jacobs, Pastewka, Sci. Adv. 10 (2024) eadl1277; of k: simulated
/// straight fronts with the linearised field of that paper, soft springs, fronts longer than the Larkin length.
[[nodiscard]] double work_retraction_by_pinning(const PinningRoughness& roughness);

/// W_ret [J/m²] with which the loop loses a given energy [J]; specimen.work_retraction is not looked at.
/// @throws InvalidArgument as loop_truth, and for a loss below that with W_ret = W_app, which the message names.
[[nodiscard]] double work_retraction_for_loss(LoopSpecimen specimen, const LoadingProtocol& protocol,
                                              double energy_loss);

}  // namespace setae::simulation
