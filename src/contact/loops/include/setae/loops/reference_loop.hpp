// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/loops/analysis.hpp"

namespace setae::loops {

/// What a loop on a smooth surface says about the lens: with no roughness both branches should give the same W.
struct ReferenceLoop {
    Estimate work_of_adhesion_loading;           ///< [J/m²]
    Estimate work_of_adhesion_retraction;        ///< (S2), else the unloading fit's [J/m²]
    double difference_in_standard_errors = 0.0;  ///< |difference| over its standard error
    Estimate excess_energy;                      ///< loop loss [J]
    double ideal_loss = 0.0;                     ///< the smooth sphere's own jumps [J]
    double beyond_ideal = 0.0;                   ///< excess energy minus ideal loss [J]
    double contact_area = 0.0;                   ///< at the largest preload [m²]
};

/// @throws UndefinedDataError with the reason where the loop has no retraction or no energy.
[[nodiscard]] ReferenceLoop evaluate_reference(const LoopAnalysis& analysis);

/// Rough losses over the excess energy of the references (their mean).
/// @throws UndefinedDataError without references; InvalidArgument where their mean is not > 0.
[[nodiscard]] Array1D loss_ratios(const ArrayView1D& rough_losses, const std::vector<ReferenceLoop>& references);

/// Change of the lens between a reference before and one after the rough contacts.
struct ReferenceChange {
    Estimate work_of_adhesion_loading;     ///< after − before [J/m²]
    Estimate work_of_adhesion_retraction;  ///< after − before [J/m²]
    Estimate excess_energy;                ///< after − before [J]
};
[[nodiscard]] ReferenceChange change(const ReferenceLoop& before, const ReferenceLoop& after);

}  // namespace setae::loops
