// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace setae::study_figures {

/// A kind of figure that studies have, as a page shows it.
struct FigureKind {
    std::string identifier;  ///< as StudyFigure's; NAME stands for the surface's or the loop's
    std::string title;
    std::string shows;  ///< what is drawn
    std::string from;   ///< what it needs
};

/// All of them, in the order study_figures() has them.
[[nodiscard]] std::vector<FigureKind> figure_kinds();

}  // namespace setae::study_figures
