// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/study_figures/study_figures.hpp"

namespace setae::study_figures {

inline constexpr double column_mm = 85.0, page_mm = 178.0;  ///< widths of a journal's column and page
inline constexpr double highest_column_mm = 120.0;          ///< for a figure in one column

/// Arranges panels of one kind in a grid under one legend, the first panel's, and sets the figure's size.
///
/// On a page two panels per row, of height `row_mm`. In a column below each other, with as many per row as keep the
/// figure within 120 mm with rows of 25 mm (36 mm, where each has numbers below). Panels above others with the same
/// stated ends of x have neither numbers nor title.
void arrange(figures::Figure& figure, FigureWidth width, double row_mm);

/// Arranges panels as one row of a page, or as a column of at most 120 mm; under one legend, the first panel's.
void line_up(figures::Figure& figure, FigureWidth width, double row_mm);

}  // namespace setae::study_figures
