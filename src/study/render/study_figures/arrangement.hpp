// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/study_figures/study_figures.hpp"

namespace setae::study_figures {

inline constexpr double column_mm = 85.0, page_mm = 178.0;  ///< widths of a journal's column and page
inline constexpr double highest_column_mm = 120.0;          ///< of a figure in one column

/// Puts panels of one kind into a grid under one legend, the first panel's, and sets the figure's size.
///
/// On a page two beside each other, a row `row_mm` high. In a column below each other, as many beside each other as
/// keep the figure within 120 mm where rows of 25 mm (36 mm, where each has numbers below) allow it. Panels above
/// others with the same stated ends of x leave numbers and title to those.
void arrange(figures::Figure& figure, FigureWidth width, double row_mm);

/// As a page's row of panels, or a column of them within 120 mm; under one legend, the first panel's.
void line_up(figures::Figure& figure, FigureWidth width, double row_mm);

}  // namespace setae::study_figures
