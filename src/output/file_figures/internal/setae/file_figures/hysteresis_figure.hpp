// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/file_figures/look.hpp"
#include "setae/study/hysteresis.hpp"

namespace setae::file_figures {

/// Measured against predicted W_ret of all pairs that have one: symbol by surface, colour by elastomer, hollow where
/// the bodies do not come into full contact of themselves.
[[nodiscard]] StudyFigure hysteresis_figure(const study::Hysteresis& hysteresis, const Look& look);

/// Where the joules of measured loops went, else of the predicted ones: bars, one a pair.
[[nodiscard]] StudyFigure loss_shares_figure(const study::Hysteresis& hysteresis, const Look& look);

/// F(δ) and a(F) of a pair as predicted, over the records of it in the study; dashed where W_ret is a standard error
/// off.
[[nodiscard]] StudyFigure predicted_loop_figure(const study::PairHysteresis& pair, const study::StudyResult& result,
                                                const Look& look);

}  // namespace setae::file_figures
