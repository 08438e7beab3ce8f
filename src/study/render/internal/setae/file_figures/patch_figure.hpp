// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/file_figures/look.hpp"
#include "setae/patches/survey.hpp"

namespace setae::file_figures {

/// Gained energy and contact area of patches against the energy share, with the full-contact balance (Eq. 7).
[[nodiscard]] StudyFigure patch_figure(const std::vector<patches::SurveyRow>& rows, const Look& look);

}  // namespace setae::file_figures
