// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/core/quantity.hpp"
#include "setae/study/study_result.hpp"

namespace setae::output {

/// A predicted loop: contact_radius; energy_loss, work_of_adhesion_retraction, pull_off_force of the reversible loop
/// and the JKR force of a smooth sphere; those by the true-area loss (Eq. 10), conformal_….
[[nodiscard]] std::vector<Quantity> loop_quantities(const adhesion::PredictedLoop& loop);

/// W_app by the full-contact balance (Eq. 7) with the waves beyond both ends of the data:
/// work_of_adhesion_with_unmeasured_waves.
[[nodiscard]] Quantity unmeasured_quantity(const Estimate& work);

/// Adhesion of a soft solid on a surface, in sentences: the recommended W_app with its interval, area and band, the
/// formation of full contact, the effect of unmeasured waves, and the loop where one is predicted. For a study of one
/// pair.
[[nodiscard]] std::string adhesion_answer(const study::StudyResult& result);

}  // namespace setae::output
