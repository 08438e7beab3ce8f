// SPDX-License-Identifier: GPL-3.0-or-later
#include "layout.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/figures/typesetting.hpp"
#include "ticks.hpp"

namespace setae::figures {
namespace {

/// Margins of a panel's axes against its cell [mm].
struct Margins {
    double left = 0.0, right = 3.2, top = 2.5, bottom = 9.5;
};

/// Width of the numbers at a panel's y axis, `length_mm` long.
double numbers_mm(const Panel& panel, double length_mm) {
    std::size_t longest = 0;
    for (const auto& label : panel.y.tick_labels) longest = std::max(longest, letters_in(label));
    if (longest > 0) return letters_mm * static_cast<double>(longest);
    if (panel.y.logarithmic) return 9.0;  // 10^{−20}
    return letters_mm * static_cast<double>(linear_ticks(y_range(panel), length_mm, Direction::along_y).letters);
}

Box cell_of(const Figure& figure, std::size_t panel) {
    const auto place = place_of(figure, panel);
    const double left = place.left * figure.width_mm, top = (1.0 - place.top) * figure.height_mm;
    return {left, left + place.width * figure.width_mm, top - place.height * figure.height_mm, top};
}

Margins margins_of(const Figure& figure, std::size_t p) {
    constexpr double title_mm = 6.5;
    const auto& panel = figure.panels[p];
    const auto heading = heading_of(figure, p);
    Margins margins;
    if (!heading.letter.empty() || !heading.words.empty()) margins.top += 3.5;
    if (panel.x.bare || panel.sketch) margins.bottom = 1.5;
    if (panel.sketch) {
        margins.left = margins.right = 1.0;
        return margins;
    }
    const auto cell = cell_of(figure, p);
    const double length = std::max(cell.top - cell.bottom - margins.top - margins.bottom, 1.0);
    margins.left = title_mm + numbers_mm(panel, length);
    if (panel.map)
        margins.right += colour_bar_gap_mm + colour_bar_mm + 1.0 +
                         letters_mm * static_cast<double>(
                                          linear_ticks(value_range(*panel.map), length, Direction::along_y).letters) +
                         4.0;
    if (panel.legend_right && legend_size(panel).entries > 0) margins.right += legend_size(panel).width_mm();
    return margins;
}

/// Width of a label: letters of 7 points, capitals wider.
double legend_text_mm(const std::string& label) {
    constexpr double letter = 1.25, capital = 1.8;
    const auto capitals = std::count_if(label.begin(), label.end(), [](char c) { return c >= 'A' && c <= 'Z'; });
    return letter * static_cast<double>(letters_in(label)) + (capital - letter) * static_cast<double>(capitals);
}

}  // namespace

Place place_of(const Figure& figure, std::size_t panel) {
    if (const auto& place = figure.panels[panel].place) return *place;
    const auto columns = std::min(static_cast<std::size_t>(figure.columns), figure.panels.size());
    const auto rows = (figure.panels.size() + columns - 1) / columns;
    const auto row = panel / columns, column = panel % columns;
    const double width = 1.0 / static_cast<double>(columns), height = 1.0 / static_cast<double>(rows);
    return {width * static_cast<double>(column), height * static_cast<double>(row), width, height};
}

std::string_view title_quantity(const Axis& axis, double length_mm) {
    const std::string_view whole = axis.quantity;
    const auto letters = letters_in(plain_text(whole)) + (axis.unit.empty() ? 0 : letters_in(axis.unit) + 3);
    return title_letters_mm * static_cast<double>(letters) > length_mm ? symbol_of(whole) : whole;
}

std::size_t LegendSize::rows_within(double width) const {
    const auto columns = 1 + static_cast<std::size_t>(std::max(0.0, (width - width_mm()) / column_mm()));
    return (entries + columns - 1) / columns;
}

std::size_t letters_in(const std::string& text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

LegendSize legend_size(const Panel& panel) {
    LegendSize size;
    if (!panel.legend) return size;
    for (const auto& series : panel.series) {
        if (series.label.empty() || !series.in_legend || (series.x.size() == 0 && !series.legend_only)) continue;
        ++size.entries;
        size.letters = std::max(size.letters, letters_in(series.label));
        size.text_mm = std::max(size.text_mm, legend_text_mm(series.label));
    }
    return size;
}

Layout layout_of(const Figure& figure, std::size_t panel) {
    auto margins = margins_of(figure, panel);
    const auto cell = cell_of(figure, panel);
    // axes below each other begin, and end, at one line
    for (std::size_t other = 0; other < figure.panels.size(); ++other) {
        const auto other_cell = cell_of(figure, other);
        const auto other_margins = margins_of(figure, other);
        const auto close = [](double a, double b) { return std::abs(a - b) < 0.01; };
        if (close(other_cell.left, cell.left)) margins.left = std::max(margins.left, other_margins.left);
        if (close(other_cell.right, cell.right) && !figure.panels[panel].map && !figure.panels[other].map)
            margins.right = std::max(margins.right, other_margins.right);
    }
    Layout layout{
        cell,
        {cell.left + margins.left, cell.right - margins.right, cell.bottom + margins.bottom, cell.top - margins.top}};
    if (const auto& map = figure.panels[panel].map) {
        // one scale along both axes
        auto& axes = layout.axes;
        const double scale = std::min((axes.right - axes.left) / map->width, (axes.top - axes.bottom) / map->height);
        axes.right = axes.left + scale * map->width;
        axes.bottom = axes.top - scale * map->height;
        layout.cell.right = axes.right + margins.right;
        layout.cell.bottom = axes.bottom - margins.bottom;
    }
    layout.legend_left = layout.axes.right + 1.0;
    if (!(layout.axes.left < layout.axes.right && layout.axes.bottom < layout.axes.top))
        throw InvalidArgument(
            fmt::format("{} panels in {} columns leave no space for axes in {} mm x {} mm; expected a larger figure",
                        figure.panels.size(), figure.columns, figure.width_mm, figure.height_mm));
    return layout;
}

}  // namespace setae::figures
