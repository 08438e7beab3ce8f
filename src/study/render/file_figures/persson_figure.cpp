// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/file_figures/persson_figure.hpp"

#include <cmath>

#include <fmt/format.h>

#include "axes.hpp"

namespace setae::file_figures {
namespace {

using figures::Mark;

/// Abscissa of both panels.
struct Abscissa {
    figures::Axis axis;
    Array1D values;
    bool along_load;
};

Abscissa abscissa_of(const Table& table) {
    const auto* pressure = table.find("pressure");
    const auto& values = pressure ? pressure->values : table.at("wavevector");
    // the geometric middle of a range over decades is a better scale than its end
    const Array1D middle{{std::sqrt(values.abs().maxCoeff() * values.abs().minCoeff())}};
    const auto unit = axis_unit(middle, pressure ? "Pa" : "1/m");
    return {.axis = {.quantity = pressure ? "mean pressure *p*" : "waves up to *q*",
                     .unit = unit.name,
                     .logarithmic = (values > 0.0).all()},
            .values = values / unit.factor,
            .along_load = pressure != nullptr};
}

figures::Series line(const char* label, const Abscissa& along, const Array1D& values, int colour) {
    return {.label = label,
            .x = along.values,
            .y = values,
            .mark = values.size() == 1 ? Mark::points : Mark::line,
            .colour = colour,
            .dash = colour};
}

figures::Panel area_panel(const Table& table, const Abscissa& along) {
    figures::Panel panel{
        .title = "A", .x = along.axis, .y = {.quantity = "area in contact *A*/*A*_0", .logarithmic = along.along_load}};
    panel.series.push_back(line("without adhesion", along, table.at("area_fraction"), 0));
    if (const auto* adhesive = table.find("adhesive_area_fraction"))
        panel.series.push_back(line("with adhesion", along, adhesive->values, 1));
    panel.legend = panel.series.size() > 1;
    return panel;
}

figures::Panel gap_panel(const Table& table, const Abscissa& along) {
    const auto& gap = table.at("mean_gap");
    const Array1D known = gap.isNaN().select(0.0, gap);
    const auto unit = axis_unit(Array1D{{known.maxCoeff()}}, "m");
    figures::Panel panel{.title = "B", .x = along.axis, .y = {.quantity = "mean gap *ū*", .unit = unit.name}};
    panel.series.push_back(line("without adhesion", along, gap / unit.factor, 0));
    panel.legend = false;
    return panel;
}

}  // namespace

StudyFigure persson_figure(const Table& table, const std::string& file, const Look& look) {
    const auto along = abscissa_of(table);
    StudyFigure drawn{.identifier = "persson", .name = "Persson's theory", .command = look.command};
    drawn.title =
        fmt::format("Contact of {} against {}", file_name(file), along.along_load ? "load" : "the included waves");
    drawn.caption = fmt::format("Persson's theory. A: area in contact over the nominal area{}. B: mean gap{}.",
                                table.find("adhesive_area_fraction") ? ", with and without adhesion" : "",
                                along.along_load ? "" : ", both for the surface with only the waves up to q");
    const bool wide = look.wide();
    drawn.figure = {.panels = {area_panel(table, along), gap_panel(table, along)},
                    .columns = wide ? 2 : 1,
                    .width_mm = wide ? page_mm : column_mm,
                    .height_mm = wide ? 70.0 : 120.0};
    return drawn;
}

}  // namespace setae::file_figures
