// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/file_figures/contact_map_figure.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "axes.hpp"
#include "setae/core/errors.hpp"
#include "setae/study/height_preview.hpp"

namespace setae::file_figures {
namespace {

using figures::Panel;

constexpr Index max_cells = 256;

/// Drawn quantity of a state.
struct Field {
    const char *quantity, *unit;
    double min_range;  ///< range of colours, where all points are equal
};
constexpr Field pressure_field{"pressure *p*", "Pa", 1.0}, gap_field{"gap *g*", "m", 1e-9};

bool is_line(const Array2D& values) { return values.rows() == 1 || values.cols() == 1; }

Panel line_of(const Array2D& values, std::array<double, 2> size, const Field& shown) {
    const Index n = values.size();
    const double length = values.rows() == 1 ? size[1] : size[0];
    const Array1D x = Array1D::LinSpaced(n, 0.0, static_cast<double>(n - 1)) * (length / static_cast<double>(n)),
                  y = values.reshaped();
    const auto across = axis_unit(x, "m"), unit = axis_unit(y, shown.unit);
    Panel panel{.x = {.quantity = "*x*", .unit = across.name},
                .y = {.quantity = shown.quantity, .unit = unit.name},
                .legend = false};
    panel.series.push_back({.label = shown.quantity,
                            .x = x / across.factor,
                            .y = y / unit.factor,
                            .mark = figures::Mark::line,
                            .colour = black,
                            .dash = 0,
                            .line_width = 0.8});
    return panel;
}

/// Quantile of the values for a share.
double quantile(Array1D values, double share) {
    const auto place = values.begin() + static_cast<Index>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), place, values.end());
    return *place;
}

Panel map_of(const Array2D& values, std::array<double, 2> size, const Field& shown) {
    constexpr double beyond = 0.005;
    const auto preview = study::height_preview(topography::HeightMap{values, size, true, {}}, max_cells, max_cells);
    const auto across = axis_unit(Array1D{{size[0], size[1]}}, "m");
    const Array1D cells = preview.map.reshaped();
    const double lowest = quantile(cells, beyond),
                 highest = std::max(quantile(cells, 1.0 - beyond), lowest + shown.min_range);
    const auto unit = axis_unit(Array1D{{lowest, highest}}, shown.unit);
    Panel panel{
        .x = {.quantity = "*x*", .unit = across.name}, .y = {.quantity = "*y*", .unit = across.name}, .legend = false};
    panel.map = figures::HeatMap{
        .values = preview.map / unit.factor,
        .width = size[0] / across.factor,
        .height = size[1] / across.factor,
        .values_axis = {
            .quantity = shown.quantity, .unit = unit.name, .from = lowest / unit.factor, .to = highest / unit.factor}};
    return panel;
}

}  // namespace

StudyFigure contact_map_figure(const std::vector<ContactState>& states, std::array<double, 2> size,
                               const std::string& file, const Look& look) {
    if (states.empty()) throw InvalidArgument("there is no contact state to draw");
    const bool line = is_line(states.front().gaps), several = states.size() > 1, wide = look.wide() || several;
    StudyFigure drawn{.identifier = "contact", .name = "Contact point by point", .command = look.command};
    drawn.title = fmt::format("Pressure and gap of {}", file_name(file));
    drawn.caption = fmt::format("Pressure (negative where the surfaces attract) and gap.{}",
                                line ? "" : " The colour range excludes 0.5 % of the map at each end.");
    const auto panel = line ? line_of : map_of;
    for (const auto& state : states)
        for (auto of : {panel(state.pressures, size, pressure_field), panel(state.gaps, size, gap_field)}) {
            of.title = std::string(1, static_cast<char>('A' + drawn.figure.panels.size()));
            of.shows = state.shows;
            drawn.figure.panels.push_back(std::move(of));
        }
    drawn.figure.columns = wide ? 2 : 1;
    drawn.figure.width_mm = wide ? page_mm : column_mm;
    const double row = several ? 60.0 : wide ? 75.0 : 60.0;
    drawn.figure.height_mm = row * static_cast<double>(drawn.figure.panels.size()) / (wide ? 2.0 : 1.0);
    return drawn;
}

}  // namespace setae::file_figures
