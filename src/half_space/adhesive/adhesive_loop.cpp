// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/half_space/adhesive_loop.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "setae/core/errors.hpp"

namespace setae::half_space {
namespace {

constexpr double ladder = 0.5;         ///< ratio of mean gaps close to full contact
constexpr double last_rung = 1e-3;     ///< over ρ
constexpr double least_halved = 1e-4;  ///< a step is not halved below this, over ρ

/// Steps of one loop.
class Walk {
public:
    Walk(AdhesiveCell& cell, const LoopOptions& options, double first)
        : cell_(cell), options_(options), first_(first), range_(cell.interaction().range) {
        cell_.begin_at(first);
        const auto state = cell_.solve(HeldGap{first});
        add({.state = state});
    }

    /// To a mean gap, in steps; false where it was told to end.
    bool to(double target) {
        approaching_ = target < here().mean_gap;
        double limit = std::numeric_limits<double>::infinity();
        while (here().mean_gap != target) {
            const auto tangent = cell_.find_tangent();
            double step =
                std::clamp(options_.largest_move * range_ / tangent.largest, options_.least_step * range_, range_);
            if (!tangent.stable) step = std::min(step, 0.5 * range_);
            cell_.keep();
            double length = std::min(step, limit);
            for (;; length *= 0.5) {
                const double gap = next_gap(target, length);
                cell_.follow_tangent(gap - here().mean_gap);
                LoopStep trial{.state = cell_.solve(HeldGap{gap}), .approaching = approaching_};
                if (!halve(trial, length)) {
                    limit = 2.0 * length;
                    if (!add(trial)) return false;
                    break;
                }
                cell_.restore();
            }
        }
        return true;
    }

    [[nodiscard]] std::vector<LoopStep>& steps() { return steps_; }

private:
    [[nodiscard]] const AdhesiveState& here() const { return steps_.back().state; }

    /// The mean gap a step leads to; near full contact gaps go by halves.
    [[nodiscard]] double next_gap(double target, double length) const {
        const double gap = here().mean_gap;
        const double rung = last_rung * range_;
        if (!approaching_) {
            const double most = gap == 0.0 ? rung : gap / ladder;
            return std::min({gap + length, most, target});
        }
        const double next = std::max(gap - length, target);
        if (next >= ladder * gap) return next;
        return gap <= rung ? target : std::max({ladder * gap, target, 0.0});
    }

    /// Sets the dissipation of a step; whether it hides a jump that a shorter one would show.
    bool halve(LoopStep& step, double length) const {
        const double change = step.state.mean_gap - here().mean_gap;
        const double tolerance = options_.jump_share * cell_.interaction().work_of_adhesion;
        step.dissipation =
            0.5 * (here().tension + step.state.tension) * change - (step.state.energy() - here().energy());
        const double missed = 0.5 * std::abs((step.state.tension - here().tension) * change);
        // work that came from nowhere: the tangent led over a barrier
        const bool gained = step.dissipation < -tolerance;
        const bool jumped = step.dissipation > tolerance && missed > tolerance;
        return (gained || jumped) && length > least_halved * range_;
    }

    bool add(const LoopStep& step) {
        steps_.push_back(step);
        return !options_.progress || options_.progress(step);
    }

    AdhesiveCell& cell_;
    const LoopOptions& options_;
    double first_, range_;
    bool approaching_ = true;
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

}  // namespace

AdhesiveLoop adhesive_loop(AdhesiveCell& cell, const LoopOptions& options) {
    const double first = options.first_gap > 0.0 ? options.first_gap : cell.far_gap();
    if (!(options.closest_gap >= 0.0 && options.closest_gap < first))
        throw InvalidArgument(
            fmt::format("a loop from {} m to {} m and back; expected a closest gap of 0 or more below "
                        "the first",
                        first, options.closest_gap));
    Walk walk(cell, options, first);
    const bool ended = walk.to(options.closest_gap) && walk.to(first);
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
    table.columns = {column("mean_gap", "m", [](const LoopStep& s) { return s.state.mean_gap; }),
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
