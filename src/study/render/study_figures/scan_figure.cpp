// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "drawing.hpp"

namespace setae::study_figures {
namespace {

using study::MeasurementResult;

bool is_scan(const MeasurementResult& m) {
    return !m.failed() && instrument_of(m) == "stylus" && m.preview.positions.size() > 1 &&
           m.preview.heights.size() == m.preview.positions.size();
}

/// The longest stylus scan of a surface.
const MeasurementResult* scan_of(const study::SurfaceResult& surface) {
    const MeasurementResult* longest = nullptr;
    for (const auto& m : surface.measurements)
        if (is_scan(m) && (!longest || m.preview.size[0] > longest->preview.size[0])) longest = &m;
    return longest;
}

/// The lowest and the highest of each of `stretches` stretches, in order of x.
DrawnCurve extremes(const Array1D& x, const Array1D& y, Index stretches) {
    if (x.size() <= 2 * stretches) return {x, y};
    std::vector<double> across, up;
    for (Index s = 0; s < stretches; ++s) {
        const Index first = s * x.size() / stretches, last = (s + 1) * x.size() / stretches - 1;
        Index low = -1, high = -1;
        for (Index i = first; i <= last; ++i) {
            if (!std::isfinite(y[i])) continue;
            if (low < 0 || y[i] < y[low]) low = i;
            if (high < 0 || y[i] > y[high]) high = i;
        }
        if (low < 0) continue;
        for (const Index i : {std::min(low, high), std::max(low, high)}) {
            across.push_back(x[i]);
            up.push_back(y[i]);
        }
    }
    return {array_of(across), array_of(up)};
}

}  // namespace

void stylus_scans(const FigureRequest& request, StudyFigure& drawn) {
    std::string names;
    double highest = 0.0, longest = 0.0;
    for (const auto& surface : drawn_surfaces(request.result))
        if (const auto* scan = scan_of(surface)) {
            highest =
                std::max(highest, scan->preview.heights.isFinite().select(scan->preview.heights.abs(), 0.0).maxCoeff());
            longest = std::max(longest, scan->preview.size[0]);
        }
    if (longest == 0.0) {
        drawn.reason = request.result.surfaces.empty() ? "the study has no surface" : "no surface has a stylus scan";
        return;
    }
    const bool millimetres = longest >= 1e-3, micrometres = highest >= 1e-6;
    figures::Figure figure;
    for (const auto& surface : drawn_surfaces(request.result)) {
        const auto* scan = scan_of(surface);
        if (!scan) continue;
        const auto curve = extremes(scan->preview.positions - scan->preview.positions[0], scan->preview.heights, 200);
        figures::Panel panel{.title = surface.name,
                             .x = {.quantity = "*x*", .unit = millimetres ? "mm" : "um"},
                             .y = {.quantity = "height *h*", .unit = micrometres ? "um" : "nm"},
                             .legend = false};
        panel.series.push_back({.label = scan->name,
                                .x = curve.x * (millimetres ? 1e3 : 1e6),
                                .y = curve.y * (micrometres ? 1e6 : 1e9),
                                .mark = figures::Mark::line,
                                .colour = figures::instrument_look("stylus").colour,
                                .dash = 0,
                                .line_width = 0.8});
        panel.x.from = 0.0;
        panel.x.to = scan->preview.size[0] * (millimetres ? 1e3 : 1e6);
        figure.panels.push_back(panel);
        names += fmt::format("{}{}: {}", names.empty() ? "" : "; ", surface.name, scan->name);
    }
    arrange(figure, request.options.width, 40.0);
    drawn.figure = figure;
    drawn.caption = fmt::format(
        "The longest stylus scan of each surface, trend removed ({}). The figure shows the lowest and the highest point of each of 200 intervals.{} "
        "Compare Fig. S1 of Dalvi et al. 2019.",
        names, left_out_surfaces(request.result));
}

}  // namespace setae::study_figures
