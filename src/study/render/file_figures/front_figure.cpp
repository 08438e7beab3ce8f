// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/file_figures/front_figure.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "axes.hpp"
#include "setae/contact/jkr.hpp"

namespace setae::file_figures {
namespace {

/// Steps of one branch that are in contact.
std::vector<Index> steps_of(const Table& table, bool approach) {
    std::vector<Index> steps;
    const auto &approaching = table.at("approaching"), &radius = table.at("area_radius");
    for (Index i = 0; i < table.rows(); ++i)
        if ((approaching[i] > 0.5) == approach && radius[i] > 0.0) steps.push_back(i);
    return steps;
}

/// Curves of one panel: both branches and a smooth sphere.
struct Curves {
    const char *x, *y;
    DisplayUnit x_unit, y_unit;
};

}  // namespace

StudyFigure front_figure(const Table& table, const contact::AdhesiveContact& contact, const std::string& file,
                         const Look& look) {
    StudyFigure drawn{.identifier = "front", .name = "Contact edge", .command = look.command};
    drawn.title = fmt::format("A soft sphere on {}: the contact edge as a crack front", file_name(file));
    if (table.rows() == 0 || !(table.at("area_radius").maxCoeff() > 0.0)) {
        drawn.reason = "no step of the loop is in contact";
        return drawn;
    }
    constexpr Index points = 200;
    const double least = contact::jkr::pull_off_at_fixed_grips(contact).contact_radius;
    const Array1D radii = Array1D::LinSpaced(points, least, std::max(2.0 * least, table.at("area_radius").maxCoeff()));
    Array1D displacement(points), force(points);
    for (Index i = 0; i < points; ++i) {
        displacement[i] = contact::jkr::displacement(radii[i], contact);
        force[i] = contact::jkr::force(radii[i], contact);
    }
    const auto along = axis_unit(table.at("displacement"), "m"), load = axis_unit(table.at("force"), "N"),
               radius = axis_unit(table.at("area_radius"), "m");
    const auto panel = [&](const char* title, const Curves& of, const Array1D& smooth_x, const Array1D& smooth_y) {
        figures::Panel made{
            .title = title,
            .x = {.quantity = of.x == std::string("force") ? "force *F*" : "displacement *δ*", .unit = of.x_unit.name},
            .y = {.quantity = of.y == std::string("force") ? "force *F*" : "contact radius √(*A*/π)",
                  .unit = of.y_unit.name}};
        for (const bool approach : {true, false}) {
            const auto steps = steps_of(table, approach);
            made.series.push_back({.label = approach ? "approach" : "retraction",
                                   .x = table.at(of.x)(steps) / of.x_unit.factor,
                                   .y = table.at(of.y)(steps) / of.y_unit.factor,
                                   .mark = figures::Mark::line,
                                   .colour = approach ? 0 : 1});
        }
        made.series.push_back({.label = "smooth sphere",
                               .x = smooth_x / of.x_unit.factor,
                               .y = smooth_y / of.y_unit.factor,
                               .mark = figures::Mark::line,
                               .colour = black,
                               .dash = 2});
        return made;
    };
    drawn.figure = {.panels = {panel("A", {"displacement", "force", along, load}, displacement, force),
                               panel("B", {"force", "area_radius", load, radius}, force, radii)},
                    .columns = look.wide() ? 2 : 1,
                    .width_mm = look.wide() ? page_mm : column_mm,
                    .height_mm = look.wide() ? 70.0 : 120.0};
    drawn.caption =
        "A: force against displacement; the area between the branches is the energy loss. B: contact radius, √(A/π), against force. "
        "Dashed: a smooth sphere with the same work of adhesion.";
    return drawn;
}

}  // namespace setae::file_figures
