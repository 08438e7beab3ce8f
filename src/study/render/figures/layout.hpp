// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "ranges.hpp"

namespace setae::figures {

inline constexpr double title_letters_mm = 1.5;  ///< mean width of a letter of a title
inline constexpr double colour_bar_mm = 2.0, colour_bar_gap_mm = 1.5;

/// Edges of something within the figure [mm], from its bottom left corner.
struct Box {
    double left = 0.0, right = 0.0, bottom = 0.0, top = 0.0;
};

/// Position of a panel's axes and of their labels.
struct Layout {
    Box cell;  ///< with titles and numbers
    Box axes;
    double legend_left = 0.0;  ///< position of a legend next to the axes
};

/// @throws InvalidArgument where no space is left for the axes.
[[nodiscard]] Layout layout_of(const Figure& figure, std::size_t panel);

/// Position of a panel, in shares of the figure: as given, or its cell of the grid.
[[nodiscard]] Place place_of(const Figure& figure, std::size_t panel);

/// Entries of a panel's legend and the letters of its longest.
struct LegendSize {
    std::size_t entries = 0, letters = 0;
    double text_mm = 0.0;  ///< width of the widest label

    [[nodiscard]] double width_mm() const { return 9.0 + text_mm; }
    /// Distance of two columns: gnuplot's SVG has no font to measure and allows 0.7 of the letters' height for each.
    [[nodiscard]] double column_mm() const { return 9.4 + 1.73 * static_cast<double>(letters); }
    [[nodiscard]] double height_mm() const { return height_mm(entries); }
    [[nodiscard]] static double height_mm(std::size_t rows) { return 1.5 + 3.4 * static_cast<double>(rows); }
    /// Rows where its columns fill a width.
    [[nodiscard]] std::size_t rows_within(double width) const;
};
[[nodiscard]] LegendSize legend_size(const Panel& panel);

/// An axis' quantity as its title has it: without the words before the symbol where they do not fit.
[[nodiscard]] std::string_view title_quantity(const Axis& axis, double length_mm);

/// Characters of UTF-8 text.
[[nodiscard]] std::size_t letters_in(const std::string& text);

}  // namespace setae::figures
