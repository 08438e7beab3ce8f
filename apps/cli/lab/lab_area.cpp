// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "program/command.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/figures/figure.hpp"
#include "setae/roughness/true_area.hpp"
#include "setae/study_figures/true_area_of_maps.hpp"
#include "setae/tables/table_file.hpp"

namespace setae::cli {
namespace {

constexpr const char* explanation =
    "maps       self-affine, H = 0.3 and 0.8, three of each, Fourier-filtered; shortest wave 4 points, longest 1/16 of the map\n"
    "           below which the spectrum is flat; each scaled to every rms slope from 0.01 to 10\n"
    "A_true     area of the triangles through the heights, both diagonals averaged                  [D19] (S3)\n"
    "h'         sqrt<|grad h|^2> of the same triangles\n"
    "(9)        A_true/A_app - 1 = (sqrt(pi)/2) h' exp(1/h'^2) erfc(1/h'); h'^2/2 for small, sqrt(pi)/2 h' - 1 for large h'\n"
    "deviation  (A_true/A_app - 1) / that of (9) - 1, mean of the maps and its standard error       [D19] Fig. S7\n";

struct AreaArguments {
    Common common;
    std::string output = "area";
    Index points = 4096;
    std::uint64_t seed = 1;
};

using study_figures::AreaOfMap;
using study_figures::maps_each;
using study_figures::MeanArea;

/// Means of one Hurst exponent, in order of slope.
std::vector<MeanArea> of_exponent(const std::vector<MeanArea>& areas, double hurst_exponent) {
    std::vector<MeanArea> found;
    for (const auto& area : areas)
        if (area.hurst_exponent == hurst_exponent) found.push_back(area);
    return found;
}

/// A formula for the excess area at many slopes.
template <class Formula>
figures::Series curve(const std::string& label, double from, double to, int colour, int dash, const Formula& formula) {
    constexpr Index points = 121;
    const Array1D x = Array1D::LinSpaced(points, std::log(from), std::log(to)).exp();
    return {.label = label,
            .x = x,
            .y = x.unaryExpr(formula),
            .mark = figures::Mark::line,
            .colour = colour,
            .symbol = dash};
}

figures::Figure figure_of(const std::vector<MeanArea>& areas) {
    constexpr int black = 4, sky_blue = 6, orange = 5;
    const figures::Axis slope{.quantity = "rms slope *h*'_{rms}", .logarithmic = true, .from = 0.007, .to = 14.0};
    figures::Panel excess{
        .title = "A",
        .x = slope,
        .y = {.quantity = "excess area *A*_{true}/*A*_{app} − 1", .logarithmic = true, .from = 1e-5, .to = 20.0}};
    excess.series = {
        curve("equation (9)", 0.008, 12.0, black, 0, [](double h) { return roughness::gaussian_area_ratio(h) - 1.0; }),
        curve("h'²/2", 0.008, 4.0, sky_blue, 1, [](double h) { return roughness::small_slope_area_ratio(h) - 1.0; }),
        curve("(√π/2) h' − 1", 1.25, 12.0, orange, 2, [](double h) { return 0.5 * std::sqrt(pi) * h - 1.0; })};
    figures::Panel deviation{
        .title = "B", .x = slope, .y = {.quantity = "deviation from (9)", .unit = "%"}, .horizontal_lines = {0.0}};
    // the hollow symbols last, so that they show what they lie on
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

Table table_of(const std::vector<AreaOfMap>& areas) {
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

ExitCode run(const AreaArguments& arguments) {
    const auto areas = study_figures::true_area_of_maps(
        {.points = arguments.points, .seed = arguments.seed, .threads = arguments.common.workers()});
    const auto rows = study_figures::means(areas);
    std::error_code ignored;
    std::filesystem::create_directories(arguments.output, ignored);
    const auto path = [&](const char* name) { return (std::filesystem::path(arguments.output) / name).string(); };
    tables::write_csv(path("area.csv"), table_of(areas));
    double largest = 0.0;
    for (const auto& row : rows) largest = std::max(largest, std::abs(row.deviation));
    if (arguments.common.json) {
        output::Json json{{"points", {arguments.points, arguments.points}},
                          {"seed", arguments.seed},
                          {"maps_each", maps_each},
                          {"folder", arguments.output},
                          {"largest_deviation", largest}};
        for (const auto& row : rows)
            json["areas"].push_back({{"H", row.hurst_exponent},
                                     {"rms_slope", row.rms_slope},
                                     {"excess_area", row.excess_area},
                                     {"deviation", row.deviation},
                                     {"deviation_standard_error", row.standard_error}});
        print_json(json);
    } else {
        std::string text = fmt::format("{:>4} {:>6}  {:>12} {:>12}  deviation [%]\n", "H", "h'", "excess area", "(9)");
        for (const auto& row : rows)
            text += fmt::format("{:>4} {:>6}  {:>12.6g} {:>12.6g}  {:>7.4f} ± {:.4f}\n", row.hurst_exponent,
                                row.rms_slope, row.excess_area, roughness::gaussian_area_ratio(row.rms_slope) - 1.0,
                                100.0 * row.deviation, 100.0 * row.standard_error);
        print(text + fmt::format("{0} x {0} points, {1} maps each, seed {2}: within {3:.2g} % of (9); {4}\n",
                                 arguments.points, maps_each, arguments.seed, 100.0 * largest, arguments.output));
    }
    const auto figure = figure_of(rows);
    // the numbers are there also where nothing can be drawn
    return for_each_item({"area.svg", "area.png", "area.pdf"},
                         [&](const std::string& name) { figures::draw(figure, path(name.c_str())); }) == ExitCode::done
               ? ExitCode::done
               : ExitCode::some_failed;
}

}  // namespace

Action lab_area_command(Options& options) {
    auto arguments = std::make_shared<AreaArguments>();
    options.add("-o,--output", arguments->output, "folder of area.csv and the figure").default_shown();
    options.add("--points", arguments->points, "of a map along x and y").between(128, 32768).default_shown();
    options.add("--seed", arguments->seed, "same seed, same maps").default_shown();
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli
