// SPDX-License-Identifier: GPL-3.0-or-later
#include "layout.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "setae/core/errors.hpp"

namespace setae::figures {
namespace {

/// Margins of a panel's axes against its cell [mm].
struct Margins {
    double left = 0.0, right = 3.2, top = 2.5, bottom = 9.5;
};

Margins margins_of(const Panel& panel) {
    constexpr double title_mm = 6.5;
    Margins margins;
    if (!panel.title.empty()) margins.top += 3.5;
    if (panel.x.bare || panel.sketch) margins.bottom = 1.5;
    if (panel.sketch) {
        margins.left = margins.right = 1.0;
        return margins;
    }
    std::size_t longest = 0;
    for (const auto& label : panel.y.tick_labels) longest = std::max(longest, letters_in(label));
    if (longest > 0) margins.left = title_mm + letters_mm * static_cast<double>(longest);
    else if (panel.y.logarithmic) margins.left = title_mm + 9.0;  // 10^{−20}
    else margins.left = title_mm + letters_mm * letters_of_ticks(y_range(panel));
    if (panel.map)
        margins.right +=
            colour_bar_gap_mm + colour_bar_mm + 1.0 + letters_mm * letters_of_ticks(value_range(*panel.map)) + 4.0;
    if (panel.legend_beside && legend_size(panel).entries > 0) margins.right += legend_size(panel).width_mm();
    return margins;
}

Box cell_of(const Figure& figure, std::size_t panel) {
    if (const auto& place = figure.panels[panel].place) {
        const double left = place->left * figure.width_mm, top = (1.0 - place->top) * figure.height_mm;
        return {left, left + place->width * figure.width_mm, top - place->height * figure.height_mm, top};
    }
    const auto columns = std::min(static_cast<std::size_t>(figure.columns), figure.panels.size());
    const auto rows = (figure.panels.size() + columns - 1) / columns;
    const double width = figure.width_mm / static_cast<double>(columns),
                 height = figure.height_mm / static_cast<double>(rows);
    const std::size_t row = panel / columns, column = panel % columns;
    const double left = width * static_cast<double>(column), top = figure.height_mm - height * static_cast<double>(row);
    return {left, left + width, top - height, top};
}

}  // namespace

int letters_of_ticks(const Range& range) {
    const double step = std::floor(std::log10((range.to - range.from) / 6.0)),
                 most = std::max(std::abs(range.from), std::abs(range.to));
    const int before = most >= 1.0 ? 1 + static_cast<int>(std::log10(most)) : 1,
              after = step < 0.0 ? 1 - static_cast<int>(step) : 0;
    return std::min(before + after + (range.from < 0.0 ? 1 : 0), 8);
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
    }
    return size;
}

Layout layout_of(const Figure& figure, std::size_t panel) {
    auto margins = margins_of(figure.panels[panel]);
    const auto cell = cell_of(figure, panel);
    // axes below each other begin, and end, at one line
    for (std::size_t other = 0; other < figure.panels.size(); ++other) {
        const auto other_cell = cell_of(figure, other);
        const auto other_margins = margins_of(figure.panels[other]);
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
            fmt::format("{} panels in {} columns leave no room for axes in {} mm x {} mm; expected a larger figure",
                        figure.panels.size(), figure.columns, figure.width_mm, figure.height_mm));
    return layout;
}

}  // namespace setae::figures
