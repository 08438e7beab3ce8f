// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/answers/hard_wall.hpp"

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"
#include "setae/half_space/contact_quantities.hpp"
#include "setae/processing/pipeline.hpp"

namespace setae::answers {

half_space::Control HardWallRequest::control() const {
    const int given = (pressure.empty() ? 0 : 1) + (displacement.empty() ? 0 : 1) + (mean_gap.empty() ? 0 : 1);
    if (given != 1)
        throw InvalidArgument(
            fmt::format("{} of `pressure`, `displacement` and `mean_gap` were given; expected one", given));
    if (!pressure.empty()) return half_space::MeanPressure{parse_quantity(pressure, dimension::pressure)};
    if (!mean_gap.empty()) return half_space::MeanGap{parse_quantity(mean_gap, dimension::length)};
    return half_space::Displacement{parse_quantity(displacement, dimension::length)};
}

void HardWallRequest::require_complete() const {
    (void)body();
    (void)control();
}

HardWallAnswer hard_wall(const std::string& file, const topography::Measurement& measurement,
                         const HardWallRequest& request, parallel::Threads threads,
                         const std::function<void(const half_space::SolveProgress&)>& progress) {
    if (!request.stage_stiffness.empty())
        throw InvalidArgument(
            "`stage_stiffness` belongs to a contact with adhesion; expected `work_of_adhesion` and `range` with it");
    auto surface = touching_surface(file, measurement);
    HardWallAnswer answer{.file = file,
                          .problem = {.grid = surface.grid,
                                      .body = request.body(),
                                      .heights = std::move(surface.heights),
                                      .control = request.control(),
                                      .hardness = {}},
                          .contact = {},
                          .stiffness = 0.0,
                          .quantities = {},
                          .alerts = topography::metadata(measurement).alerts};
    auto& [path, problem, contact, stiffness, quantities, alerts] = answer;
    if (request.free) problem.edges = surface.line ? half_space::Edges::periodic_along_x : half_space::Edges::free;
    if (!request.hardness.empty()) problem.hardness = parse_quantity(request.hardness, dimension::pressure);
    contact = half_space::solve(problem, {.tolerance = request.tolerance, .threads = threads, .progress = progress});
    stiffness = half_space::contact_stiffness(problem, contact, threads);
    if (contact.status == half_space::SolveStatus::not_converged)
        alerts.push_back({"CONTACT_NOT_CONVERGED", file,
                          fmt::format("pressures may be wrong: the duality gap is {:.1e}, the tolerance {:.1e}",
                                      contact.certificate.duality_gap, request.tolerance),
                          "raise `tolerance`, or resolve the surface's shortest waves with more points"});
    quantities = half_space::contact_quantities(problem, contact, stiffness);
    return answer;
}

}  // namespace setae::answers
