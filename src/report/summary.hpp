// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "setae/workflow/json.hpp"
#include "setae/workflow/study_result.hpp"

namespace setae::report {

/// What was studied, what failed, the intrinsic work of adhesion by both ways and each surface's roughness, in sentences with numbers.
[[nodiscard]] std::string summary_html(const workflow::StudyResult& result, const workflow::Json& study);

/// What the study cannot tell, and why: a list, or a sentence where it has nothing to complain of.
[[nodiscard]] std::string limits_html(const workflow::StudyResult& result, const workflow::Json& study);

}  // namespace setae::report
