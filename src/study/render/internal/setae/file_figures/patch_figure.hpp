// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/file_figures/look.hpp"
#include "setae/patches/survey.hpp"

namespace setae::file_figures {

/// What contact of patches gains, and their area in contact, against the share of energy; balance (7) beside it.
[[nodiscard]] StudyFigure patch_figure(const std::vector<patches::SurveyRow>& rows, const Look& look);

}  // namespace setae::file_figures
