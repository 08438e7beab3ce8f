// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "ranges.hpp"
#include "setae/io/whole_file.hpp"

namespace setae::figures {
namespace {

/// A cell of text as RFC 4180 has it.
std::string cell(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
    return quoted + "\"";
}

std::string cell(const Array1D& values, Index i) {
    return values.size() == 0 || std::isnan(values[i]) ? std::string() : fmt::format("{}", values[i]);
}

std::string axis_cells(const Axis& axis) { return cell(axis.quantity) + "," + cell(axis.unit.empty() ? "1" : axis.unit); }

}  // namespace

void write_data(const Figure& figure, const std::string& path) {
    std::string text = "panel,series,x quantity,x unit,x,y quantity,y unit,y,lower,upper,left,right\n";
    for (std::size_t p = 0; p < figure.panels.size(); ++p) {
        const auto& panel = figure.panels[p];
        require_drawable(panel);
        const auto name = cell(panel.title.empty() ? fmt::format("{}", p + 1) : panel.title);
        for (const auto& series : panel.series)
            for (Index i = 0; i < series.x.size(); ++i)
                fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{},{},{}\n", name, cell(series.label), axis_cells(panel.x),
                               cell(series.x, i), axis_cells(panel.y), cell(series.y, i), cell(series.lower, i), cell(series.upper, i),
                               cell(series.left, i), cell(series.right, i));
    }
    io::write_whole_file(path, text);
}

}  // namespace setae::figures
