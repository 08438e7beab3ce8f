// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/adhesion/next_measurement.hpp"
#include "setae/study/study_result.hpp"

namespace setae::study {

/// Names of all inputs of the pairs of (7) that somebody stated with a ±, in alphabetical order: all but what spectra
/// and fits of loops bring. Nothing where (7) is not fitted.
[[nodiscard]] std::vector<std::string> stated_inputs(const StudyResult& result, const Conclusions& conclusions);

/// Everything that could be measured next for a study: every input at half its ±, one more loop on every pair, every
/// measured surface's measurements once more; with hours where the study tells what it costs.
[[nodiscard]] std::vector<adhesion::Candidate> candidates_of(const StudyResult& result);

/// How a target names a pair: "E07 on rough".
[[nodiscard]] std::string pair_target(const std::string& elastomer, const std::string& surface);

/// The number that a text names: "W_int"; W_app by (7) of a pair, "E07 on rough"; what W_int of one balance is more
/// than that of another, "(7) - (S13)", of (7), (2), (S13) and (10), W_int from losses.
/// @throws UndefinedDataError where the study fits no W_int, or not that of a balance; InvalidArgument for other texts.
[[nodiscard]] adhesion::Target target_of(const StudyResult& result, const std::string& text);

/// What each of them would leave of the ± of a target.
/// @throws as target_of().
[[nodiscard]] std::vector<adhesion::NextMeasurement> next_measurements(const StudyResult& result,
                                                                       const std::string& target);

}  // namespace setae::study
