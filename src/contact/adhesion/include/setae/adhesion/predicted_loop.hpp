// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "setae/adhesion/prediction.hpp"

namespace setae::adhesion {

/// Loading of a soft sphere.
struct Press {
    TracedValue radius;    ///< R of the sphere [m], > 0
    double preload = 0.0;  ///< largest force [N], >= 0
};

/// A retraction predicted by one model.
struct RetractionPrediction {
    TracedValue energy_loss;   ///< ∮F dδ [J]
    Estimate work_retraction;  ///< W_ret at pull-off [J/m²]
    Estimate pull_off_force;   ///< 3/2 π R W_ret (Eq. S1) [N]
    /// pull-off force of the same model and sphere at r = 1, U_el = 0 [N]; JKR gives 3/2 π R W_int
    double smooth_pull_off_force = 0.0;
};

/// Predicted loop of a soft sphere that is pressed on a rough surface and pulled off.
struct PredictedLoop {
    Estimate contact_radius;  ///< a_max at the preload: Eq. 1 with W_app [m]
    /// W_ret = W_app: only the jumps dissipate energy. It is the only model without a measured retraction that tends to
    /// JKR as the roughness tends to zero, and a lower bound of W_ret. This is the predicted loop.
    RetractionPrediction reversible;
    /// E_loss = W_int r π a_max² (Eq. 10), for comparison only. It has no smooth limit: for a smooth sphere it gives
    /// W_int π a_max², whereas in JKR only the jumps dissipate energy.
    RetractionPrediction conformal_loss;
};

/// The loop of a pair.
///
/// W_app is that of the contact without load, partial_prediction(). By the true-area loss (Eq. 10) the edge stays at
/// the radius of the preload until G = W_ret, so that with the two jumps of JKR
///
///   E_loss = (W_ret − W_app) π a_max² + E_jump-in(W_app) + E_jump-out(W_ret),
///
/// which is solved for W_ret; the reversible loop has W_ret = W_app. Every standard error includes all inputs:
/// derivatives by E*, γ1, W_int and R are central differences over their standard errors, those by the spectrum come
/// from its spread. work_of_adhesion: W_int [J/m²], > 0.
/// Limit: r → 1, U_el → 0: W_ret = W_app = W_int, F = 3/2 π R W_int, E_loss = contact::jkr::ideal_loop_loss(). Empty
/// where W_app is 0: no contact forms.
/// @throws InvalidArgument for R <= 0 or a preload < 0.
/// Source: [D19], Eqs. 1, 10, S1; jumps: setae/contact/jkr.hpp.
[[nodiscard]] std::optional<PredictedLoop> predict_loop(const RoughSide& rough, const SoftSide& soft,
                                                        const TracedValue& work_of_adhesion, const Press& press);

}  // namespace setae::adhesion
