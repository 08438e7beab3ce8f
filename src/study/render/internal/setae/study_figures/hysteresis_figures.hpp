// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/study/hysteresis.hpp"
#include "setae/study_figures/study_figures.hpp"

namespace setae::study_figures {

/// Measured against predicted W_ret of all pairs that have one: symbol by surface, colour by elastomer, hollow where
/// the bodies do not come into full contact of themselves.
[[nodiscard]] StudyFigure hysteresis_figure(const study::Hysteresis& hysteresis, FigureWidth width);

/// What a loop loses, part by part, and what was measured of it.
struct LossBar {
    std::string label;
    const hysteresis::EnergyShares& shares;
    std::optional<Estimate> measured;  ///< [J]
    bool of_works = false;             ///< `measured` is computed from the measured W_app and W_ret
};

/// Bars one above the other, the first on top; that of the bulk only where one relaxes.
[[nodiscard]] figures::Panel losses_panel(const std::vector<LossBar>& bars);

/// Where the joules of measured loops went, else of the predicted ones: bars, one a pair.
[[nodiscard]] StudyFigure loss_shares_figure(const study::Hysteresis& hysteresis, FigureWidth width);

}  // namespace setae::study_figures
