// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement.hpp"

#include <algorithm>

namespace setae::study_figures {
namespace {

using figures::Figure;

constexpr double min_row_mm = 25.0, min_numbered_row_mm = 36.0, numbers_mm = 8.0;  ///< numbers and title below axes
constexpr double one_panel_mm = 120.0;  ///< width of a single panel on a page

bool share_x(const Figure& figure) {
    const auto& first = figure.panels.front().x;
    return std::all_of(figure.panels.begin(), figure.panels.end(), [&](const figures::Panel& panel) {
        return panel.x.from && panel.x.to && panel.x.from == first.from && panel.x.to == first.to &&
               panel.x.quantity == first.quantity && panel.x.unit == first.unit;
    });
}

std::size_t rows_of(const Figure& figure, std::size_t columns) {
    return (figure.panels.size() + columns - 1) / columns;
}

/// Places of the panels in rows of equal axes below a legend's strip.
void place(Figure& figure, std::size_t columns, double strip_mm, bool shared) {
    const auto rows = static_cast<double>(rows_of(figure, columns));
    const double extra = shared && rows > 1.0 ? numbers_mm : 0.0;
    const double row = (figure.height_mm - strip_mm - extra) / rows;
    for (std::size_t p = 0; p < figure.panels.size(); ++p) {
        auto& panel = figure.panels[p];
        const bool last = p + columns >= figure.panels.size();
        panel.x.bare = shared && !last;
        panel.place =
            figures::Place{static_cast<double>(p % columns) / static_cast<double>(columns),
                           (strip_mm + row * static_cast<double>(p / columns)) / figure.height_mm,
                           1.0 / static_cast<double>(columns), (row + (last ? extra : 0.0)) / figure.height_mm};
    }
    figure.columns = static_cast<int>(columns);
    if (strip_mm > 0.0) {
        figure.panels.front().legend_right = false;
        figure.panels.front().legend_place = figures::Place{0.0, 0.0, 1.0, strip_mm / figure.height_mm};
    }
}

/// Height of a column's figure: with the requested height of rows, within the limit where possible.
double column_height(double wanted_mm, double min_mm) {
    return std::min(wanted_mm, std::max(highest_column_mm, min_mm));
}

void lay_out(Figure& figure, FigureWidth width, double row_mm, std::size_t page_columns) {
    if (figure.panels.empty()) return;
    for (std::size_t p = 1; p < figure.panels.size(); ++p) figure.panels[p].legend = false;
    const bool page = width == FigureWidth::double_column;
    const auto n = figure.panels.size();
    const bool shared = share_x(figure);
    std::size_t columns = page ? std::min(page_columns, n) : 1;
    figure.width_mm = !page ? column_mm : columns > 1 ? page_mm : one_panel_mm;
    // a single panel has space for its legend
    const double strip = n > 1 ? figures::legend_strip_mm(figure) : 0.0;
    const double least = shared ? min_row_mm : min_numbered_row_mm, below = shared ? numbers_mm : 0.0;
    const auto min_height = [&] { return strip + least * static_cast<double>(rows_of(figure, columns)) + below; };
    constexpr std::size_t max_columns = 3;
    while (!page && columns < std::min(max_columns, n) && min_height() > highest_column_mm) ++columns;
    const double wanted = strip + row_mm * static_cast<double>(rows_of(figure, columns));
    figure.height_mm = page ? wanted : column_height(wanted, min_height());
    place(figure, columns, strip, shared && rows_of(figure, columns) > 1);
}

}  // namespace

void arrange(Figure& figure, FigureWidth width, double row_mm) { lay_out(figure, width, row_mm, 2); }

void line_up(Figure& figure, FigureWidth width, double row_mm) { lay_out(figure, width, row_mm, figure.panels.size()); }

}  // namespace setae::study_figures
