// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/answers/adhesive_contact.hpp"

#include <optional>
#include <utility>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"
#include "setae/half_space/adhesive_quantities.hpp"
#include "setae/half_space/contact_quantities.hpp"

namespace setae::answers {
namespace {

void require_cell(const HardWallRequest& request) {
    if (request.free || !request.hardness.empty())
        throw InvalidArgument(
            "`free` and `hardness` are of a contact without adhesion; expected neither with `work_of_adhesion`");
    if (!request.stage_stiffness.empty() && request.displacement.empty())
        throw InvalidArgument("`stage_stiffness` is of a stage that is displaced; expected `displacement` with it");
}

half_space::AdhesiveControl adhesive_control(const HardWallRequest& request, const half_space::AdhesiveCell& cell) {
    const auto control = request.control();
    if (const auto* gap = std::get_if<half_space::MeanGap>(&control)) return half_space::HeldGap{gap->value};
    if (const auto* pressure = std::get_if<half_space::MeanPressure>(&control))
        return half_space::DeadLoad{-pressure->value};
    std::optional<double> stage;
    if (!request.stage_stiffness.empty())
        stage = parse_quantity(request.stage_stiffness, positive(dimension::stiffness)) / cell.grid().area();
    return cell.displaced(std::get<half_space::Displacement>(control).value, stage);
}

}  // namespace

AdhesiveContactAnswer adhesive_contact(const std::string& file, const topography::Measurement& measurement,
                                       const HardWallRequest& request, const InteractionRequest& attraction,
                                       parallel::Threads threads) {
    require_cell(request);
    const auto body = request.body();
    const auto interaction = attraction.interaction();
    const auto surface = touching_surface(file, measurement);
    half_space::AdhesiveCell cell(surface.heights, surface.grid, body, interaction, {}, threads);
    const auto state = half_space::from_far(cell, adhesive_control(request, cell));
    auto alerts = topography::metadata(measurement).alerts;
    for (auto& alert : alerts_of_grid(file, interaction, body, surface.grid)) alerts.push_back(std::move(alert));
    if (!state.converged)
        alerts.push_back(
            {"CONTACT_NOT_CONVERGED", file,
             fmt::format("gaps may be wrong: stresses depart from equilibrium by {:.1e} of the largest tension",
                         state.residual),
             "resolve the range of the attraction with more points"});
    auto quantities = half_space::adhesive_quantities(cell, state);
    return {file, body, interaction, surface.grid, std::move(cell), state, std::move(quantities), std::move(alerts)};
}

}  // namespace setae::answers
