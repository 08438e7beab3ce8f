// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/file_figures/look.hpp"
#include "setae/study_figures/loop_figures.hpp"

namespace setae::file_figures {

/// A loop with its fits: study_figures::loop_figures()'s "loop" in the requested width.
[[nodiscard]] StudyFigure loop_figure(const study_figures::DrawnLoop& loop, const Look& look);

}  // namespace setae::file_figures
