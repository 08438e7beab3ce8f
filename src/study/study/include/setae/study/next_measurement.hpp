// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/adhesion/next_measurement.hpp"
#include "setae/study/study_result.hpp"

namespace setae::study {

/// Names of all inputs with a stated standard error of the pairs of the full-contact balance (Eq. 7), in alphabetical
/// order, without inputs from spectra and fits of loops. Empty where Eq. 7 is not fitted.
[[nodiscard]] std::vector<std::string> stated_inputs(const StudyResult& result, const Conclusions& conclusions);

/// All possible next measurements of a study: every input with half its standard error, one more loop on every pair, a
/// repetition of every measured surface's measurements; with hours where the study states the cost.
[[nodiscard]] std::vector<adhesion::Candidate> candidates_of(const StudyResult& result);

/// Name of a pair as a target: "E07 on rough".
[[nodiscard]] std::string pair_target(const std::string& elastomer, const std::string& surface);

/// The number with a given name: "W_int"; W_app of a pair by Eq. 7, "E07 on rough"; W_int of one balance minus that of
/// another, "(7) - (S13)", for (7), (2), (S13) and (10), W_int from losses.
/// @throws UndefinedDataError where the study fits no W_int, or not that of a balance; InvalidArgument for other texts.
[[nodiscard]] adhesion::Target target_of(const StudyResult& result, const std::string& text);

/// Standard error of a target with each of these measurements.
/// @throws as target_of().
[[nodiscard]] std::vector<adhesion::NextMeasurement> next_measurements(const StudyResult& result,
                                                                       const std::string& target);

}  // namespace setae::study
