// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/study/hysteresis.hpp"
#include "setae/study_figures/study_figures.hpp"

namespace setae::study_figures {

/// Measured against predicted W_ret of all pairs that have one: symbol by surface, colour by elastomer, hollow without
/// spontaneous full contact.
[[nodiscard]] StudyFigure hysteresis_figure(const study::Hysteresis& hysteresis, FigureWidth width);

/// Energy loss of a loop, by contributions, and its measured value.
struct LossBar {
    std::string label;
    const hysteresis::EnergyShares& shares;
    std::optional<Estimate> measured;  ///< [J]
    bool of_works = false;             ///< `measured` is computed from the measured W_app and W_ret
};

/// Bars one above the other, the first on top; that of the bulk only where one relaxes.
[[nodiscard]] figures::Panel losses_panel(const std::vector<LossBar>& bars);

/// Energy budgets of measured loops, else of the predicted ones: one bar per pair.
[[nodiscard]] StudyFigure loss_shares_figure(const study::Hysteresis& hysteresis, FigureWidth width);

}  // namespace setae::study_figures
