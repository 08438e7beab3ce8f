// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/loops/analysis.hpp"

namespace setae::loops {

/// Results of a loop on a smooth surface: without roughness both branches should give the same W.
struct ReferenceLoop {
    Estimate work_of_adhesion_loading;           ///< [J/m²]
    Estimate work_of_adhesion_retraction;        ///< Eq. S2, else the unloading fit [J/m²]
    double difference_in_standard_errors = 0.0;  ///< |difference| divided by its standard error
    Estimate excess_energy;                      ///< loop loss [J]
    double ideal_loss = 0.0;                     ///< loss of the smooth sphere's jumps [J]
    double beyond_ideal = 0.0;                   ///< excess energy minus ideal loss [J]
    double contact_area = 0.0;                   ///< contact area at the largest preload [m²]
};

/// @throws UndefinedDataError with the reason where the loop has no retraction or no energy.
[[nodiscard]] ReferenceLoop evaluate_reference(const LoopAnalysis& analysis);

/// Rough losses divided by the mean excess energy of the references.
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
