// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/hysteresis/loop_course.hpp"

#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/hysteresis/machine.hpp"

namespace setae::hysteresis {
namespace {

using contact::jkr::State;
using States = std::vector<State>;

/// A loop's states, branch by branch.
struct LoopStates {
    States approach;    ///< from the jump in to the turning point
    States retraction;  ///< from the first motion of the edge to the last contact
    State parted;       ///< force 0 at the motor's position of separation
};

void require_points(int points) {
    constexpr int fewest = 8;
    if (points < fewest)
        throw InvalidArgument(fmt::format("a loop of {} points per branch; expected {} or more", points, fewest));
}

/// Equilibrium at evenly spaced contact radii.
States along(double from, double to, const contact::jkr::Contact& contact, int points) {
    States states;
    for (int i = 0; i < points; ++i) states.push_back(equilibrium(from + (to - from) * i / (points - 1), contact));
    return states;
}

LoopStates states_of(const HystereticSphere& sphere, const Pressing& pressing, const std::optional<MovingEdge>& edge,
                     int points) {
    require_points(points);
    const auto loop = sphere_loop(sphere, pressing);
    const double largest = loop.turning_point.contact_radius;
    LoopStates states{.approach = along(loop.after_jump_in.contact_radius, largest, sphere.approach(), points),
                      .retraction = {},
                      .parted = {}};
    if (!edge) {
        states.retraction = along(largest, loop.separation.contact_radius, sphere.retraction(), points);
        states.parted.displacement = Machine(pressing.machine_stiffness).motor(loop.separation);
        return states;
    }
    const auto course = edge_retraction_course(sphere, pressing, *edge, points);
    for (Index i = 0; i < course.motor.size(); ++i)
        states.retraction.push_back({.force = course.force[i],
                                     .displacement = course.displacement[i],
                                     .contact_radius = course.contact_radius[i]});
    states.parted = states.retraction.back();
    states.retraction.pop_back();
    return states;
}

void require_valid(const Drive& drive) {
    const auto positive = [](double speed) { return speed > 0.0 && std::isfinite(speed); };
    if (!positive(drive.approach_speed) || !positive(drive.retraction_speed) ||
        !(drive.hold_time >= 0.0 && std::isfinite(drive.hold_time)))
        throw InvalidArgument(fmt::format(
            "approach at {} m/s, hold for {} s and retraction at {} m/s; expected speeds above 0 and a time of at least 0",
            drive.approach_speed, drive.hold_time, drive.retraction_speed));
}

}  // namespace

Table loop_course(const HystereticSphere& sphere, const Pressing& pressing, const std::optional<MovingEdge>& edge,
                  int points) {
    const auto loop = states_of(sphere, pressing, edge, points);
    States all{State{}};
    all.insert(all.end(), loop.approach.begin(), loop.approach.end());
    const auto turned = static_cast<Index>(all.size());
    all.insert(all.end(), loop.retraction.begin(), loop.retraction.end());
    all.push_back(loop.parted);
    const auto column = [&](const char* name, const char* unit, auto value) {
        Array1D values(static_cast<Index>(all.size()));
        for (Index i = 0; i < values.size(); ++i) values[i] = value(i);
        return Column{name, unit, values};
    };
    const auto of = [&](double State::*field) {
        return [&all, field](Index i) { return all[static_cast<std::size_t>(i)].*field; };
    };
    return {.columns = {column("displacement", "m", of(&State::displacement)), column("force", "N", of(&State::force)),
                        column("contact_radius", "m", of(&State::contact_radius)),
                        column("branch", "1", [&](Index i) { return i < turned ? 0.0 : 1.0; })},
            .metadata = {}};
}

contact::ContactHistory contact_history(const HystereticSphere& sphere, const Pressing& pressing, const Drive& drive,
                                        const std::optional<MovingEdge>& edge, int points) {
    require_valid(drive);
    const auto loop = states_of(sphere, pressing, edge, points);
    const Machine machine(pressing.machine_stiffness);
    std::vector<double> time;
    States states;
    const auto add = [&](double at, const State& state) {
        if (!time.empty() && !(at > time.back())) return;
        time.push_back(at);
        states.push_back(state);
    };
    for (const auto& state : loop.approach) add(machine.motor(state) / drive.approach_speed, state);
    const auto turning = loop.approach.back(), unpinned = loop.retraction.front();
    const auto turn = static_cast<Index>(time.size()) - 1;
    const double top = machine.motor(turning), left = time.back() + drive.hold_time;
    for (int i = 1; i <= points; ++i) add(time[static_cast<std::size_t>(turn)] + drive.hold_time * i / points, turning);
    const auto leaving = [&](const State& state) {
        return left + (top - machine.motor(state)) / drive.retraction_speed;
    };
    for (int i = 1; i < points; ++i) {
        const double motor = top + (machine.motor(unpinned) - top) * i / points;
        const auto held = machine.pinned(turning, motor, sphere.contact_modulus);
        add(leaving(held), held);
    }
    for (const auto& state : loop.retraction) add(leaving(state), state);
    contact::ContactHistory history{.turn = turn};
    const auto n = static_cast<Index>(time.size());
    history.time = Array1D::Map(time.data(), n);
    history.displacement = history.contact_radius = Array1D(n);
    for (Index i = 0; i < n; ++i) {
        history.displacement[i] = states[static_cast<std::size_t>(i)].displacement;
        history.contact_radius[i] = states[static_cast<std::size_t>(i)].contact_radius;
    }
    return history;
}

}  // namespace setae::hysteresis
