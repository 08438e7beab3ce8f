// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/study/study_result.hpp"

namespace setae::output {

/// The sentences of Verdict::answer.
[[nodiscard]] std::vector<std::string> answer_of(const study::StudyResult& result);

/// The sentences of Verdict::limits.
[[nodiscard]] std::vector<std::string> limits_of(const study::StudyResult& result);

}  // namespace setae::output
