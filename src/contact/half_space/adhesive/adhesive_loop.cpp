// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/half_space/adhesive_loop.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "setae/core/errors.hpp"

namespace setae::half_space {
namespace {

constexpr double ladder = 0.5;        ///< ratio of mean gaps close to full contact
constexpr double last_rung = 1e-3;    ///< over ρ
constexpr double min_halved = 1e-4;   ///< a step is not halved below this, over ρ
constexpr double closed_step = 0.25;  ///< step of a stage beyond full contact, divided by ρ
constexpr double max_beyond = 10.0;   ///< distance beyond the start, divided by the distance from the start to the turn
constexpr std::size_t steps_between_checkpoints = 20;

/// Steps of one loop.
class Walk {
public:
    Walk(AdhesiveCell& cell, const LoopOptions& options, double first)
        : cell_(cell), options_(options), range_(cell.interaction().range) {
        if (options.resume) {
            steps_ = options.resume->steps;
            halved_ = options.resume->halved;
            cell_.begin_with(options.resume->gaps);
            return;
        }
        cell_.begin_at(first);
        add({.state = cell_.solve(control(first)), .position = first});
    }

    /// Approaches to `turn`, returns to `first` and, where there is still contact, continues until separation and
    /// returns; false where it was stopped.
    bool there_and_back(double turn, double first) {
        const auto never = [] { return false; };
        if (here().approaching && !to(turn, true, [&] { return pressed(); })) return false;
        if (here().position < first && !to(first, false, never)) return false;
        if (!parted() && !to(first + max_beyond * (first - turn), false, [&] { return parted(); })) return false;
        return to(first, false, never);
    }

    [[nodiscard]] std::vector<LoopStep>& steps() { return steps_; }

private:
    /// Next step: the position, and the corresponding mean gap by the tangent.
    struct Advance {
        double position = 0.0, mean_gap = 0.0;
    };

    [[nodiscard]] const LoopStep& here() const { return steps_.back(); }
    [[nodiscard]] AdhesiveControl control(double position) const {
        if (options_.stage_stiffness) return Stage{position, *options_.stage_stiffness};
        return HeldGap{position};
    }

    [[nodiscard]] bool pressed() const { return here().state.tension <= -options_.max_pressure; }
    /// Whether the state is the initial one within the precision of the energy balance: a neck that is drawn out passes
    /// its energy, too.
    [[nodiscard]] bool parted() const {
        const double touched = steps_.front().state.area_fraction;
        return here().state.area_fraction <= touched &&
               std::abs(here().state.energy() - steps_.front().state.energy()) <=
                   options_.jump_share * cell_.interaction().work_of_adhesion;
    }

    template <class Ended>
    bool to(double target, bool approaching, const Ended& ended) {
        while (here().position != target && !ended()) {
            const Advance most = advance();
            cell_.keep();
            double length = std::min(most.position, halved_);
            for (;; length *= 0.5) {
                const double position = next(target, length);
                const double moved = position - here().position;
                cell_.follow_tangent(most.mean_gap * moved / most.position);
                LoopStep trial{
                    .state = cell_.solve(control(position)), .position = position, .approaching = approaching};
                if (!halve(trial, length)) {
                    halved_ = 2.0 * length;
                    if (!add(trial)) return false;
                    break;
                }
                cell_.restore();
            }
        }
        halved_ = std::numeric_limits<double>::infinity();
        return true;
    }

    Advance advance() {
        const auto tangent = cell_.find_tangent();
        double step = std::clamp(options_.largest_move * range_ / tangent.largest, options_.min_step * range_, range_);
        if (!tangent.stable) step = std::min(step, 0.5 * range_);
        if (!options_.stage_stiffness) return {.position = step, .mean_gap = step};
        if (here().state.mean_gap == 0.0) return {.position = closed_step * range_, .mean_gap = 0.0};
        // dz = d⟨g⟩ (1 + T'/k_m); where that is not positive the stage leads over a fold
        const double stretch = tangent.stable ? 1.0 + tangent.tension_slope / *options_.stage_stiffness : 1.0;
        const double position = std::max(step * stretch, options_.min_step * range_);
        return {.position = position, .mean_gap = stretch > 0.0 ? std::min(step, position / stretch) : step};
    }

    /// The position after a step; near full contact gaps are halved.
    [[nodiscard]] double next(double target, double length) const {
        const double position = here().position;
        const bool approaching = target < position;
        if (options_.stage_stiffness)
            return approaching ? std::max(position - length, target) : std::min(position + length, target);
        const double rung = last_rung * range_;
        if (!approaching) {
            const double most = position == 0.0 ? rung : position / ladder;
            return std::min({position + length, most, target});
        }
        const double next = std::max(position - length, target);
        if (next >= ladder * position) return next;
        return position <= rung ? target : std::max({ladder * position, target, 0.0});
    }

    /// Sets the dissipation of a step; returns whether it contains a jump that a shorter one would resolve.
    bool halve(LoopStep& step, double length) const {
        const AdhesiveState &before = here().state, &after = step.state;
        const double tolerance = options_.jump_share * cell_.interaction().work_of_adhesion;
        step.dissipation = 0.5 * (before.tension + after.tension) * (after.mean_gap - before.mean_gap) -
                           (after.energy() - before.energy());
        const double missed = 0.5 * std::abs((after.tension - before.tension) * (step.position - here().position));
        // work that came from nowhere: the tangent led over a barrier
        const bool gained = step.dissipation < -tolerance;
        const bool jumped = step.dissipation > tolerance && missed > tolerance;
        return (gained || jumped) && length > min_halved * range_;
    }

    bool add(const LoopStep& step) {
        steps_.push_back(step);
        if (options_.progress && !options_.progress(step)) return false;
        if (steps_.size() % steps_between_checkpoints == 0) {
            cell_.begin_with(Array2D(cell_.gaps()));  // removes the state that a resumed loop does not have
            if (options_.checkpoint) options_.checkpoint({steps_, cell_.gaps(), halved_});
        }
        return true;
    }

    AdhesiveCell& cell_;
    const LoopOptions& options_;
    double range_;
    double halved_ = std::numeric_limits<double>::infinity();
    std::vector<LoopStep> steps_;
};

void sum_up(AdhesiveLoop& loop) {
    for (std::size_t n = 1; n < loop.steps.size(); ++n) {
        const auto& before = loop.steps[n - 1].state;
        const auto& step = loop.steps[n];
        const double work = 0.5 * (before.tension + step.state.tension) * (step.state.mean_gap - before.mean_gap);
        (step.approaching ? loop.approach_work : loop.separation_work) += step.approaching ? -work : work;
        (step.approaching ? loop.approach_dissipation : loop.separation_dissipation) += step.dissipation;
        loop.smallest_dissipation = std::min(loop.smallest_dissipation, step.dissipation);
    }
}

void require(const LoopOptions& options, double first) {
    const bool stage = options.stage_stiffness.has_value();
    if (stage && !(*options.stage_stiffness > 0.0 && std::isfinite(*options.stage_stiffness)))
        throw InvalidArgument(fmt::format("stiffness of the stage is {} Pa/m; expected > 0", *options.stage_stiffness));
    if (!(options.max_pressure > 0.0))
        throw InvalidArgument(fmt::format("a loop up to a pressure of {} Pa; expected > 0", options.max_pressure));
    if (!(options.turn < first && std::isfinite(options.turn) && (stage || options.turn >= 0.0)))
        throw InvalidArgument(
            fmt::format("a loop from {} m to {} m and back; expected a turning point {}below the start", first,
                        options.turn, stage ? "" : "at 0 or more, "));
    if (options.resume && options.resume->steps.empty())
        throw InvalidArgument("a loop cannot continue from a checkpoint without steps");
}

}  // namespace

AdhesiveLoop adhesive_loop(AdhesiveCell& cell, const LoopOptions& options) {
    const double first = options.first ? *options.first : cell.far_gap();
    require(options, first);
    Walk walk(cell, options, first);
    const bool ended = walk.there_and_back(options.turn, first);
    AdhesiveLoop loop{.steps = std::move(walk.steps()), .conformal_energy = cell.conformal_energy()};
    sum_up(loop);
    loop.complete = ended && std::ranges::all_of(loop.steps, [](const LoopStep& step) { return step.state.converged; });
    return loop;
}

Table loop_table(const AdhesiveLoop& loop) {
    const auto n = static_cast<Index>(loop.steps.size());
    const auto column = [&](const char* name, const char* unit, auto value) {
        return Column{name, unit, Array1D::NullaryExpr(n, [&](Index i) {
                          return static_cast<double>(value(loop.steps[static_cast<std::size_t>(i)]));
                      })};
    };
    Array1D total(n);
    double sum = 0.0;
    for (Index i = 0; i < n; ++i) total[i] = sum += loop.steps[static_cast<std::size_t>(i)].dissipation;
    Table table;
    table.columns = {column("position", "m", [](const LoopStep& s) { return s.position; }),
                     column("mean_gap", "m", [](const LoopStep& s) { return s.state.mean_gap; }),
                     column("tension", "Pa", [](const LoopStep& s) { return s.state.tension; }),
                     column("elastic_energy", "J/m2", [](const LoopStep& s) { return s.state.elastic_energy; }),
                     column("adhesive_energy", "J/m2", [](const LoopStep& s) { return s.state.adhesive_energy; }),
                     column("area_fraction", "1", [](const LoopStep& s) { return s.state.area_fraction; }),
                     column("dissipation", "J/m2", [](const LoopStep& s) { return s.dissipation; }),
                     {"total_dissipation", "J/m2", total},
                     column("approaching", "1", [](const LoopStep& s) { return s.approaching; }),
                     column("residual", "1", [](const LoopStep& s) { return s.state.residual; }),
                     column("iterations", "1", [](const LoopStep& s) { return s.state.iterations; }),
                     column("transforms", "1", [](const LoopStep& s) { return s.state.transforms; })};
    return table;
}

}  // namespace setae::half_space
