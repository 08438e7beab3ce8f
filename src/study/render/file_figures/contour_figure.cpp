// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/file_figures/contour_figure.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "axes.hpp"

namespace setae::file_figures {
namespace {

using figures::Mark;
using figures::Panel;

/// A curve's points with their standard errors [m].
struct Drawn {
    Array1D x, y, standard_error;
};

Drawn drawn_of(const study::ContourProfile& profile, study::ContourShape shape) {
    if (shape == study::ContourShape::parametric) return {profile.curve.x, profile.curve.y, {}};
    const auto& p = profile.levelled.profile;
    return {p.positions, p.heights, p.standard_error};
}

Panel panel_of(const Drawn& curve, const std::string& title) {
    const Array1D x = curve.x - curve.x.minCoeff();
    const auto across = axis_unit(x, "m"), height = axis_unit(curve.y, "m");
    Panel panel{.title = title,
                .x = {.quantity = "*x*", .unit = across.name, .from = 0.0, .to = x.maxCoeff() / across.factor},
                .y = {.quantity = "height *h*", .unit = height.name},
                .legend = false};
    if (curve.standard_error.size() > 0) {
        const Array1D half = normal_95 * curve.standard_error;
        panel.series.push_back({.label = "95 %",
                                .x = x / across.factor,
                                .lower = (curve.y - half) / height.factor,
                                .upper = (curve.y + half) / height.factor,
                                .mark = Mark::band,
                                .colour = 0});
    }
    panel.series.push_back({.label = "contour",
                            .x = x / across.factor,
                            .y = curve.y / height.factor,
                            .mark = Mark::line,
                            .colour = black,
                            .dash = 0,
                            .line_width = 0.8});
    return panel;
}

}  // namespace

StudyFigure contour_figure(const study::TracedPicture& picture, const std::vector<std::size_t>& segments,
                           study::ContourShape shape, const Look& look) {
    StudyFigure drawn{.identifier = "contour",
                      .name = stem(picture.micrograph.file) + "_contour",
                      .title = "Contour of " + file_name(picture.micrograph.file),
                      .command = look.command};
    bool errors = false;
    for (const auto segment : segments) {
        const auto curve = drawn_of(picture.profiles.at(segment), shape);
        errors = errors || curve.standard_error.size() > 0;
        drawn.figure.panels.push_back(
            panel_of(curve, segments.size() == 1 ? "" : fmt::format("segment {}", segment + 1)));
    }
    const auto n = static_cast<double>(segments.size());
    drawn.figure.width_mm = look.wide() ? page_mm : column_mm;
    drawn.figure.height_mm = std::max(55.0, 40.0 * n);
    drawn.caption = fmt::format("{}. Heights and lengths have different scales.{}",
                                shape == study::ContourShape::parametric
                                    ? "The curve traced in the picture"
                                    : "The profile of the contour traced in the picture, measured from its mean line",
                                errors ? " Shaded: 95 % interval of each height." : "");
    return drawn;
}

}  // namespace setae::file_figures
