// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/hysteresis/retraction_pair.hpp"

namespace setae::hysteresis {

/// Whether a model's W_ret tends to that of a smooth surface as roughness tends to zero.
///
///   r → 1, U_el → 0:  W_ret → φ W_app,  φ = 1 without the crack tip's own loss: JKR's pull-off
///
/// reversible and all kinds of pinning do. conformal_loss, fitted_conformal_loss and opening_work put a work on every
/// true area, that of a smooth surface among them, and do not.
[[nodiscard]] bool has_smooth_limit(const RetractionModel& model);

/// The model that stands where no measured retraction chooses one: reversible, the only one without a number of its own
/// that becomes JKR's and needs no simulation. W_ret = W_app is a lower bound.
[[nodiscard]] RetractionModel model_without_measurements();

/// A smooth reference on one elastomer, as measured.
struct SmoothReference {
    TracedValue work_approach, work_retraction;  ///< W_app, W_ret [J/m²]
};

/// A model against the smooth reference.
struct SmoothLimit {
    RetractionModel model;
    TracedValue work_retraction;     ///< W_ret by the model at r = 1, U_el = 0 [J/m²]
    TracedValue distance;            ///< less W_ret of the reference [J/m²]
    bool tends_to_reference = true;  ///< has_smooth_limit()
};

/// W_ret of a fitted model on a mirror of the reference's elastomer: r = 1, U_el = 0, full contact, W_app of the
/// reference in the place of the pair's, φ of the reference. The scatter of pairs is left out.
///
/// work_of_adhesion: W_int [J/m²], > 0, which conformal_loss counts per true area. jumps_per_area: what both jumps of
/// the sphere lose over π a_max² [J/m²], taken off by models of a whole loss; 0 where no sphere is given. A model with
/// the tip that depends on speed has the reference's own factor, as the reference's edge moves.
/// @throws InvalidArgument for works that are not positive.
[[nodiscard]] SmoothLimit smooth_limit(const FittedModel& fitted, const SmoothReference& reference,
                                       const TracedValue& work_of_adhesion, double jumps_per_area = 0.0);

}  // namespace setae::hysteresis
