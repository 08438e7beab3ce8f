// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/half_space/adhesive_quantities.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "setae/core/units.hpp"
#include "setae/half_space/contact_area.hpp"

namespace setae::half_space {
namespace {

Quantity number(const char* name, const char* symbol, double value, const char* unit) {
    Quantity made;
    made.quantity = name;
    made.symbol = symbol;
    made.estimate.value = value;
    made.unit = unit;
    return made;
}

double greatest_tension(const AdhesiveLoop& loop) {
    double greatest = 0.0;
    for (const auto& step : loop.steps) greatest = std::max(greatest, step.state.tension);
    return greatest;
}

}  // namespace

std::vector<Quantity> adhesive_quantities(const AdhesiveCell& cell, const AdhesiveState& state) {
    const auto area = contact_area((cell.gaps() == 0.0).cast<double>(), cell.grid(), cell.slab());
    return {number("area_fraction", "A/A0", area.fraction, "1"),
            number("area_fraction_corrected", "", area.corrected_fraction, "1"),
            number("perimeter", "", area.perimeter, "m"),
            number("patches", "", static_cast<double>(area.patches), "1"),
            number("largest_patch", "", area.largest_patch, "m2"),
            number("mean_pressure", "p", -state.tension, "Pa"),
            number("mean_gap", "g", state.mean_gap, "m"),
            number("displacement", "", cell.displacement(state), "m"),
            number("stored_energy_per_area", "U_el/A0", state.elastic_energy, "J/m2"),
            number("adhesive_energy_per_area", "U_ad/A0", state.adhesive_energy, "J/m2"),
            number("full_contact_energy", "e", cell.conformal_energy(), "J/m2")};
}

std::vector<Quantity> loop_quantities(const AdhesiveLoop& loop) {
    return {number("approach_work", "W_appr", loop.approach_work, "J/m2"),
            number("separation_work", "W_sep", loop.separation_work, "J/m2"),
            number("loss", "W_sep - W_appr", loop.loss(), "J/m2"),
            number("approach_dissipation", "D_appr", loop.approach_dissipation, "J/m2"),
            number("separation_dissipation", "D_sep", loop.separation_dissipation, "J/m2"),
            number("smallest_dissipation", "", loop.smallest_dissipation, "J/m2"),
            number("greatest_tension", "", greatest_tension(loop), "Pa"),
            number("full_contact_energy", "e", loop.conformal_energy, "J/m2")};
}

std::string adhesive_sentence(const AdhesiveCell& cell, const AdhesiveState& state) {
    const double w = cell.interaction().work_of_adhesion;
    return fmt::format(
        "On approach from a large distance, the surface touches the body on {:.4g} % of the map at a "
        "mean pressure of {}; the mean gap is {}. Full contact would store {:.3g} of the work of "
        "adhesion.",
        100.0 * state.area_fraction, format_value(-state.tension, "Pa"), format_value(state.mean_gap, "m"),
        cell.conformal_energy() / w);
}

std::string loop_sentence(const AdhesiveLoop& loop, const Interaction& interaction) {
    if (!loop.complete)
        return fmt::format("The sweep is not complete: it ends after {} steps, or some steps did not converge.",
                           loop.steps.size());
    double area = 0.0;
    for (const auto& step : loop.steps) area = std::max(area, step.state.area_fraction);
    return fmt::format(
        "Per unit area, attraction does a work of {} on approach, and separation needs {}: {} are lost, "
        "{:.3g} of the work of adhesion. Contact reaches {:.4g} % of the map; the largest tension is "
        "{}.",
        format_value(loop.approach_work, "J/m2"), format_value(loop.separation_work, "J/m2"),
        format_value(loop.loss(), "J/m2"), loop.loss() / interaction.work_of_adhesion, 100.0 * area,
        format_value(greatest_tension(loop), "Pa"));
}

}  // namespace setae::half_space
