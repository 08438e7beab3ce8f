// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "ranges.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/spreadsheet_text.hpp"
#include "setae/figures/typesetting.hpp"

namespace setae::figures {
namespace {

std::string cell(const std::string& text) { return spreadsheet_cell(text); }

/// Twelve digits: numbers that were scaled to the unit of an axis are recovered.
std::string cell(double value) { return std::isnan(value) ? std::string() : fmt::format("{:.12g}", value); }

std::string cell(const Array1D& values, Index i) { return values.size() == 0 ? std::string() : cell(values[i]); }

std::string axis_cells(const Axis& axis) {
    return cell(plain_text(axis.quantity)) + "," + cell(axis.unit.empty() ? "1" : axis.unit);
}

}  // namespace

std::string data_text(const Figure& figure) {
    const bool maps = std::any_of(figure.panels.begin(), figure.panels.end(),
                                  [](const Panel& panel) { return panel.map.has_value(); });
    std::string text =
        fmt::format("panel,series,name,x quantity,x unit,x,y quantity,y unit,y,lower,upper,left,right{}\n",
                    maps ? ",value quantity,value unit,value" : "");
    const auto end = maps ? ",,,\n" : "\n";
    for (std::size_t p = 0; p < figure.panels.size(); ++p) {
        const auto& panel = figure.panels[p];
        require_drawable(panel);
        const auto title = cell(panel.title.empty() ? fmt::format("{}", p + 1) : panel.title);
        const auto x = axis_cells(panel.x), y = axis_cells(panel.y);
        if (panel.map) {
            const auto& map = *panel.map;
            const auto value = axis_cells(map.values_axis);
            const double dx = map.width / static_cast<double>(map.values.rows()),
                         dy = map.height / static_cast<double>(map.values.cols());
            for (Index i = 0; i < map.values.rows(); ++i)
                for (Index j = 0; j < map.values.cols(); ++j)
                    fmt::format_to(std::back_inserter(text), "{},map,,{},{},{},{},,,,,{},{}\n", title, x,
                                   (static_cast<double>(i) + 0.5) * dx, y, (static_cast<double>(j) + 0.5) * dy, value,
                                   cell(map.values(i, j)));
        }
        for (const auto& series : panel.series) {
            const auto label = cell(series.label);
            for (Index i = 0; i < series.x.size(); ++i)
                fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{},{},{},{}{}", title, label,
                               series.names.empty() ? std::string() : cell(series.names[static_cast<std::size_t>(i)]),
                               x, cell(series.x, i), y, cell(series.y, i), cell(series.lower, i), cell(series.upper, i),
                               cell(series.left, i), cell(series.right, i), end);
        }
    }
    return text;
}

void write_data(const Figure& figure, const std::string& path) { bytes::write_whole_file(path, data_text(figure)); }

}  // namespace setae::figures
