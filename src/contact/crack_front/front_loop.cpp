// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/crack_front/front_loop.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "setae/contact/jkr.hpp"
#include "setae/core/errors.hpp"

namespace setae::crack_front {
namespace {

constexpr double min_halved = 1e-7;  ///< a step is not halved below this share of its length

FrontControl control_at(const LoopPath& path, double position) {
    switch (path.drive) {
        case Drive::displacement: return HeldDisplacement{position};
        case Drive::load: return DeadLoad{position};
        case Drive::stage: break;
    }
    return Stage{position, path.stiffness};
}

/// Steps of one loop.
class LoopWalk {
public:
    LoopWalk(CircularFront& front, const LoopPath& path)
        : front_(front),
          path_(path),
          min_jump_(path.jump_share * contact::jkr::ideal_loop_loss(
                                          {front.sphere().radius, front.sphere().contact_modulus, front.mean_work()})
                                          .total) {}

    FrontLoop run() {
        front_.begin_at(0.0);
        if (path_.drive != Drive::load) loop_.steps.push_back({.state = {.converged = true}});
        const double length = path_.furthest / static_cast<double>(path_.steps);
        bool goes_on = true;
        for (Index k = 0; k <= path_.steps && goes_on; ++k) goes_on = to(static_cast<double>(k) * length);
        approaching_ = false;
        turned_ = front_.edge();
        for (Index k = path_.steps - 1; goes_on && in_contact(); --k) goes_on = to(static_cast<double>(k) * length);
        sum_up();
        return std::move(loop_);
    }

private:
    [[nodiscard]] bool in_contact() const { return !loop_.steps.empty() && loop_.steps.back().state.in_contact; }

    /// Moves to a position, in halved steps where the front jumps, or until separation on retraction; false where it
    /// was stopped.
    bool to(double target) {
        const bool first = loop_.steps.empty();
        for (;;) {
            const double here = first ? target : loop_.steps.back().position;
            const auto kept = front_.edge();
            for (double share = 1.0;; share *= 0.5) {
                const double position = share == 1.0 ? target : here + share * (target - here);
                auto step = step_to(position);
                if (position == here || share < min_halved || !hides_jump(step)) {
                    loop_.steps.push_back(std::move(step));
                    break;
                }
                front_.begin_with(kept);
            }
            const auto& step = loop_.steps.back();
            if (path_.progress && !path_.progress(step)) return false;
            if (step.position == target || (!approaching_ && !step.state.in_contact)) return true;
        }
    }

    FrontStep step_to(double position) {
        FrontStep step{.state = front_.solve(control_at(path_, position)), .position = position};
        step.approaching = approaching_;
        if (!approaching_ && step.state.in_contact) step.min_retreat = (turned_ - front_.edge()).minCoeff();
        const FrontState before = loop_.steps.empty() ? FrontState{} : loop_.steps.back().state;
        if (path_.drive == Drive::load && !step.state.in_contact) return step;  // it falls: no work is known
        const double change = step.state.displacement - before.displacement;
        step.machine_work = 0.5 * (before.force + step.state.force) * change;
        step.dissipation = step.machine_work - (step.state.energy() - before.energy());
        return step;
    }

    [[nodiscard]] bool hides_jump(const FrontStep& step) const {
        const auto& before = loop_.steps.back().state;
        const double missed =
            0.5 * std::abs((step.state.force - before.force) * (step.state.displacement - before.displacement));
        return std::abs(step.dissipation) > min_jump_ && missed > min_jump_;
    }

    void sum_up() {
        for (const auto& step : loop_.steps) {
            (step.approaching ? loop_.approach_dissipation : loop_.retraction_dissipation) += step.dissipation;
            loop_.energy_loss += step.machine_work;
            loop_.smallest_dissipation = std::min(loop_.smallest_dissipation, step.dissipation);
            if (step.dissipation > min_jump_) ++loop_.jumps;
        }
        loop_.complete = !in_contact() &&
                         std::ranges::all_of(loop_.steps, [](const FrontStep& step) { return step.state.converged; });
    }

    CircularFront& front_;
    const LoopPath& path_;
    double min_jump_;
    bool approaching_ = true;
    Array1D turned_;
    FrontLoop loop_;
};

}  // namespace

FrontLoop front_loop(CircularFront& front, const LoopPath& path) {
    if (!(path.furthest > 0.0 && path.steps >= 1))
        throw InvalidArgument(
            fmt::format("a loop to {} in {} steps; expected a turning point above 0 and at least one step",
                        path.furthest, path.steps));
    return LoopWalk(front, path).run();
}

Table loop_table(const FrontLoop& loop, Drive drive) {
    const auto n = static_cast<Index>(loop.steps.size());
    const auto column = [&](const char* name, const char* unit, auto value) {
        return Column{name, unit, Array1D::NullaryExpr(n, [&](Index i) {
                          return static_cast<double>(value(loop.steps[static_cast<std::size_t>(i)]));
                      })};
    };
    Table table;
    table.columns = {
        column("position", drive == Drive::load ? "N" : "m", [](const FrontStep& s) { return s.position; }),
        column("displacement", "m", [](const FrontStep& s) { return s.state.displacement; }),
        column("force", "N", [](const FrontStep& s) { return s.state.force; }),
        column("mean_radius", "m", [](const FrontStep& s) { return s.state.mean_radius; }),
        column("area_radius", "m", [](const FrontStep& s) { return s.state.area_radius; }),
        column("smallest_radius", "m", [](const FrontStep& s) { return s.state.smallest_radius; }),
        column("largest_radius", "m", [](const FrontStep& s) { return s.state.largest_radius; }),
        column("perimeter", "m", [](const FrontStep& s) { return s.state.perimeter; }),
        column("elastic_energy", "J", [](const FrontStep& s) { return s.state.elastic_energy; }),
        column("surface_energy", "J", [](const FrontStep& s) { return s.state.surface_energy; }),
        column("dissipation", "J", [](const FrontStep& s) { return s.dissipation; }),
        column("approaching", "1", [](const FrontStep& s) { return s.approaching; }),
        column("residual", "1", [](const FrontStep& s) { return s.state.residual; }),
        column("iterations", "1", [](const FrontStep& s) { return s.state.iterations; })};
    Array1D total(n);
    double sum = 0.0;
    for (Index i = 0; i < n; ++i) total[i] = sum += loop.steps[static_cast<std::size_t>(i)].dissipation;
    table.columns.insert(table.columns.begin() + 11, {"total_dissipation", "J", total});
    return table;
}

}  // namespace setae::crack_front
