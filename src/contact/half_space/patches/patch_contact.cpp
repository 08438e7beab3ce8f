// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/patches/patch_contact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/half_space/elastic_operator.hpp"

namespace setae::patches {
namespace {

using half_space::AdhesiveCell;
using half_space::DeadLoad;

constexpr double first_pressure = 0.05;  ///< over h'_rms E*
constexpr double pressure_ratio = 1.5;   ///< ratio of a sequence …
constexpr int halvings = 4;              ///< … and of its last rung, to 3 %
/// Edges of the classes of jumps, D/w.
constexpr std::array jump_edges{0.001, 0.003, 0.01, 0.03, 0.1, 0.3, 1.0};

AdhesiveCell cell_of(const Patch& patch, parallel::Threads threads) {
    return {patch.heights, patch.grid, patch.body, patch.interaction, {}, threads};
}

Unloaded unloaded(const half_space::AdhesiveState& state) {
    return {.area_fraction = state.area_fraction, .gain = -state.energy(), .converged = state.converged};
}

/// Pressed ever more, from afar; between the last rung that leaves gaps and the first that does not by halves.
std::optional<double> pressure_to_close(AdhesiveCell& cell, double unit, double most) {
    const auto closes = [&](double pressure) {
        return cell.solve(DeadLoad{-pressure * unit}).area_fraction >= closed_area;
    };
    double open = 0.0, tried = first_pressure;
    cell.keep();
    while (!closes(tried)) {
        cell.keep();
        open = tried;
        tried *= pressure_ratio;
        if (tried > most) return std::nullopt;
    }
    for (int k = 0; k < halvings; ++k) {
        cell.restore();
        const double middle = 0.5 * (open + tried);
        if (closes(middle)) {
            tried = middle;
        } else {
            cell.keep();
            open = middle;
        }
    }
    return tried;
}

/// Points of full contact at T = 0 are under K h + σ; a tension takes that much from all of them.
double tension_to_open(const Patch& patch, parallel::Threads threads) {
    Array2D stresses(patch.heights.rows(), patch.heights.cols());
    half_space::ElasticOperator elastic(patch.grid, patch.body, half_space::Edges::periodic, threads);
    elastic.pressures(patch.heights, stresses);
    return 1.0 + stresses.minCoeff() / patch.interaction.greatest_tension();
}

std::vector<JumpClass> jumps_of(const half_space::AdhesiveLoop& loop, bool approaching) {
    std::vector<JumpClass> classes;
    for (std::size_t k = 0; k < jump_edges.size(); ++k)
        classes.push_back(
            {.from = jump_edges[k],
             .to = k + 1 < jump_edges.size() ? jump_edges[k + 1] : std::numeric_limits<double>::infinity()});
    for (const auto& step : loop.steps) {
        if (step.approaching != approaching || step.dissipation < jump_edges.front()) continue;
        const auto above = std::ranges::upper_bound(jump_edges, step.dissipation) - jump_edges.begin();
        auto& of = classes[static_cast<std::size_t>(above - 1)];
        of.jumps += 1.0;
        of.loss += step.dissipation;
    }
    return classes;
}

void require(const ContactProtocol& protocol) {
    if (!(protocol.preload > 0.0 && std::isfinite(protocol.preload)))
        throw InvalidArgument(fmt::format("preload of a patch is {} h' E*; expected > 0", protocol.preload));
    if (!(protocol.max_pressure > first_pressure && std::isfinite(protocol.max_pressure)))
        throw InvalidArgument(fmt::format("largest pressure on a patch is {} h' E*; expected above {}",
                                          protocol.max_pressure, first_pressure));
}

}  // namespace

PatchLoop loop_of(const Patch& patch, parallel::Threads threads) {
    auto cell = cell_of(patch, threads);
    const auto loop = half_space::adhesive_loop(cell);
    PatchLoop result{.approach_work = loop.approach_work,
                     .separation_work = loop.separation_work,
                     .approach_dissipation = loop.approach_dissipation,
                     .separation_dissipation = loop.separation_dissipation,
                     .approach_jumps = jumps_of(loop, true),
                     .separation_jumps = jumps_of(loop, false),
                     .steps = static_cast<int>(loop.steps.size()),
                     .complete = loop.complete};
    const double reversible = 1.0 - patch.energy_share;
    result.leftover = std::max(std::abs(loop.approach_work - reversible + loop.approach_dissipation),
                               std::abs(loop.separation_work - reversible - loop.separation_dissipation));
    for (const auto& step : loop.steps)
        result.greatest_tension =
            std::max(result.greatest_tension, step.state.tension / patch.interaction.greatest_tension());
    return result;
}

PatchContact bring_into_contact(const Patch& patch, const ContactProtocol& protocol, parallel::Threads threads) {
    require(protocol);
    auto cell = cell_of(patch, threads);
    const double unit = patch.rms_slope * patch.body.contact_modulus;
    PatchContact contact{.preload = protocol.preload, .opening_tension = tension_to_open(patch, threads)};
    contact.from_far = unloaded(half_space::from_far(cell, DeadLoad{}));
    contact.closing_pressure =
        contact.from_far.area_fraction >= closed_area ? 0.0 : pressure_to_close(cell, unit, protocol.max_pressure);
    half_space::from_far(cell, DeadLoad{-protocol.preload * unit});
    contact.after_preload = unloaded(cell.solve(DeadLoad{}));
    if (protocol.loop) contact.loop = loop_of(patch, threads);
    return contact;
}

}  // namespace setae::patches
