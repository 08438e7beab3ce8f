// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/file_figures/comparison_figure.hpp"

#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "axes.hpp"
#include "setae/core/constants.hpp"

namespace setae::file_figures {
namespace {

using figures::Mark;

/// Content of a panel.
struct Shown {
    const char *title, *column, *quantity;
    bool logarithmic;
};

figures::Panel panel_of(const Table& load, const Shown& shown, const figures::Axis& along, const Array1D& pressure) {
    const std::string column = shown.column;
    const auto* solved = load.find(column);
    const auto &values = solved->values, &theory = load.at(column + "_persson"),
               &errors = load.at(column + "_standard_error");
    const Array1D error = errors.isNaN().select(0.0, errors);
    const Array1D known = values.isFinite().select(values, 0.0);
    const auto unit = solved->unit == "1" ? DisplayUnit{} : axis_unit(Array1D{{known.maxCoeff()}}, solved->unit);
    figures::Panel panel{.title = shown.title,
                         .x = along,
                         .y = {.quantity = shown.quantity, .unit = unit.name, .logarithmic = shown.logarithmic}};
    panel.series.push_back({.label = "solved",
                            .x = pressure,
                            .y = values / unit.factor,
                            .lower = (values - error) / unit.factor,
                            .upper = (values + error) / unit.factor,
                            .mark = Mark::points,
                            .colour = 0});
    panel.series.push_back({.label = "Persson's theory",
                            .x = pressure,
                            .y = values.isFinite().select(theory, undefined) / unit.factor,
                            .mark = pressure.size() == 1 ? Mark::points : Mark::line,
                            .colour = 1});
    panel.legend = column == "area_fraction";
    return panel;
}

}  // namespace

StudyFigure comparison_figure(const Table& load, const std::string& file, const Look& look) {
    const auto& pressure = load.at("pressure");
    const auto unit = axis_unit(Array1D{{std::sqrt(pressure.maxCoeff() * pressure.minCoeff())}}, "Pa");
    const figures::Axis along{.quantity = "mean pressure *p*", .unit = unit.name, .logarithmic = true};
    StudyFigure drawn{.identifier = "comparison", .name = "contact solved and by theory", .command = look.command};
    drawn.title = fmt::format("Contact of {}: solved, and Persson's theory", file_name(file));
    const bool wide = look.wide();
    drawn.caption = fmt::format(
        "Solved contact, as mean over surfaces with this spectrum with one standard error, and Persson's theory for this "
        "spectrum. A: area in contact over the nominal area. B: mean gap.{}",
        wide ? " C: stiffness. D: stored energy." : "");
    const Array1D scaled = pressure / unit.factor;
    std::vector<Shown> panels{{"A", "area_fraction", "area in contact *A*/*A*_0", true},
                              {"B", "mean_gap", "mean gap *ū*", false}};
    if (wide) {  // a column has no space for them
        panels.push_back({"C", "contact_stiffness", "stiffness *K*", true});
        panels.push_back({"D", "stored_energy", "stored energy *U*_el/*A*_0", true});
    }
    for (const auto& shown : panels) drawn.figure.panels.push_back(panel_of(load, shown, along, scaled));
    drawn.figure.columns = wide ? 2 : 1;
    drawn.figure.width_mm = wide ? page_mm : column_mm;
    drawn.figure.height_mm = wide ? 130.0 : 120.0;
    return drawn;
}

}  // namespace setae::file_figures
