// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/study_figures/hysteresis_figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "drawing.hpp"
#include "setae/core/display_unit.hpp"
#include "setae/core/words.hpp"

namespace setae::study_figures {
namespace {

using figures::Mark;
using figures::Panel;
using hysteresis::EnergyShares;
using study::PairHysteresis;

constexpr double milli = 1e-3;

/// Place of a name in the order in which names come.
int place_of(std::vector<std::string>& names, const std::string& name) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found != names.end()) return static_cast<int>(found - names.begin());
    names.push_back(name);
    return static_cast<int>(names.size()) - 1;
}

Array1D one(double value) { return Array1D::Constant(1, value); }

figures::Series point_of(const PairHysteresis& pair, int symbol, int colour) {
    const auto &measured = *pair.measured_retraction, predicted = pair.work_retraction.estimate();
    const auto error = [](const Estimate& e) { return std::isfinite(e.standard_error) ? e.standard_error : 0.0; };
    const double x = predicted.value / milli, y = measured.value / milli;
    return {.label = fmt::format("{}, {}", pair.surface, pair.elastomer),
            .x = one(x),
            .y = one(y),
            .lower = one(y - error(measured) / milli),
            .upper = one(y + error(measured) / milli),
            .mark = Mark::points,
            .colour = colour,
            .symbol = symbol,
            .hollow = !pair.conforms,
            .left = one(x - error(predicted) / milli),
            .right = one(x + error(predicted) / milli),
            .in_legend = false};
}

figures::Series explained(const std::string& label, int symbol, int colour) {
    return {.label = label, .mark = Mark::points, .colour = colour, .symbol = symbol, .legend_only = true};
}

/// A part of a bar.
figures::Series block(const char* label, double place, double from, double to, int colour, bool in_legend) {
    constexpr double half = 0.35;
    return {.label = label,
            .x = Array1D{{from, from, to, to, from}},
            .y = Array1D{{place - half, place + half, place + half, place - half, place - half}},
            .mark = Mark::area,
            .colour = colour,
            .opacity = 0.8,
            .in_legend = in_legend};
}

std::vector<LossBar> bars_of(const study::Hysteresis& h, bool measured) {
    std::vector<LossBar> bars;
    for (const auto& pair : h.pairs) {
        const auto label = fmt::format("{} {}", pair.surface, pair.elastomer);
        if (measured && pair.decomposition)
            bars.push_back({label, pair.decomposition->shares, pair.decomposition->measured.estimate(),
                            pair.decomposition->of_works});
        if (!measured && pair.loop) bars.push_back({label, pair.loop->shares, std::nullopt});
    }
    return bars;
}

/// A figure of the hysteresis that a study has.
void take(StudyFigure (*figure)(const study::Hysteresis&, FigureWidth), const FigureRequest& request,
          StudyFigure& drawn) {
    const auto& hysteresis = request.result.hysteresis;
    if (!hysteresis) {
        drawn.reason = hysteresis.reason.empty() ? "no W_int is known" : hysteresis.reason;
        return;
    }
    auto made = figure(*hysteresis, request.options.width);
    drawn.title = std::move(made.title);
    drawn.figure = std::move(made.figure);
    drawn.caption = std::move(made.caption);
    drawn.reason = std::move(made.reason);
}

}  // namespace

StudyFigure hysteresis_figure(const study::Hysteresis& h, FigureWidth width) {
    const bool wide = width == FigureWidth::double_column;
    StudyFigure drawn{.identifier = "hysteresis", .name = "hysteresis"};
    drawn.title = "Work of adhesion on retraction: measured against predicted from roughness";
    Panel panel{.x = {.quantity = "predicted *W*_ret at pull-off", .unit = "mJ/m2", .from = 0.0},
                .y = {.quantity = "measured *W*_ret at pull-off", .unit = "mJ/m2", .from = 0.0}};
    std::vector<std::string> surfaces, elastomers;
    std::vector<figures::Series> points;
    double largest = 0.0;
    for (const auto& pair : h.pairs) {
        const int symbol = place_of(surfaces, pair.surface), colour = place_of(elastomers, pair.elastomer);
        if (!pair.measured_retraction) continue;
        points.push_back(point_of(pair, symbol, colour));
        largest = std::max({largest, points.back().upper[0], points.back().right[0]});
    }
    if (points.size() < min_compared_pairs) {
        drawn.reason = points.empty()
                           ? "no pair has a measured W_ret at pull-off"
                           : fmt::format("{} with a measured W_ret at pull-off; a comparison needs at least {}",
                                         setae::counted(points.size(), "pair", "pairs"), min_compared_pairs);
        return drawn;
    }
    panel.series.push_back({.label = "equal",
                            .x = Array1D{{0.0, largest}},
                            .y = Array1D{{0.0, largest}},
                            .mark = Mark::line,
                            .colour = colour::black,
                            .dash = 1,
                            .in_legend = false});
    panel.series.insert(panel.series.end(), points.begin(), points.end());
    for (std::size_t i = 0; i < surfaces.size(); ++i)
        panel.series.push_back(explained(surfaces[i], static_cast<int>(i), colour::black));
    for (std::size_t i = 0; i < elastomers.size(); ++i)
        panel.series.push_back(explained(elastomers[i], 0, static_cast<int>(i)));
    panel.legend_right = wide;
    drawn.figure = {.panels = {panel}, .width_mm = wide ? page_mm : column_mm, .height_mm = wide ? 110.0 : 95.0};
    if (!wide) figures::put_legend_above(drawn.figure);
    std::vector<std::string> laws;
    for (const auto& pair : h.pairs) (void)place_of(laws, pair.model.name());
    drawn.caption = fmt::format(
        "Measured W_ret at pull-off of {} against the prediction from roughness, by {}; bars are one standard error. Symbol: surface; colour: elastomer; "
        "hollow: pairs without spontaneous full contact. Dashed: measured = predicted.",
        setae::counted(points.size(), "pair", "pairs"), fmt::join(laws, ", "));
    return drawn;
}

Panel losses_panel(const std::vector<LossBar>& bars) {
    Array1D losses(static_cast<Index>(bars.size()));
    for (Index i = 0; i < losses.size(); ++i) {
        const auto& bar = bars[static_cast<std::size_t>(i)];
        losses[i] = 0.0;
        for (const auto& [name, share] : EnergyShares::all()) losses[i] += (bar.shares.*share).value;
        if (bar.measured) losses[i] = std::max(losses[i], bar.measured->value);
    }
    const auto unit = display_unit(losses.maxCoeff(), "J");
    const auto count = static_cast<double>(bars.size());
    Panel panel{.x = {.quantity = "energy loss", .unit = unit.name, .from = 0.0},
                .y = {.from = -0.6, .to = count - 0.4}};
    panel.y.tick_labels.resize(bars.size());
    const auto& shares = EnergyShares::all();
    std::array<bool, 2> in_legend{};  // losses of loops, losses computed from works
    const bool relaxes = std::ranges::any_of(bars, [](const LossBar& bar) { return bar.shares.bulk.value != 0.0; });
    for (std::size_t i = 0; i < bars.size(); ++i) {
        const auto& bar = bars[i];
        const auto row = bars.size() - 1 - i;  // the first on top
        const auto place = static_cast<double>(row);
        panel.y.tick_labels[row] = bar.label;
        double from = 0.0;
        for (std::size_t k = 0; k < shares.size(); ++k) {
            if (shares[k].share == &EnergyShares::bulk && !relaxes) continue;
            const double to = from + (bar.shares.*shares[k].share).value / unit.factor;
            panel.series.push_back(block(shares[k].name, place, from, to, static_cast<int>(k), i == 0));
            from = to;
        }
        if (!bar.measured) continue;
        const double error = std::isfinite(bar.measured->standard_error) ? bar.measured->standard_error : 0.0;
        panel.series.push_back({.label = bar.of_works ? "from W_app and W_ret" : "measured",
                                .x = one(bar.measured->value / unit.factor),
                                .y = one(place),
                                .mark = Mark::points,
                                .colour = colour::black,
                                .symbol = 0,
                                .hollow = bar.of_works,
                                .left = one((bar.measured->value - error) / unit.factor),
                                .right = one((bar.measured->value + error) / unit.factor),
                                .in_legend = !std::exchange(in_legend[bar.of_works], true)});
    }
    return panel;
}

StudyFigure loss_shares_figure(const study::Hysteresis& h, FigureWidth width) {
    const bool wide = width == FigureWidth::double_column;
    StudyFigure drawn{.identifier = "losses", .name = "losses"};
    auto bars = bars_of(h, true);
    const bool measured = !bars.empty();
    if (!measured) bars = bars_of(h, false);
    drawn.title = measured ? "Energy budget of measured loops" : "Energy budget of predicted loops";
    if (bars.empty()) {
        drawn.reason =
            "no loop is measured or predicted; a prediction needs sphere_radius and preload of the elastomers";
        return drawn;
    }
    auto panel = losses_panel(bars);
    const auto count = static_cast<double>(bars.size());
    panel.legend_right = wide;
    drawn.figure = {.panels = {panel}, .width_mm = wide ? page_mm : column_mm, .height_mm = 35.0 + 5.0 * count};
    if (!wide) figures::put_legend_above(drawn.figure);
    drawn.caption = fmt::format(
        "{} {}. Bars: jumps of the sphere into and out of contact; additional loss at the crack tip on retraction, from a "
        "smooth reference; loss due to roughness by the retraction model of each pair.{}",
        measured ? "Measured loops of" : "Predicted loops of", setae::counted(bars.size(), "pair", "pairs"),
        measured ? " Symbols: energy loss with one standard error; hollow: computed from the measured W_app and W_ret."
                 : "");
    return drawn;
}

void way_back(const FigureRequest& request, StudyFigure& drawn) { take(hysteresis_figure, request, drawn); }

void shares_of_losses(const FigureRequest& request, StudyFigure& drawn) { take(loss_shares_figure, request, drawn); }

}  // namespace setae::study_figures
