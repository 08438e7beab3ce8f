// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/output/alert_groups.hpp"
#include "setae/study/study_result.hpp"

namespace setae::output {

/// The result of a study in sentences of plain text: symbols as "W_int", numbers with their unit.
struct Verdict {
    std::vector<std::string> answer;    ///< whether roughness explains the approach, W_int, retraction; at least one
    std::vector<std::string> findings;  ///< conclusions that tests support; may be empty
    std::vector<std::string> limits;    ///< limits of the conclusions with their reasons, worst first
    std::vector<std::string> reservations;  ///< the two most important limits that the answer does not state itself
};

/// The verdict from fits, tests and warnings.
///
/// Roughness explains the approach where the χ² of the full-contact balance (Eq. 7) with both errors has a probability
/// of at least 0.05; two works of adhesion are consistent where the 95 % interval of their difference covers 0. Their
/// errors are those of WorkFit::generalised, with the inputs that both share.
[[nodiscard]] Verdict verdict(const study::StudyResult& result);

/// Explanation, in sentences, of a pair that deviates by some standard errors from its prediction while the test of all
/// pairs is passed.
[[nodiscard]] std::string deviation_note(const adhesion::PredictionTest& test);

/// All alerts of a study by kind.
[[nodiscard]] std::vector<AlertGroup> grouped_alerts(const study::StudyResult& result);

}  // namespace setae::output
