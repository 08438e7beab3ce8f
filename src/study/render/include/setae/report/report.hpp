// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/core/quantity.hpp"
#include "setae/study/study_result.hpp"
#include "setae/study_figures/study_figures.hpp"

namespace setae::report {

/// Run of a study, for its report.
struct RunRecord {
    std::string command;  ///< command that makes the report again, such as "setae study uncd.toml"
    std::string time;     ///< time of the run, ISO 8601 with offset, such as "2026-11-21T18:40:20Z"
};

/// A study as one self-contained HTML page: text, tables, interactive figures, styles and programs. It uses no network.
/// Equal arguments give equal bytes.
[[nodiscard]] std::string as_html(const study::StudyResult& result,
                                  const std::vector<study_figures::StudyFigure>& figures, const RunRecord& run);

/// A quantity within a sentence, as a report has it: "37.1 ± 2.1 mJ m⁻² (95 % interval 32.6 to 41.6 mJ m⁻²)".
[[nodiscard]] std::string as_html(const Quantity& quantity);

}  // namespace setae::report
