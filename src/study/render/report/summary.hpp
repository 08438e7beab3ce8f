// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "setae/output/json.hpp"
#include "setae/study/study_result.hpp"

namespace setae::report {

/// The verdict in the terminal's words, the studied data and failures.
[[nodiscard]] std::string verdict_html(const study::StudyResult& result);

/// The intrinsic work of adhesion by both ways and each surface's roughness, in sentences with numbers.
[[nodiscard]] std::string numbers_html(const study::StudyResult& result, const output::Json& study);

/// Conclusions that tests support, then limits of the study, with reasons.
[[nodiscard]] std::string limits_html(const study::StudyResult& result);

}  // namespace setae::report
