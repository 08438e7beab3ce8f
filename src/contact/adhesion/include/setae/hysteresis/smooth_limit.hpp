// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/hysteresis/retraction_pair.hpp"

namespace setae::hysteresis {

/// Whether a model's W_ret tends to that of a smooth surface as roughness tends to zero.
///
///   r → 1, U_el → 0:  W_ret → φ W_app,  φ = 1 without the loss at the crack tip: JKR's pull-off
///
/// True for reversible and all kinds of pinning. False for conformal_loss, fitted_conformal_loss and opening_work:
/// their work per unit true area does not vanish for a smooth surface.
[[nodiscard]] bool has_smooth_limit(const RetractionModel& model);

/// The model that is used without a measured retraction: reversible, the only one without a fitted parameter that tends
/// to JKR and needs no simulation. W_ret = W_app is a lower bound.
[[nodiscard]] RetractionModel model_without_measurements();

/// A measured smooth reference on one elastomer.
struct SmoothReference {
    TracedValue work_approach, work_retraction;  ///< W_app, W_ret [J/m²]
};

/// Comparison of a model with the smooth reference.
struct SmoothLimit {
    RetractionModel model;
    TracedValue work_retraction;     ///< W_ret by the model at r = 1, U_el = 0 [J/m²]
    TracedValue distance;            ///< minus W_ret of the reference [J/m²]
    bool tends_to_reference = true;  ///< has_smooth_limit()
};

/// W_ret of a fitted model for a smooth surface on the reference's elastomer: r = 1, U_el = 0, full contact, W_app of
/// the reference in place of that of the pair, φ of the reference. The scatter of pairs is left out.
///
/// work_of_adhesion: W_int [J/m²], > 0, per unit true area in conformal_loss. jumps_per_area: loss of both jumps of the
/// sphere divided by π a_max² [J/m²], subtracted by models of the whole loss; 0 where no sphere is given. A model with
/// the rate-dependent tip has the factor of the reference at the speed of the reference's edge.
/// @throws InvalidArgument for works that are not positive.
[[nodiscard]] SmoothLimit smooth_limit(const FittedModel& fitted, const SmoothReference& reference,
                                       const TracedValue& work_of_adhesion, double jumps_per_area = 0.0);

}  // namespace setae::hysteresis
