// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/study/study_result.hpp"

namespace setae::output {

/// The sentences of Verdict::answer.
[[nodiscard]] std::vector<std::string> answer_of(const study::StudyResult& result);

/// W_int of a fit as it is stated first: pairs of one surface or of one elastomer count as correlated where there are
/// groups to say how much, else as independent.
[[nodiscard]] const Estimate& work_of(const adhesion::WorkFit& fit);

/// The sentences of Verdict::limits.
[[nodiscard]] std::vector<std::string> limits_of(const study::StudyResult& result);

}  // namespace setae::output
