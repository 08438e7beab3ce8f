// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/file_figures/contact_line_figure.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "axes.hpp"
#include "setae/core/units.hpp"

namespace setae::file_figures {
namespace {

using figures::Mark;

constexpr Index max_edges = 12;
constexpr Index max_points = 400;  ///< points of a distribution

figures::Panel edges_panel(const contact_line::ContactLine& line) {
    const double largest = line.radius.maxCoeff();
    const auto unit = axis_unit(Array1D{{largest}}, "m");
    const double end = 1.05 * largest / unit.factor;
    figures::Panel panel{.title = "A",
                         .x = {.quantity = "*x*", .unit = unit.name, .from = -end, .to = end},
                         .y = {.quantity = "*y*", .unit = unit.name, .from = -end, .to = end}};
    const Index n = line.angles(), frames = line.frames(), edges = std::min(frames, max_edges);
    for (Index e = 0; e < edges; ++e) {
        const Index frame = edges > 1 ? e * (frames - 1) / (edges - 1) : 0;
        figures::Series series{
            .x = Array1D(n + 1), .y = Array1D(n + 1), .mark = Mark::line, .colour = 0, .dash = 0, .line_width = 0.8};
        series.opacity = 1.0 - 0.7 * static_cast<double>(e) / static_cast<double>(edges);
        for (Index j = 0; j <= n; ++j) {
            const double angle = 2.0 * pi * static_cast<double>(j % n) / static_cast<double>(n),
                         r = line.radius(frame, j % n) / unit.factor;
            series.x[j] = r * std::cos(angle);
            series.y[j] = r * std::sin(angle);
        }
        panel.series.push_back(std::move(series));
    }
    panel.legend = false;
    return panel;
}

figures::Panel spectrum_panel(const contact_line::LineRoughness& found, double noise_power) {
    const auto unit = axis_unit(found.power.sqrt(), "m");
    const double square = unit.factor * unit.factor;
    figures::Panel panel{.title = "B",
                         .x = {.quantity = "mode *n*", .logarithmic = true},
                         .y = {.quantity = "power |*r_n*|^2", .unit = unit.name + "2", .logarithmic = true}};
    panel.series.push_back({.label = "edge, mean of frames",
                            .x = found.mode,
                            .y = found.power / square,
                            .mark = Mark::points,
                            .colour = 0});
    const Index count = found.largest_mode - found.smallest_mode + 1;
    const Array1D modes = found.mode.segment(found.smallest_mode - 1, count);
    const Array1D law = found.amplitude * modes.pow(-1.0 - 2.0 * found.exponent.value) + noise_power;
    panel.series.push_back({.label = fmt::format("roughness exponent {:.2f}{}", found.exponent.value,
                                                 noise_power > 0.0 ? ", and noise" : ""),
                            .x = modes,
                            .y = law / square,
                            .mark = Mark::line,
                            .colour = 1,
                            .dash = 0});
    return panel;
}

/// The share of numbers that are no smaller than each of at most 400 of them; two numbers or more.
figures::Series exceedance(const char* label, Array1D values, int colour) {
    std::sort(values.begin(), values.end());
    const Index n = values.size(), points = std::min(n, max_points);
    figures::Series series{.label = label,
                           .x = Array1D(points),
                           .y = Array1D(points),
                           .mark = Mark::line,
                           .colour = colour,
                           .dash = colour};
    for (Index k = 0; k < points; ++k) {  // ranks in steps of one factor, from the smallest number
        const double share = static_cast<double>(points - 1 - k) / static_cast<double>(points - 1);
        const auto rank = std::clamp<Index>(static_cast<Index>(std::pow(static_cast<double>(n), share)), 1, n);
        series.x[k] = values[n - rank];
        series.y[k] = static_cast<double>(rank) / static_cast<double>(n);
    }
    return series;
}

figures::Panel distribution_panel(const char* letter, const figures::Axis& axis, const char* share,
                                  const Array1D& receding, const Array1D& advancing, double factor) {
    figures::Panel panel{.title = letter, .x = axis, .y = {.quantity = share, .logarithmic = true}};
    if (receding.size() > 1) panel.series.push_back(exceedance("receding", receding / factor, 0));
    if (advancing.size() > 1) panel.series.push_back(exceedance("advancing", advancing / factor, 1));
    return panel;
}

}  // namespace

StudyFigure contact_line_figure(const ContactLineData& data, const std::string& file, const Look& look) {
    StudyFigure drawn{.identifier = "contact_line", .name = "Contact edge", .command = look.command};
    drawn.title = fmt::format("Contact edge in {}", file_name(file));
    std::vector<figures::Panel> panels{edges_panel(data.line)};
    drawn.caption = "A: the edge in all frames, from the first (dark) to the last.";
    if (data.roughness.mode.size() > 0) {
        const auto& noise = data.line.place_error;
        panels.push_back(spectrum_panel(data.roughness, noise * noise / static_cast<double>(data.line.angles())));
        drawn.caption += " B: power of the modes of the edge, and the fitted power law.";
    }
    if (data.retracting_speeds.size() > 1 || data.advancing_speeds.size() > 1) {
        panels.push_back(distribution_panel("C", {.quantity = "speed *v* over its mean", .logarithmic = true},
                                            "share of faster places", data.retracting_speeds, data.advancing_speeds,
                                            1.0));
        drawn.caption += " C: share of places where the edge moves faster.";
    }
    if (data.retracting_jumps.size() > 1 || data.advancing_jumps.size() > 1) {
        const Array1D& some = data.retracting_jumps.size() > 1 ? data.retracting_jumps : data.advancing_jumps;
        const auto unit = axis_unit(some.sqrt(), "m");
        panels.push_back(distribution_panel(
            "D", {.quantity = "area of a jump *S*", .unit = unit.name + "2", .logarithmic = true},
            "share of larger jumps", data.retracting_jumps, data.advancing_jumps, unit.factor * unit.factor));
        drawn.caption += " D: share of larger jumps.";
    }
    const bool wide = look.wide();
    const auto rows = static_cast<double>(wide ? (panels.size() + 1) / 2 : panels.size());
    drawn.figure = {.panels = std::move(panels),
                    .columns = wide ? 2 : 1,
                    .width_mm = wide ? page_mm : column_mm,
                    .height_mm = 72.0 * rows};
    return drawn;
}

}  // namespace setae::file_figures
