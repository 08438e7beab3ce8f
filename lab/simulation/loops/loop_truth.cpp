// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/simulation/loop_truth.hpp"

#include <cmath>

#include <fmt/format.h>

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
}

}  // namespace

hysteresis::SphereLoop true_loop(const hysteresis::HystereticSphere& specimen, const LoadingProtocol& protocol,
                                 const hysteresis::ViscousBody& body) {
    require_valid(protocol);
    return hysteresis::sphere_loop(specimen, protocol.pressing(), protocol.drive(), body);
}

}  // namespace setae::simulation
