// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/file_figures/look.hpp"
#include "setae/study/hysteresis.hpp"

namespace setae::file_figures {

/// Predicted F(δ) and a(F) of a pair, with its records in the study; dashed where W_ret differs by a standard error.
[[nodiscard]] StudyFigure predicted_loop_figure(const study::PairHysteresis& pair, const study::StudyResult& result,
                                                const Look& look);

}  // namespace setae::file_figures
