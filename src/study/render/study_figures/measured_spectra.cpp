// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "curves.hpp"
#include "drawing.hpp"

namespace setae::study_figures {
namespace {

using figures::Mark;

constexpr Index points_per_measurement = 120;
constexpr std::size_t max_measurements = 200;

/// The part of a curve with from <= x <= to.
DrawnCurve part(const DrawnCurve& curve, double from, double to) {
    std::vector<double> x, y;
    for (Index i = 0; i < curve.x.size(); ++i)
        if (curve.x[i] >= from && curve.x[i] <= to) {
            x.push_back(curve.x[i]);
            y.push_back(curve.y[i]);
        }
    return {array_of(x), array_of(y)};
}

}  // namespace

void measured_spectra(const FigureRequest& request, const study::SurfaceResult& surface, StudyFigure& drawn) {
    const auto instruments = instrument_bands({&surface});
    figures::Panel panel{.x = {.quantity = "wavevector *q*", .unit = "1/m", .logarithmic = true},
                         .y = {.quantity = "power spectral density *C*_{1D}", .unit = "m3", .logarithmic = true}};
    std::size_t failed = 0;
    double least = HUGE_VAL, most = 0.0;  // range of the reliable part
    const auto add = [&](const DrawnCurve& curve, const std::string& label, const std::string& name, int own,
                         bool reliable) {
        if (curve.x.size() < 1) return;
        panel.series.push_back({.label = label,
                                .x = curve.x,
                                .y = curve.y,
                                .mark = Mark::line,
                                .colour = own,
                                .dash = reliable ? 0 : 2,
                                .line_width = reliable ? 0.7 : 0.6,
                                .opacity = reliable ? 0.75 : 0.35,
                                .in_legend = false});
        panel.series.back().names.assign(static_cast<std::size_t>(curve.x.size()), name);
    };
    std::vector<const study::MeasurementResult*> measured;
    for (const auto& m : surface.measurements) {
        failed += m.failed() ? 1 : 0;
        if (!m.failed() && m.spectrum.wavevector.size() > 0) measured.push_back(&m);
    }
    const auto n = measured.size(), shown = std::min(n, max_measurements);
    for (std::size_t i = 0; i < shown; ++i) {
        const auto& m = *measured[i * n / shown];
        const int own = figures::instrument_look(instrument_of(m)).colour;
        const DrawnCurve whole{m.spectrum.wavevector, m.spectrum.density};
        const double lowest = whole.x[0], highest = whole.x[whole.x.size() - 1];
        add(log_means(part(whole, lowest, std::nextafter(m.spectrum.band.lower, 0.0)), points_per_measurement),
            m.name + ", cut", m.name, own, false);
        add(log_means(part(whole, std::nextafter(m.spectrum.band.upper, HUGE_VAL), highest), points_per_measurement),
            m.name + ", cut", m.name, own, false);
        const auto kept = log_means(part(whole, m.spectrum.band.lower, m.spectrum.band.upper), points_per_measurement);
        add(kept, m.name, m.name, own, true);
        for (const double value : kept.y)
            if (value > 0.0) {
                least = std::min(least, value);
                most = std::max(most, value);
            }
    }
    if (n == 0) {
        drawn.reason = surface.measurements.empty() ? "the surface has no measurements"
                                                    : "every measurement of the surface failed";
        return;
    }
    const auto curve = C1D_of(surface);
    if (curve) {
        if (curve->lower.size() > 0)
            panel.series.push_back({.label = "all measurements, 95 %",
                                    .x = curve->wavevector,
                                    .lower = curve->lower,
                                    .upper = curve->upper,
                                    .mark = Mark::band,
                                    .colour = colour::black,
                                    .in_legend = false});
        panel.series.push_back({.label = curve->method == "likelihood" ? "fit to all" : "average",
                                .x = curve->wavevector,
                                .y = curve->values,
                                .mark = Mark::line,
                                .colour = colour::black,
                                .dash = 0});
    }
    for (const auto& [instrument, band] : instruments)
        panel.series.push_back({.label = instrument,
                                .mark = Mark::line,
                                .colour = figures::instrument_look(instrument).colour,
                                .dash = 0,
                                .legend_only = true});
    panel.series.push_back({.label = "cut: not reliable",
                            .mark = Mark::line,
                            .colour = colour::black,
                            .dash = 2,
                            .opacity = 0.5,
                            .legend_only = true});
    panel.legend_corner = figures::Corner::bottom_left;
    // the excluded part may decrease to zero; it must not compress the reliable part
    if (most > least) {
        const double margin = std::pow(most / least, 0.08);
        panel.y.from = least / margin;
        panel.y.to = most * margin;
    }
    drawn.figure = {
        .panels = {panel}, .width_mm = wide(request) ? 140.0 : column_mm, .height_mm = wide(request) ? 95.0 : 75.0};
    drawn.caption = fmt::format(
        "C1D of {} of {}, coloured by instrument. Solid: reliable band of the instrument. Dotted and pale: cut, "
        "because of the first mode, sampling, resolution or tip.{}{}{} Curves of more than {} points are means "
        "over equal steps of ln q.",
        counted(n, "measurement"), surface.name,
        !curve ? ""
        : curve->method == "likelihood"
            ? " Black: C1D fitted to all measurements together, shaded 95 %; the fit includes window, trend, aliases and tips."
            : " Black: the average of all measurements, shaded 95 % where two or more overlap.",
        shown == n ? "" : fmt::format(" The figure shows {} of them, at equal steps through the list.", shown),
        failed == 0 ? "" : fmt::format(" {} failed.", counted(failed, "measurement")), points_per_measurement);
}

}  // namespace setae::study_figures
