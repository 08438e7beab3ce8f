// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "setae/output/json.hpp"
#include "setae/study/study_result.hpp"

namespace setae::report {

/// Retraction of pairs, folded: the best retraction model, its predictions for each pair, the energy budgets. Empty
/// where the study has no W_int. `study` is output::to_json(result), figures: HTML.
[[nodiscard]] std::string retraction_html(const study::StudyResult& result, const output::Json& study,
                                          const std::string& figures);

}  // namespace setae::report
