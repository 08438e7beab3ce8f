// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace setae::study_figures {

/// A kind of figure that studies have, as a page shows it.
struct FigureKind {
    std::string identifier;  ///< as in StudyFigure; NAME is that of the surface or the loop
    std::string title;
    std::string shows;  ///< content
    std::string from;   ///< required data
};

/// All of them, in the order study_figures() has them.
[[nodiscard]] std::vector<FigureKind> figure_kinds();

}  // namespace setae::study_figures
