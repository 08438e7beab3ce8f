// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/hysteresis/sphere_loop.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/hysteresis/machine.hpp"
#include "setae/numerics/bracketing.hpp"

namespace setae::hysteresis {
namespace {

void require_positive(double value, const char* name, const char* unit) {
    if (!(value > 0.0 && std::isfinite(value)))
        throw InvalidArgument(fmt::format("{} must be > 0 {}, got {}", name, unit, value));
}

void require_valid(const HystereticSphere& sphere, const Pressing& pressing) {
    require_positive(sphere.radius, "sphere radius", "m");
    require_positive(sphere.contact_modulus, "contact modulus", "Pa");
    require_positive(sphere.work_approach, "work of adhesion on approach", "J/m2");
    if (!(sphere.work_retraction >= sphere.work_approach && std::isfinite(sphere.work_retraction)))
        throw InvalidArgument(
            fmt::format("work of adhesion on retraction must not be below that on approach, {} J/m2, got {}",
                        sphere.work_approach, sphere.work_retraction));
    if (!(pressing.maximum_force >= 0.0 && std::isfinite(pressing.maximum_force)))
        throw InvalidArgument(fmt::format("maximum force must be >= 0 N, got {}", pressing.maximum_force));
    if (!(pressing.machine_stiffness > 0.0))
        throw InvalidArgument(fmt::format("machine stiffness must be > 0 N/m, infinite for fixed grips, got {}",
                                          pressing.machine_stiffness));
}

}  // namespace

double SphereLoop::largest_contact_area() const {
    return pi * turning_point.contact_radius * turning_point.contact_radius;
}

SphereLoop sphere_loop(const HystereticSphere& sphere, const Pressing& pressing) {
    require_valid(sphere, pressing);
    const Machine machine(pressing.machine_stiffness);
    const auto approach = sphere.approach(), retraction = sphere.retraction();
    SphereLoop loop;
    const double largest = contact::jkr::contact_radius_at_force(pressing.maximum_force, approach);
    loop.turning_point = equilibrium(largest, approach);
    loop.after_jump_in = equilibrium(machine.stable_radius(0.0, approach, largest), approach);
    loop.unpinned = equilibrium(largest, retraction);
    loop.separation = equilibrium(std::min(largest, machine.instability_radius(retraction)), retraction);
    const double weakest = contact::jkr::pull_off_at_fixed_load(retraction).contact_radius;
    const double at_smallest = std::clamp(weakest, loop.separation.contact_radius, largest);
    loop.smallest_force = contact::jkr::force(at_smallest, retraction);
    loop.jump_in_loss = -machine.energy(loop.after_jump_in, approach);
    loop.edge_loss = (sphere.work_retraction - sphere.work_approach) * loop.largest_contact_area();
    loop.jump_out_loss = machine.energy(loop.separation, retraction);
    return loop;
}

double work_retraction_for_loss(HystereticSphere sphere, const Pressing& pressing, double energy_loss) {
    sphere.work_retraction = sphere.work_approach;
    const SphereLoop least = sphere_loop(sphere, pressing);
    if (!(energy_loss >= least.energy_loss() && std::isfinite(energy_loss)))
        throw InvalidArgument(
            fmt::format("a loop with W_app = {:.4g} J/m2 loses at least {:.4g} J in its jumps, got {:.4g} J; give a "
                        "larger energy loss or a larger preload",
                        sphere.work_approach, least.energy_loss(), energy_loss));
    const auto excess = [&](double work) {
        sphere.work_retraction = work;
        return sphere_loop(sphere, pressing).energy_loss() - energy_loss;
    };
    const double lower = sphere.work_approach;
    // upper limit: the edge dissipates all of it, in addition to the jump out
    const double upper = lower + energy_loss / least.largest_contact_area();
    return numerics::bracketed_root(excess, lower, upper, 50);
}

}  // namespace setae::hysteresis
