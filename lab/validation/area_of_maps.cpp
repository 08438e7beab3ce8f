// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/roughness/true_area.hpp"
#include "setae/validation/true_area_of_maps.hpp"

namespace setae::validation {
namespace {

/// Means of one Hurst exponent, in order of slope.
std::vector<MeanArea> of_exponent(const std::vector<MeanArea>& areas, double hurst_exponent) {
    std::vector<MeanArea> found;
    for (const auto& area : areas)
        if (area.hurst_exponent == hurst_exponent) found.push_back(area);
    return found;
}

/// A formula for the excess area at many slopes.
template <class Formula>
figures::Series formula_line(const std::string& label, double from, double to, int colour, int dash,
                             const Formula& formula) {
    constexpr Index points = 121;
    const Array1D x = Array1D::LinSpaced(points, std::log(from), std::log(to)).exp();
    return {.label = label,
            .x = x,
            .y = x.unaryExpr(formula),
            .mark = figures::Mark::line,
            .colour = colour,
            .symbol = dash};
}

}  // namespace

figures::Figure area_figure(const std::vector<MeanArea>& areas) {
    constexpr int black = 4, sky_blue = 6, orange = 5;
    const figures::Axis slope{.quantity = "rms slope *h*'_{rms}", .logarithmic = true, .from = 0.007, .to = 14.0};
    figures::Panel excess{
        .title = "A",
        .shows = "excess area",
        .x = slope,
        .y = {.quantity = "excess area *A*_{true}/*A*_{app} − 1", .logarithmic = true, .from = 1e-5, .to = 20.0}};
    excess.series = {
        formula_line("Eq. 9", 0.008, 12.0, black, 0, [](double h) { return roughness::gaussian_area_ratio(h) - 1.0; }),
        formula_line("h'²/2", 0.008, 4.0, sky_blue, 1,
                     [](double h) { return roughness::small_slope_area_ratio(h) - 1.0; }),
        formula_line("(√π/2) h' − 1", 1.25, 12.0, orange, 2, [](double h) { return 0.5 * std::sqrt(pi) * h - 1.0; })};
    figures::Panel deviation{.title = "B",
                             .shows = "deviation",
                             .x = slope,
                             .y = {.quantity = "deviation from Eq. 9", .unit = "%"},
                             .horizontal_lines = {0.0}};
    // the hollow symbols last, so that those below stay visible
    for (const double hurst : {0.8, 0.3}) {
        const auto rows = of_exponent(areas, hurst);
        const auto n = static_cast<Index>(rows.size());
        Array1D x(n), y(n), difference(n), error(n);
        for (Index i = 0; i < n; ++i) {
            const auto& area = rows[static_cast<std::size_t>(i)];
            x[i] = area.rms_slope;
            y[i] = area.excess_area;
            difference[i] = 100.0 * area.deviation;
            error[i] = 100.0 * area.standard_error;
        }
        const auto label = fmt::format("H = {}", hurst);
        const bool hollow = hurst == 0.3;
        const int colour = hollow ? 0 : 1;
        excess.series.push_back(
            {.label = label, .x = x, .y = y, .mark = figures::Mark::points, .colour = colour, .hollow = hollow});
        deviation.series.push_back({.label = label,
                                    .x = x,
                                    .y = difference,
                                    .lower = difference - error,
                                    .upper = difference + error,
                                    .colour = colour,
                                    .hollow = hollow});
    }
    return {.panels = {excess, deviation}, .columns = 2, .width_mm = 178.0, .height_mm = 70.0};
}

Table area_table(const std::vector<AreaOfMap>& areas) {
    const auto n = static_cast<Index>(areas.size());
    Table table{{{"H", "1", Array1D(n)},
                 {"map", "1", Array1D(n)},
                 {"rms_slope", "1", Array1D(n)},
                 {"excess_area", "1", Array1D(n)},
                 {"excess_area_by_9", "1", Array1D(n)},
                 {"deviation", "1", Array1D(n)}},
                {}};
    for (Index i = 0; i < n; ++i) {
        const auto& area = areas[static_cast<std::size_t>(i)];
        // the maps of an exponent follow each other, each with all its slopes
        const auto slopes_each = areas.size() / (2 * maps_each);
        const auto map = (static_cast<std::size_t>(i) / slopes_each) % maps_each;
        const std::array cells{area.hurst_exponent,
                               static_cast<double>(map),
                               area.rms_slope,
                               area.area_ratio - 1.0,
                               roughness::gaussian_area_ratio(area.rms_slope) - 1.0,
                               area.deviation()};
        for (std::size_t column = 0; column < cells.size(); ++column) table.columns[column].values[i] = cells[column];
    }
    return table;
}

}  // namespace setae::validation
