// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "drawing.hpp"
#include "setae/core/errors.hpp"
#include "setae/figures/typesetting.hpp"
#include "setae/loops/profile_likelihood.hpp"
#include "setae/study_figures/loop_figures.hpp"

namespace setae::study_figures {
namespace {

using figures::Mark;
using figures::Panel;
using figures::Place;
using figures::Series;
using loops::RangeFit;

constexpr double one_standard_error =
    0.3934693402873666;  ///< 1 − e^(−1/2): the ellipse whose projection on each axis is one standard error

/// One quantity of the fits that could be made, with one standard error.
template <class Abscissa, class Value>
Series series_of(const std::string& name, int colour, const std::vector<RangeFit>& fits, const Abscissa& abscissa,
                 const Value& value, double factor) {
    std::vector<double> x, y, error;
    for (const auto& f : fits) {
        if (!f.fit || !f.fit->converged) continue;
        x.push_back(abscissa(f));
        y.push_back(factor * value(*f.fit).value);
        error.push_back(factor * value(*f.fit).standard_error);
    }
    const Array1D values = array_of(y), errors = array_of(error);
    return {.label = name,
            .x = array_of(x),
            .y = values,
            .lower = values - errors,
            .upper = values + errors,
            .mark = Mark::both,
            .colour = colour};
}

const Estimate& modulus(const loops::JkrFit& fit) { return fit.contact_modulus; }
const Estimate& work(const loops::JkrFit& fit) { return fit.work_of_adhesion; }

/// Fits in the plane of E* and W, and the ellipse of that over the whole range.
void add_plane(Panel& panel, const NamedScan& named, int colour) {
    const auto add = [&](const std::vector<RangeFit>& fits, bool hollow) {
        std::vector<double> x, y;
        for (const auto& f : fits) {
            if (!f.fit || !f.fit->converged) continue;
            x.push_back(MPa * f.fit->contact_modulus.value);
            y.push_back(mJ * f.fit->work_of_adhesion.value);
        }
        panel.series.push_back({.label = named.name + (hollow ? ", start of the range" : ", end of the range"),
                                .x = array_of(x),
                                .y = array_of(y),
                                .mark = Mark::points,
                                .colour = colour,
                                .hollow = hollow,
                                .in_legend = false});
    };
    add(named.scan.by_start, true);
    add(named.scan.by_end, false);
    const auto& whole = *named.scan.by_end.back().fit;
    try {
        const auto ellipse = loops::error_ellipse(whole, one_standard_error);
        panel.series.push_back({.label = named.name + ", one standard error",
                                .x = ellipse.contact_modulus * MPa,
                                .y = ellipse.work_of_adhesion * mJ,
                                .mark = Mark::line,
                                .colour = colour,
                                .dash = 0,
                                .in_legend = false});
    } catch (const UndefinedDataError&) {
        // a fit without covariance has no ellipse, only its point
    }
}

/// W above E*, against start and end of the range; their plane next to them on a page, below in a column.
void place(figures::Figure& figure, FigureWidth width) {
    const bool page = width == FigureWidth::double_column;
    const double third = 1.0 / 3.0, column = page ? third : 0.5, row = page ? 0.5 : third;
    figure.width_mm = page ? page_mm : column_mm;
    figure.height_mm = page ? 115.0 : highest_column_mm;
    figure.panels[0].place = Place{0.0, 0.0, column, row};
    figure.panels[1].place = Place{column, 0.0, column, row};
    figure.panels[2].place = page ? Place{2.0 * third, 0.0, third, 1.0} : Place{0.0, 2.0 * third, 1.0, third};
    figure.panels[3].place = Place{0.0, row, column, row};
    figure.panels[4].place = Place{column, row, column, row};
    put_legend_above(figure);
}

}  // namespace

StudyFigure range_figure(const std::vector<NamedScan>& scans, const std::string& command, FigureWidth width) {
    StudyFigure drawn{.identifier = "ranges",
                      .name = "ranges",
                      .title = "E* and W of loading against the range of the fit",
                      .command = command};
    if (scans.empty()) {
        drawn.reason = "no loop has a loading branch to fit";
        return drawn;
    }
    const figures::Axis modulus_axis{.quantity = "*E*\\*", .unit = "MPa"},
        work_axis{.quantity = "*W*", .unit = "mJ/m2"};
    const figures::Axis start{.quantity = "samples dropped", .unit = "1"},
        end{.quantity = "largest force/*F*_max", .unit = "1"};
    std::vector<Panel> panels{
        {.title = "A", .shows = "W, later start", .x = start, .y = work_axis},
        {.title = "B", .shows = "W, later end", .x = end, .y = work_axis, .legend = false},
        {.title = "C", .shows = "W and E*", .x = modulus_axis, .y = work_axis, .legend = false},
        {.title = "D", .shows = "E*, later start", .x = start, .y = modulus_axis, .legend = false},
        {.title = "E", .shows = "E*, later end", .x = end, .y = modulus_axis, .legend = false}};
    const auto dropped = [](const RangeFit& f) { return static_cast<double>(f.dropped); };
    const auto share = [](const RangeFit& f) { return f.force_share; };
    std::string slopes;
    for (std::size_t i = 0; i < scans.size(); ++i) {
        const auto& [name, scan] = scans[i];
        const int colour = colour_of_place(i);
        panels[0].series.push_back(series_of(name, colour, scan.by_start, dropped, work, mJ));
        panels[1].series.push_back(series_of(name, colour, scan.by_end, share, work, mJ));
        add_plane(panels[2], scans[i], colour);
        panels[3].series.push_back(series_of(name, colour, scan.by_start, dropped, modulus, MPa));
        panels[4].series.push_back(series_of(name, colour, scan.by_end, share, modulus, MPa));
        slopes += fmt::format("{}{}: {} and {}", slopes.empty() ? "" : "; ", name,
                              figures::number_text(scan.slope * mJ / MPa, 3),
                              figures::number_text(scan.ellipse_slope * mJ / MPa, 3));
    }
    drawn.figure.panels = std::move(panels);
    place(drawn.figure, width);
    drawn.caption = fmt::format(
        "E* and W of the loading fit against the start (A, D) and the end (B, E) of the fitted range, and W against E* (C). Bars are one standard error. In C, hollow: other starts, filled: other ends, "
        "line: one standard error of the fit over the whole range. Slope of W against E* over all ranges, and slope of the ellipse [mJ/m² per MPa]: {}. "
        "If both slopes agree, W and E* are correlated, and an increase of W with the range is not an increase of adhesion.",
        slopes);
    return drawn;
}

}  // namespace setae::study_figures
