// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/half_space/contact_quantities.hpp"

#include <cmath>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"

namespace setae::half_space {

const char* name_of(SolveStatus status) {
    switch (status) {
        case SolveStatus::converged: return "converged";
        case SolveStatus::not_converged: return "not_converged";
    }
    throw InternalError("a status of a solution without a name");
}

const char* name_of(MeanDisplacement mean) {
    switch (mean) {
        case MeanDisplacement::finite: return "finite";
        case MeanDisplacement::undefined: return "undefined";
        case MeanDisplacement::blocked: return "blocked";
    }
    throw InternalError("a mean displacement without a name");
}

std::vector<Quantity> contact_quantities(const HardWall& problem, const HardWallContact& contact,
                                         double contact_stiffness) {
    const auto quantity = [](const char* name, const char* symbol, double value, const char* unit) {
        Quantity made;
        made.quantity = name;
        made.symbol = symbol;
        made.estimate.value = value;
        made.unit = unit;
        return made;
    };
    std::vector<Quantity> list{
        quantity("area_fraction", "A/A0", contact.area.fraction, "1"),
        quantity("area_fraction_corrected", "", contact.area.corrected_fraction, "1"),
        quantity("perimeter", "", contact.area.perimeter, "m"),
        quantity("patches", "", static_cast<double>(contact.area.patches), "1"),
        quantity("largest_patch", "", contact.area.largest_patch, "m2"),
        quantity("mean_pressure", "p", contact.mean_pressure, "Pa"),
        quantity("largest_pressure", "", contact.pressures.maxCoeff(), "Pa"),
        quantity("mean_gap", "g", contact.mean_gap, "m"),
        quantity("displacement", "d", contact.displacement, "m"),
        quantity("contact_stiffness", "K", contact_stiffness, "Pa/m"),
        quantity("stored_energy", "U_el", contact.stored_energy, "J"),
        quantity("stored_energy_per_area", "U_el/A0", contact.stored_energy / problem.grid.area(), "J/m2"),
    };
    if (problem.hardness) {
        list.push_back(quantity("flowing_fraction", "", contact.flowing_area / problem.grid.area(), "1"));
        list.push_back(quantity("deepest_dent", "", contact.deepest_dent, "m"));
    }
    return list;
}

std::string contact_sentence(const HardWall& problem, const HardWallContact& contact, double contact_stiffness) {
    const char* body = problem.body.layer ? "layer" : "half-space";
    const auto& area = contact.area;
    if (area.patches == 0)
        return fmt::format("The surface does not touch the {}: the mean gap is {}.", body,
                           format_value(contact.mean_gap, "m"));
    const std::string stiffness = std::isinf(contact_stiffness)
                                      ? "no further approach is possible"
                                      : fmt::format("an additional pressure of {} brings the surface 1 nm closer",
                                                    format_value(contact_stiffness * 1e-9, "Pa"));
    return fmt::format(
        "The surface touches the {} on {:.4g} % of the map ({:.4g} % with the correction for the "
        "perimeter) in {} {}, at a mean pressure of {}. The mean gap is {}; {}.",
        body, 100.0 * area.fraction, 100.0 * area.corrected_fraction, area.patches,
        area.patches == 1 ? "patch" : "patches", format_value(contact.mean_pressure, "Pa"),
        format_value(contact.mean_gap, "m"), stiffness);
}

}  // namespace setae::half_space
