// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/file_figures/look.hpp"
#include "setae/scales/function_of_scale.hpp"

namespace setae::file_figures {

/// A function of a distance of one or several measurements: solid where it is reliable, pale and dotted below.
///
/// combined: of several, black with one standard error between them; nullptr for one. The axis of values is
/// logarithmic where all of them are positive.
[[nodiscard]] StudyFigure scale_figure(const std::vector<scales::FunctionOfScale>& functions,
                                       const scales::CombinedFunction* combined, const Look& look);

}  // namespace setae::file_figures
