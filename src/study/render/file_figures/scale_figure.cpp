// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/file_figures/scale_figure.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "axes.hpp"

namespace setae::file_figures {
namespace {

using figures::Mark;
using scales::FunctionOfScale;

constexpr Index points_per_curve = 200;
constexpr double rounding = 1e-9;  // as within_limit()

struct Units {
    DisplayUnit distance, value;
};

/// Points of a function below or from its limit, at most some in even steps of ln d, over their units.
struct Part {
    Array1D x, y;
};
Part part_of(const FunctionOfScale& f, bool reliable, const Units& units) {
    std::vector<double> x, y;
    const double step =
        std::log(f.distance[f.distance.size() - 1] / f.distance[0]) / static_cast<double>(points_per_curve);
    double next = 0.0;
    for (Index i = 0; i < f.distance.size(); ++i) {
        const double distance = f.distance[i];
        if ((distance >= f.reliable_from * (1.0 - rounding)) != reliable || distance < next) continue;
        next = distance * std::exp(step) * (1.0 - rounding);
        x.push_back(distance / units.distance.factor);
        y.push_back(f.value[i] / units.value.factor);
    }
    const auto array = [](const std::vector<double>& values) -> Array1D {
        return Eigen::Map<const Array1D>(values.data(), static_cast<Index>(values.size()));
    };
    return {array(x), array(y)};
}

std::string label_of(const FunctionOfScale& f) {
    const auto file = file_name(f.metadata.file);
    return f.metadata.name.empty() || f.metadata.name == file || f.metadata.name == f.metadata.file
               ? file
               : file + ", " + f.metadata.name;
}

void add_function(figures::Panel& panel, const FunctionOfScale& f, int colour, const Units& units) {
    const auto add = [&](const Part& part, bool reliable) {
        if (part.x.size() == 0) return;
        panel.series.push_back({.label = label_of(f) + (reliable ? "" : ", not reliable"),
                                .x = part.x,
                                .y = part.y,
                                .mark = part.x.size() == 1 ? Mark::points : Mark::line,
                                .colour = colour,
                                .dash = reliable ? 0 : 2,
                                .opacity = reliable ? 1.0 : 0.5,
                                .in_legend = false});
    };
    add(part_of(f, false, units), false);
    add(part_of(f, true, units), true);
}

/// Meaning of the lines of a panel.
void add_legend(figures::Panel& panel, bool several, bool cut) {
    if (several)
        panel.series.push_back({.label = "each measurement", .mark = Mark::line, .dash = 0, .legend_only = true});
    if (cut)
        panel.series.push_back({.label = "not reliable",
                                .mark = Mark::line,
                                .colour = several ? black : 0,
                                .dash = 2,
                                .opacity = 0.5,
                                .legend_only = true});
    panel.legend = several || cut;
}

}  // namespace

StudyFigure scale_figure(const std::vector<FunctionOfScale>& functions, const scales::CombinedFunction* combined,
                         const Look& look) {
    const auto& first = functions.front();
    StudyFigure drawn{.identifier = first.quantity, .name = first.quantity, .command = look.command};
    Array1D farthest(static_cast<Index>(functions.size())), highest(farthest.size());
    bool positive = true, cut = false;
    for (std::size_t i = 0; i < functions.size(); ++i) {
        const auto& f = functions[i];
        farthest[static_cast<Index>(i)] = f.distance.maxCoeff();
        highest[static_cast<Index>(i)] = f.value.isFinite().select(f.value.abs(), 0.0).maxCoeff();
        positive = positive && (f.value.isNaN() || f.value > 0.0).all();
        cut = cut || f.distance[0] < f.reliable_from * (1.0 - rounding);
    }
    const Units units{axis_unit(farthest, "m"), axis_unit(highest, first.unit)};
    figures::Panel panel{
        .x = {.quantity = "distance", .unit = units.distance.name, .logarithmic = true},
        .y = {.quantity = in_words(first.quantity), .unit = units.value.name, .logarithmic = positive}};
    for (std::size_t i = 0; i < functions.size(); ++i)
        add_function(panel, functions[i], combined ? static_cast<int>(i % 4) : 0, units);
    if (combined) {
        const Array1D value = combined->value / units.value.factor,
                      error = combined->standard_error / units.value.factor;
        panel.series.push_back({.label = "mean",
                                .x = combined->distance / units.distance.factor,
                                .y = value,
                                .lower = value - error,
                                .upper = value + error,
                                .mark = Mark::both,
                                .colour = black,
                                .symbol = 0,
                                .dash = 0});
    }
    add_legend(panel, combined != nullptr, cut);
    drawn.title = functions.size() == 1
                      ? fmt::format("{} of {}", in_words(first.quantity), file_name(first.metadata.file))
                      : fmt::format("{} of {} measurements", in_words(first.quantity), functions.size());
    drawn.caption = fmt::format(
        "{} against distance{}.{}", in_words(first.quantity),
        combined ? ": each measurement; black: mean in bins, with one standard error between measurements" : "",
        cut ? " Dotted and pale: distances below the reliable limit of sampling, tip or resolution." : "");
    drawn.figure = {
        .panels = {panel}, .width_mm = look.wide() ? 140.0 : column_mm, .height_mm = look.wide() ? 95.0 : 70.0};
    return drawn;
}

}  // namespace setae::file_figures
