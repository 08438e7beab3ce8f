// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/parallel/for_each.hpp"
#include "setae/study_figures/study_figures.hpp"

namespace setae::cli {

/// Name of a loop in figures: its file without folder and ending.
[[nodiscard]] std::string figure_name(const std::string& file);

/// Writes figures to a folder; figures that cannot be drawn are reported on standard error.
void write_loop_figures(const std::vector<study_figures::StudyFigure>& figures, const std::string& folder,
                        parallel::Threads threads);

}  // namespace setae::cli
