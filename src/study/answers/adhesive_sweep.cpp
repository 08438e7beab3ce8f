// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/answers/adhesive_sweep.hpp"

#include <filesystem>
#include <optional>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"
#include "setae/half_space/adhesive_quantities.hpp"
#include "setae/half_space/loop_checkpoint.hpp"

namespace setae::answers {
namespace {

/// Shares of the way from `first` to `turn` and back.
SweepProgress progress_of(const half_space::LoopStep& step, double first, double turn) {
    const double way = (first - step.position) / (first - turn);
    return {.approaching = step.approaching, .share = 0.5 * (step.approaching ? way : 2.0 - way)};
}

void sweep(SweepAnswer& answer, const TouchingSurface& surface, const SweepRequest& request, parallel::Threads threads,
           const std::function<bool(const SweepProgress&)>& progress) {
    const auto& [body, interaction] = std::tie(answer.body, answer.interaction);
    auto options = request.options(surface.grid);
    half_space::AdhesiveCell cell(surface.heights, surface.grid, body, interaction, {}, threads);
    NotableStates notable;
    options.progress = [&, first = cell.far_gap(), turn = options.turn](const half_space::LoopStep& step) {
        if (request.maps) notable.look(step, cell);
        return !progress || progress(progress_of(step, first, turn));
    };
    std::optional<half_space::LoopCheckpoint> begun;
    if (!request.restart.empty()) {
        const auto key = half_space::loop_key(surface.heights, surface.grid, body, interaction, options);
        begun = half_space::read_checkpoint(request.restart, key);
        if (begun) options.resume = &*begun;
        options.checkpoint = [&, key](const half_space::LoopCheckpoint& checkpoint) {
            half_space::write_checkpoint(request.restart, key, checkpoint);
        };
    }
    answer.loop = half_space::adhesive_loop(cell, options);
    answer.maps = notable.take();
}

}  // namespace

void SweepRequest::require_complete() const {
    constexpr double max_ranges = 4.0;
    (void)body();
    (void)interaction();
    if (!(largest_move > 0.0 && largest_move <= max_ranges))
        throw InvalidArgument(
            fmt::format("a largest move of {} ranges; expected above 0, up to {}", largest_move, max_ranges));
    if (maps && !restart.empty())
        throw InvalidArgument("`maps` with `restart`: states before a stop are not kept; expected one of the two");
}

half_space::LoopOptions SweepRequest::options(const half_space::Grid& grid) const {
    half_space::LoopOptions options;
    if (!stage_stiffness.empty())
        options.stage_stiffness = parse_quantity(stage_stiffness, positive(dimension::stiffness)) / grid.area();
    options.largest_move = largest_move;
    if (!to_gap.empty()) options.turn = parse_quantity(to_gap, non_negative(dimension::length));
    if (!to_pressure.empty()) options.max_pressure = parse_quantity(to_pressure, positive(dimension::pressure));
    return options;
}

void SweepRequest::finish() const {
    if (!restart.empty()) std::filesystem::remove(restart);
}

SweepAnswer adhesive_sweep(const std::string& file, const topography::Measurement& measurement,
                           const SweepRequest& request, parallel::Threads threads,
                           const std::function<bool(const SweepProgress&)>& progress) {
    const auto surface = touching_surface(file, measurement);
    SweepAnswer answer{.file = file,
                       .grid = surface.grid,
                       .body = request.body(),
                       .interaction = request.interaction(),
                       .loop = {},
                       .steps = {},
                       .quantities = {},
                       .maps = {},
                       .alerts = topography::metadata(measurement).alerts};
    sweep(answer, surface, request, threads, progress);
    answer.steps = half_space::loop_table(answer.loop);
    answer.quantities = half_space::loop_quantities(answer.loop);
    for (auto& alert : alerts_of_grid(file, answer.interaction, answer.body, answer.grid))
        answer.alerts.push_back(std::move(alert));
    if (!answer.loop.complete)
        answer.alerts.push_back({"CONTACT_NOT_CONVERGED", file, "some steps of the sweep did not converge",
                                 "resolve the range of the attraction with more points"});
    return answer;
}

}  // namespace setae::answers
