// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/adhesion/next_measurement.hpp"
#include "setae/study/study_result.hpp"

namespace setae::study {

/// Everything that could be measured next for a study: every input at half its ±, one more loop on every pair, every
/// measured surface's measurements once more; with hours where the study tells what it costs.
[[nodiscard]] std::vector<adhesion::Candidate> candidates_of(const StudyResult& result);

/// What each of them would leave of the ± of W_int (target "W_int"), or of W_app by (7) of a pair ("E07 on rough").
/// @throws UndefinedDataError where the study fits no W_int; InvalidArgument for a target that is no pair of it.
[[nodiscard]] std::vector<adhesion::NextMeasurement> next_measurements(const StudyResult& result,
                                                                       const std::string& target);

}  // namespace setae::study
