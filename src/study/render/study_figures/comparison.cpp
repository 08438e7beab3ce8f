// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "drawing.hpp"
#include "setae/core/constants.hpp"

namespace setae::study_figures {
namespace {

using figures::Mark;
using figures::Panel;
using figures::Series;
using study::StudyResult;

/// One pair of a comparison, in the units of the axes.
struct Point {
    std::string surface, elastomer;
    double x = 0.0, x_lower = 0.0, x_upper = 0.0;
    double y = 0.0, y_error = undefined;
    double expected = 0.0;  ///< y where the model holds
};

/// A panel and its residuals below it.
struct Comparison {
    Panel values, residuals;
};

/// Every pair as a point of its own: symbol of its surface, colour of its elastomer.
void add_points(Comparison& drawn, const StudyResult& result, const std::vector<Point>& points) {
    for (const auto& p : points) {
        const int symbol = static_cast<int>(place_of_surface(result, p.surface)),
                  colour = colour_of_place(place_of_elastomer(result, p.elastomer));
        const auto name = p.surface + " on " + p.elastomer;
        const auto one = [](double value) { return Array1D::Constant(1, value); };
        drawn.values.series.push_back({.label = name,
                                       .x = one(p.x),
                                       .y = one(p.y),
                                       .lower = one(p.y - p.y_error),
                                       .upper = one(p.y + p.y_error),
                                       .mark = Mark::points,
                                       .colour = colour,
                                       .symbol = symbol,
                                       .left = one(p.x_lower),
                                       .right = one(p.x_upper),
                                       .in_legend = false,
                                       .names = {name}});
        drawn.residuals.series.push_back({.label = name,
                                          .x = one(p.x),
                                          .y = one(p.y - p.expected),
                                          .lower = one(p.y - p.expected - p.y_error),
                                          .upper = one(p.y - p.expected + p.y_error),
                                          .mark = Mark::points,
                                          .colour = colour,
                                          .symbol = symbol,
                                          .in_legend = false,
                                          .names = {name}});
    }
}

/// Meaning of symbols and colours.
void explain(Panel& panel, const StudyResult& result, const std::vector<Point>& points) {
    const auto shown = [&](std::string Point::*name, const std::string& wanted) {
        return std::any_of(points.begin(), points.end(), [&](const Point& p) { return p.*name == wanted; });
    };
    for (std::size_t i = 0; i < result.surfaces.size(); ++i)
        if (shown(&Point::surface, result.surfaces[i].name))
            panel.series.push_back({.label = result.surfaces[i].name,
                                    .mark = Mark::points,
                                    .colour = colour::black,
                                    .symbol = static_cast<int>(i),
                                    .legend_only = true});
    for (std::size_t i = 0; i < result.elastomers.size(); ++i) {
        const auto& elastomer = result.elastomers[i];
        if (!shown(&Point::elastomer, elastomer.input.name)) continue;
        const double modulus = elastomer.youngs_modulus.value;
        panel.series.push_back(
            {.label = elastomer.input.name + (modulus > 0.0 ? fmt::format(", {:.3g} MPa", 1e-6 * modulus) : ""),
             .mark = Mark::line,
             .colour = colour_of_place(i),
             .dash = 0,
             .line_width = 3.0,
             .legend_only = true});
    }
}

/// A straight line through the origin, between two x.
Series line(const std::string& label, double slope, double from, double to) {
    return {.label = label,
            .x = Array1D{{from, to}},
            .y = Array1D{{slope * from, slope * to}},
            .mark = Mark::line,
            .colour = colour::black,
            .dash = 0,
            .line_width = 0.9,
            .in_legend = false};
}

/// Ends of the axes: those of values and bars with a margin, from 0 where the lowest value is near it.
void set_ranges(Comparison& drawn, const std::vector<Point>& points, bool square) {
    const auto ends = [](double& least, double& most, double value, double lower, double upper) {
        least = std::min({least, value, std::isfinite(lower) ? lower : value});
        most = std::max({most, value, std::isfinite(upper) ? upper : value});
    };
    double x_min = HUGE_VAL, x_max = -HUGE_VAL, y_min = HUGE_VAL, y_max = -HUGE_VAL;
    for (const auto& p : points) {
        ends(x_min, x_max, p.x, p.x_lower, p.x_upper);
        ends(y_min, y_max, p.y, p.y - p.y_error, p.y + p.y_error);
    }
    if (square) {
        x_min = y_min = std::min(x_min, y_min);
        x_max = y_max = std::max(x_max, y_max);
    }
    const auto set = [&](figures::Axis& axis, double least, double most) {
        // lines through the origin begin there
        if (!square && least > 0.0) least = 0.0;
        if (square && least > 0.0 && least < 0.3 * most) least = 0.0;
        const double margin = 0.06 * (most > least ? most - least : std::max(std::abs(most), 1.0));
        axis.from = !square && least == 0.0 ? 0.0 : least - margin;
        axis.to = most + margin;
    };
    set(drawn.values.x, x_min, x_max);
    set(drawn.values.y, y_min, y_max);
    drawn.residuals.x.from = drawn.values.x.from;
    drawn.residuals.x.to = drawn.values.x.to;
    drawn.values.x.bare = true;
}

/// Measured against predicted works of adhesion [mJ/m²].
Comparison against_prediction(const StudyResult& result, const std::vector<Point>& points) {
    Comparison drawn;
    drawn.values = {.x = {.quantity = "predicted *W*_{app}", .unit = "mJ/m2"},
                    .y = {.quantity = "measured *W*_{app}", .unit = "mJ/m2"}};
    drawn.residuals = {.x = drawn.values.x,
                       .y = {.quantity = "residual Δ*W*", .unit = "mJ/m2"},
                       .horizontal_lines = {0.0},
                       .legend = false};
    set_ranges(drawn, points, true);
    const double from = *drawn.values.x.from, to = *drawn.values.x.to;
    drawn.values.notes.push_back({.text = "y = x",
                                  .x = from + 0.02 * (to - from),
                                  .y = to - 0.06 * (to - from),
                                  .side = figures::Note::Side::right});
    drawn.values.series.push_back(line("y = x", 1.0, *drawn.values.x.from, *drawn.values.x.to));
    add_points(drawn, result, points);
    return drawn;
}

Point point_of(const study::PairResult& pair, double raw, double error, const Estimate& measured) {
    Point p{.surface = pair.surface,
            .elastomer = pair.elastomer,
            .x = 1e3 * std::max(0.0, raw),
            .x_lower = undefined,
            .x_upper = undefined,
            .y = 1e3 * measured.value};
    if (error > 0.0) {
        p.x_lower = 1e3 * std::max(0.0, raw - error);
        p.x_upper = 1e3 * std::max(0.0, raw + error);
    }
    if (measured.uncertain()) p.y_error = 1e3 * measured.standard_error;
    p.expected = p.x;
    return p;
}

/// Pairs with a measured and a predicted work of adhesion.
std::vector<Point> predicted_points(const StudyResult& result,
                                    std::optional<adhesion::PredictedWork> study::PairResult::*balance) {
    std::vector<Point> points;
    for (const auto& pair : result.pairs)
        if (pair.approach && pair.*balance)
            points.push_back(
                point_of(pair, (pair.*balance)->work.raw, (pair.*balance)->estimate.standard_error, *pair.approach));
    return points;
}

std::string why_no_prediction(const StudyResult& result) {
    if (result.pairs.empty()) return "the study has no pair of surface and elastomer";
    if (std::none_of(result.pairs.begin(), result.pairs.end(),
                     [](const auto& pair) { return pair.approach.has_value(); }))
        return "no pair has a measured work of adhesion";
    if (!result.work_of_adhesion)
        return result.work_of_adhesion.reason.empty() ? "W_int is not known" : result.work_of_adhesion.reason;
    return "no pair has both a measured and a predicted work of adhesion";
}

std::string fit_in_words(const adhesion::WorkFit& fit) {
    return fmt::format("W_int = {}, R² = {:.2f}, n = {}",
                       with_error(fit.generalised.work_of_adhesion.estimate(), 1e3, "mJ/m2"), fit.generalised.r_squared,
                       fit.n);
}

/// Panels of one or two comparisons, each above its residuals.
figures::Figure arranged(const FigureRequest& request, const std::vector<Comparison>& comparisons) {
    const bool two = comparisons.size() > 1;
    // shares of the height and, for two, of the width: the second has the legend next to it
    const double upper = two && !wide(request) ? 0.6 : 0.68, first = 0.43;
    figures::Figure figure;
    const auto add = [&](const Comparison& comparison, const figures::Place& place) {
        figure.panels.push_back(comparison.values);
        figure.panels.back().place = figures::Place{place.left, place.top, place.width, upper * place.height};
        figure.panels.push_back(comparison.residuals);
        figure.panels.back().place =
            figures::Place{place.left, place.top + upper * place.height, place.width, (1.0 - upper) * place.height};
    };
    if (wide(request)) {
        figure.width_mm = two ? page_mm : 120.0;
        figure.height_mm = 100.0;
        add(comparisons[0], {.width = two ? first : 1.0});
        if (two) add(comparisons[1], {.left = first, .width = 1.0 - first});
    } else {
        figure.width_mm = column_mm;
        figure.height_mm = two ? highest_column_mm : 92.0;
        add(comparisons[0], {.height = two ? 0.5 : 1.0});
        if (two) add(comparisons[1], {.top = 0.5, .height = 0.5});
        // a column has no space for a legend next to the axes
        for (std::size_t p = 0; p < figure.panels.size(); p += 2)
            if (figures::legend_strip_mm(figure, p) > 0.0) put_legend_above(figure, p);
    }
    return figure;
}

/// E_loss [nJ] against A_true [mm²].
std::optional<Comparison> loss_comparison(const StudyResult& result, std::vector<Point>& points) {
    if (!result.loop) return std::nullopt;
    const auto& fit = result.loop->through_origin;
    const double slope = 1e3 * fit.generalised.work_of_adhesion.value;
    for (const auto& pair : fit.pairs) {
        const double area = 1e6 * pair.slope, error = 1e6 * std::sqrt(covariance(pair.slope_inputs, pair.slope_inputs));
        Point p{.surface = pair.surface,
                .elastomer = pair.elastomer,
                .x = area,
                .x_lower = undefined,
                .x_upper = undefined,
                .y = 1e9 * pair.measured.value,
                .expected = slope * area};
        if (error > 0.0) {
            p.x_lower = area - error;
            p.x_upper = area + error;
        }
        if (pair.measured.uncertain()) p.y_error = 1e9 * pair.measured.standard_error;
        points.push_back(p);
    }
    Comparison drawn;
    drawn.values = {.x = {.quantity = "true area *A*_{true}", .unit = "mm2"},
                    .y = {.quantity = "energy loss *E*_{loss}", .unit = "nJ"}};
    drawn.residuals = {.x = drawn.values.x,
                       .y = {.quantity = "residual Δ*E*", .unit = "nJ"},
                       .horizontal_lines = {0.0},
                       .legend = false};
    set_ranges(drawn, points, false);
    const auto label = fmt::format("slope {}", with_error(fit.generalised.work_of_adhesion.estimate(), 1e3, "mJ/m²"));
    drawn.values.series.push_back(line(label, slope, 0.0, *drawn.values.x.to));
    drawn.values.notes.push_back({.text = label,
                                  .x = 0.02 * *drawn.values.x.to,
                                  .y = 0.94 * *drawn.values.y.to,
                                  .side = figures::Note::Side::right});
    add_points(drawn, result, points);
    return drawn;
}

}  // namespace

void prediction_and_loss(const FigureRequest& request, StudyFigure& drawn) {
    const auto& result = request.result;
    const auto points = predicted_points(result, &study::PairResult::modified);
    std::vector<Point> losses;
    auto lost = loss_comparison(result, losses);
    if (points.empty() && !lost) {
        drawn.reason = why_no_prediction(result);
        return;
    }
    std::vector<Comparison> comparisons;
    std::string text;
    if (!points.empty()) {
        comparisons.push_back(against_prediction(result, points));
        comparisons.back().values.title = "A";
        comparisons.back().values.shows = "work of adhesion";
        text = fmt::format(
            "A: measured work of adhesion on approach against the prediction of the full-contact balance (Eq. 7), at least 0, for {}, with W_int = {} ({}). Line: y = x{}. ",
            counted(points.size(), "pair"), with_error(*result.work_of_adhesion, 1e3, "mJ/m2"),
            result.work_of_adhesion_source,
            result.modified ? fmt::format("; fit of Eq. 7: {}", fit_in_words(*result.modified)) : "");
    } else {
        text = "A is missing: " + why_no_prediction(result) + ". ";
    }
    if (lost) {
        comparisons.push_back(*lost);
        comparisons.back().values.title = "B";
        comparisons.back().values.shows = "energy loss";
        text += fmt::format(
            "B: energy loss of closed loops against the true area at maximum preload, A_true = r π a_max². Line through the origin (Eq. 10): {}. ",
            fit_in_words(result.loop->through_origin));
    } else {
        text += "B is missing: " + (result.loop.reason.empty() ? std::string("no loop energies") : result.loop.reason) +
                ". ";
    }
    auto& explained = comparisons.back().values;
    explain(explained, result, lost ? losses : points);
    explained.legend_right = true;
    drawn.figure = arranged(request, comparisons);
    drawn.caption =
        text +
        fmt::format(
            "Lower panels: measured minus line. Symbol: surface; colour: elastomer. Bars are ± one standard error of measured and predicted values"
            "{}. Fits are generalised least squares with the covariance of all errors.{} Compare Fig. 4 of Dalvi et al. 2019.",
            points.empty() ? "" : " (from spectrum, modulus, surface energy and W_int), cut at 0",
            reconstruction_note(result) + floored_note(result));
}

void persson_tosatti_prediction(const FigureRequest& request, StudyFigure& drawn) {
    const auto& result = request.result;
    std::vector<Point> points;
    std::string source;
    if (result.persson_tosatti) {
        const auto& fit = *result.persson_tosatti;
        const auto& work = fit.generalised.work_of_adhesion;
        for (const auto& point : fit.pairs) {
            const auto predicted = raw_prediction(point, work);
            const double raw = predicted.value, error = predicted.standard_error();
            for (const auto& pair : result.pairs)
                if (pair.surface == point.surface && pair.elastomer == point.elastomer)
                    points.push_back(point_of(pair, raw, error, point.measured));
        }
        source = "fitted: " + fit_in_words(fit);
    } else {
        points = predicted_points(result, &study::PairResult::persson_tosatti);
        source = "W_int " + result.work_of_adhesion_source;
    }
    if (points.empty()) {
        drawn.reason = why_no_prediction(result);
        return;
    }
    auto comparison = against_prediction(result, points);
    explain(comparison.values, result, points);
    comparison.values.legend_right = true;
    drawn.figure = arranged(request, {comparison});
    drawn.caption = fmt::format(
        "Measured work of adhesion on approach against the prediction of the Persson–Tosatti balance (Eq. S13), W_int (1 + h'²/2) − U_el/A_app, "
        "at least 0, for {} ({}). Line: y = x; lower panel: measured minus predicted. Symbol: surface; colour: elastomer. Bars are ± one standard "
        "error, cut at 0.{} Compare Fig. S8 of Dalvi et al. 2019.",
        counted(points.size(), "pair"), source, reconstruction_note(result));
}

}  // namespace setae::study_figures
