// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/file_figures/spectrum_figure.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "axes.hpp"
#include "setae/study/study_result.hpp"

namespace setae::file_figures {
namespace {

using figures::Mark;
using figures::Panel;

const figures::Axis wavevector_axis{.quantity = "wavevector *q*", .unit = "1/m", .logarithmic = true};

/// Every measurement with its unreliable part, as in a study.
StudyFigure of_measurements(const study::SurfaceResult& surface, const Look& look) {
    study::StudyResult result;
    result.surfaces.push_back(surface);
    auto& drawn = result.surfaces.front();
    drawn.name = "one surface";                                    // its name in the caption
    if (drawn.measurements.size() == 1) drawn.average.curve = {};  // it would hide the one measurement
    return study_figures::study_figure(result, "spectra:" + drawn.name, {.width = look.width});
}

/// The standard errors of one measurement's modes, where its lines give them.
void add_errors(const study::SurfaceResult& surface, const Table& table, StudyFigure& drawn) {
    const auto* errors = table.find("standard_error");
    if (surface.measurements.size() != 1 || !errors || errors->values.isNaN().all()) return;
    const auto& C1D = table.at("C1D");
    constexpr double least = 0.01;  // share of the value: bars that reach below 0 end there on a logarithmic axis
    auto& series = drawn.figure.panels.front().series;
    series.insert(series.begin(), {.label = "one standard error",
                                   .x = table.at("wavevector"),
                                   .lower = (C1D - errors->values).max(least * C1D),
                                   .upper = C1D + errors->values,
                                   .mark = Mark::band,
                                   .colour = black,
                                   .in_legend = false});
    drawn.caption += " Shaded: one standard error between the lines of the map, for each mode.";
}

/// A table that was given, with its standard errors.
StudyFigure of_table(const study::SurfaceResult& surface, const Table& table, const Look& look) {
    StudyFigure drawn{.identifier = "spectra:" + surface.name};
    constexpr Index max_bars = 60;
    const auto& C1D = table.at("C1D");
    const bool shaded = C1D.size() > max_bars;
    figures::Series given{
        .label = "C1D", .x = table.at("wavevector"), .y = C1D, .mark = Mark::line, .colour = black, .dash = 0};
    given.in_legend = false;
    const auto* errors = table.find("standard_error");
    if (errors) {
        given.mark = shaded ? Mark::band : Mark::both;
        given.symbol = 0;
        given.lower = C1D - errors->values;
        given.upper = C1D + errors->values;
    }
    drawn.figure.panels.push_back(
        {.x = wavevector_axis,
         .y = {.quantity = "power spectral density *C*_{1D}", .unit = "m3", .logarithmic = true},
         .series = {given}});
    drawn.figure.width_mm = look.wide() ? 140.0 : column_mm;
    drawn.figure.height_mm = look.wide() ? 95.0 : 75.0;
    drawn.caption =
        fmt::format("C1D against wavevector q from a table.{}", !errors  ? " The table contains no errors."
                                                                : shaded ? " Shaded: standard errors of the table."
                                                                         : " Bars: standard errors of the table.");
    return drawn;
}

/// A column over q, of the rows chosen; others are gaps.
template <class Chosen>
Array1D shown(const Array1D& values, const Array1D& extrapolated, Chosen chosen) {
    Array1D result = values;
    for (Index i = 0; i < result.size(); ++i)
        if (!chosen(extrapolated[i] != 0.0)) result[i] = undefined;
    return result;
}

/// The self-affine fit, solid within its range.
void add_model(const Table& table, StudyFigure& drawn) {
    const auto* model = table.find("C1D_model");
    if (!model) return;
    const auto& outside = table.at("extrapolated");
    auto& series = drawn.figure.panels.front().series;
    const auto add = [&](Array1D values, bool extrapolated) {
        series.push_back({.label = extrapolated ? "self-affine fit, outside its range" : "self-affine fit",
                          .x = table.at("wavevector"),
                          .y = std::move(values),
                          .mark = Mark::line,
                          .colour = 1,
                          .dash = extrapolated ? 2 : 1,
                          .in_legend = !extrapolated});
    };
    add(shown(model->values, outside, [](bool beyond) { return !beyond; }), false);
    add(shown(model->values, outside, [](bool beyond) { return beyond; }), true);
    drawn.caption += " Dashed: the self-affine fit; dotted: outside the fitted range.";
}

/// C_iso in a panel of its own.
void add_isotropic(const Table& table, const Look& look, StudyFigure& drawn) {
    const auto *C_iso = table.find("C_iso"), *abel = table.find("C_iso_abel");
    if (!C_iso && !abel) return;
    const auto& q = table.at("wavevector");
    auto& first = drawn.figure.panels.front();
    Panel panel{.title = "B",
                .x = wavevector_axis,
                .y = {.quantity = "isotropic spectral density *C*_{iso}", .unit = "m4", .logarithmic = true},
                .legend = C_iso && abel,
                .legend_corner = figures::Corner::bottom_left};
    if (C_iso)
        panel.series.push_back(
            {.label = "C_iso", .x = q, .y = C_iso->values, .mark = Mark::line, .colour = black, .dash = 0});
    if (abel) {
        const auto& error = table.at("C_iso_abel_standard_error");
        panel.series.push_back({.label = "inverse Abel transform",
                                .x = q,
                                .y = abel->values,
                                .lower = abel->values - error,
                                .upper = abel->values + error,
                                .mark = Mark::points,
                                .colour = 0});
    }
    first.title = "A";
    drawn.figure.panels.push_back(panel);
    drawn.figure.columns = look.wide() ? 2 : 1;
    drawn.figure.width_mm = look.wide() ? page_mm : column_mm;
    drawn.figure.height_mm = look.wide() ? 80.0 : 120.0;
    const auto how = table.metadata.find("C_iso");
    drawn.caption = "A: " + drawn.caption;
    if (C_iso) drawn.caption += fmt::format(" B: C_iso, {}.", how == table.metadata.end() ? "as given" : how->second);
    if (abel)
        drawn.caption += fmt::format(" {}C_iso by the inverse Abel transform of C1D with its standard errors.",
                                     C_iso ? "Points: " : "B: ");
}

std::string title_of(const study::SurfaceResult& surface, const Table& table) {
    if (surface.measurements.empty()) {
        const auto file = table.metadata.find("file");
        return file == table.metadata.end() ? "Power spectral density"
                                            : "Power spectral density of " + file_name(file->second);
    }
    if (surface.measurements.size() == 1)
        return "Power spectral density of " + file_name(surface.measurements.front().file);
    return fmt::format("Power spectral density of {} measurements", surface.measurements.size());
}

}  // namespace

StudyFigure spectrum_figure(const study::SurfaceResult& surface, const Table& table, const Look& look) {
    auto drawn = surface.measurements.empty() ? of_table(surface, table, look) : of_measurements(surface, look);
    drawn.name = "spectrum";
    drawn.title = title_of(surface, table);
    drawn.command = look.command;
    if (!drawn.drawable()) return drawn;
    add_errors(surface, table, drawn);
    add_model(table, drawn);
    add_isotropic(table, look, drawn);
    return drawn;
}

}  // namespace setae::file_figures
