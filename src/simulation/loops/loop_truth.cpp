// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/simulation/loop_truth.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "machine.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::simulation {
namespace {

void require_positive(double value, const char* name, const char* unit) {
    if (!(value > 0.0 && std::isfinite(value)))
        throw InvalidArgument(fmt::format("{} must be > 0 {}, got {}", name, unit, value));
}

void require_not_negative(double value, const char* name, const char* unit) {
    if (!(value >= 0.0 && std::isfinite(value)))
        throw InvalidArgument(fmt::format("{} must be >= 0 {}, got {}", name, unit, value));
}

void require_valid(const LoopSpecimen& specimen) {
    require_positive(specimen.radius, "sphere radius", "m");
    require_positive(specimen.contact_modulus, "contact modulus", "Pa");
    require_positive(specimen.work_approach, "work of adhesion on approach", "J/m2");
    if (!(specimen.work_retraction >= specimen.work_approach && std::isfinite(specimen.work_retraction)))
        throw InvalidArgument(
            fmt::format("work of adhesion on retraction must not be below that on approach, {} J/m2, got {}",
                        specimen.work_approach, specimen.work_retraction));
}

void require_valid(const LoadingProtocol& protocol) {
    require_positive(protocol.maximum_force, "maximum force", "N");
    require_positive(protocol.approach_speed, "approach speed", "m/s");
    require_positive(protocol.retraction_speed, "retraction speed", "m/s");
    require_positive(protocol.start_gap, "start gap", "m");
    require_not_negative(protocol.hold_time, "hold time", "s");
    require_positive(protocol.force_rate, "force rate", "1/s");
    require_positive(protocol.camera_rate, "camera rate", "1/s");
    if (protocol.camera_rate > protocol.force_rate)
        throw InvalidArgument(fmt::format("camera rate must not exceed the force rate, {} 1/s, got {}",
                                          protocol.force_rate, protocol.camera_rate));
    if (!(protocol.machine_stiffness > 0.0))
        throw InvalidArgument(fmt::format("machine stiffness must be > 0 N/m, infinite for fixed grips, got {}",
                                          protocol.machine_stiffness));
}

}  // namespace

double LoopTruth::largest_contact_area() const {
    return pi * turning_point.contact_radius * turning_point.contact_radius;
}

LoopTruth loop_truth(const LoopSpecimen& specimen, const LoadingProtocol& protocol) {
    require_valid(specimen);
    require_valid(protocol);
    const Machine machine(protocol.machine_stiffness);
    const auto approach = machine.approach(specimen), retraction = machine.retraction(specimen);
    LoopTruth truth;
    const double largest = contact::jkr::contact_radius_at_force(protocol.maximum_force, approach);
    truth.turning_point = equilibrium(largest, approach);
    truth.after_jump_in = equilibrium(machine.stable_radius(0.0, approach, largest), approach);
    truth.unpinned = equilibrium(largest, retraction);
    truth.parting = equilibrium(std::min(largest, machine.instability_radius(retraction)), retraction);
    const double weakest = contact::jkr::pull_off_at_fixed_load(retraction).contact_radius;
    const double at_smallest = std::clamp(weakest, truth.parting.contact_radius, largest);
    truth.smallest_force = contact::jkr::force(at_smallest, retraction);
    truth.jump_in_loss = -machine.energy(truth.after_jump_in, approach);
    truth.pinning_loss = (specimen.work_retraction - specimen.work_approach) * truth.largest_contact_area();
    truth.jump_out_loss = machine.energy(truth.parting, retraction);
    return truth;
}

}  // namespace setae::simulation
