// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "setae/adhesion/prediction.hpp"

namespace setae::adhesion {

/// How a soft sphere is pressed on.
struct Press {
    TracedValue radius;    ///< R of the sphere [m], > 0
    double preload = 0.0;  ///< largest force [N], >= 0
};

/// What a soft sphere does when it is pressed on a rough surface and pulled off, if (7) holds on approach and (10) for
/// the loss.
struct PredictedLoop {
    Estimate contact_radius;   ///< a_max at the preload: (1) with W_app [m]
    TracedValue energy_loss;   ///< E_loss = W_int r π a_max² (10), with every input it rests on [J]
    Estimate ideal_loss;       ///< what a smooth sphere of this W_app loses in its two jumps under fixed grips [J]
    Estimate work_retraction;  ///< W_ret of the pull-off, see below [J/m²]
    Estimate pull_off_force;   ///< 3/2 π R W_ret (S1) [N]
    Estimate pull_off_force_reversible;  ///< 3/2 π R W_app: if nothing but the jumps were lost [N]
};

/// The loop of a pair.
///
/// The edge stays where the preload left it until W_ret opens it, so that with the two jumps of JKR
///
///   E_loss = (W_ret − W_app) π a_max² + E_jump-in(W_app) + E_jump-out(W_ret),
///
/// which is solved for W_ret. Every ± is over all inputs: derivatives by E*, γ1, W_int and R are central differences
/// over their standard errors, those by the spectrum are of its spread. work_of_adhesion: W_int [J/m²], > 0. Nothing
/// where (7) says that the surfaces do not conform.
/// @throws InvalidArgument for R <= 0 or a preload < 0.
/// Source: [D19] (1), (7), (10), (S1); jumps: setae/contact/jkr.hpp.
[[nodiscard]] std::optional<PredictedLoop> predict_loop(const RoughSide& rough, const SoftSide& soft,
                                                        const TracedValue& work_of_adhesion, const Press& press);

}  // namespace setae::adhesion
