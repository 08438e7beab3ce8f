// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "setae/output/json.hpp"
#include "setae/study/study_result.hpp"

namespace setae::report {

/// The verdict, what was studied, what failed, the intrinsic work of adhesion by both ways and each surface's roughness, in
/// sentences with numbers.
[[nodiscard]] std::string summary_html(const study::StudyResult& result, const output::Json& study);

/// What the study cannot tell, and why: a list, or a sentence where it has nothing to complain of.
[[nodiscard]] std::string limits_html(const study::StudyResult& result);

}  // namespace setae::report
