// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/study_figures/study_figures.hpp"

namespace setae::report {

/// Every figure with caption, buttons, data and the command that makes it again; of one that cannot be drawn, the
/// reason. report.js draws them from the JSON beside each. study: path of the study file, for the commands.
[[nodiscard]] std::string figures_html(const std::vector<study_figures::StudyFigure>& figures,
                                       const std::string& study);

}  // namespace setae::report
