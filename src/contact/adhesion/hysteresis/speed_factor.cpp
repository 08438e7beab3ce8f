// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/hysteresis/speed_factor.hpp"

#include <cmath>
#include <vector>

#include "setae/contact/jkr.hpp"

namespace setae::hysteresis {
namespace {

enum Input : std::size_t {
    radius,
    contact_modulus,
    contact_radius,
    machine_stiffness,
    reference_speed,
    exponent,
    rest_factor
};

/// The sphere under the force for a contact radius without adhesion: only the start of the edge is relevant.
struct Pulled {
    HystereticSphere sphere;
    Pressing pressing;
    MovingEdge edge;
};

Pulled pulled(const std::vector<double>& in, const EdgePull& pull, double work) {
    constexpr double next_to_nothing = 1e-9;  // of W_ret: the contact's radius is Hertz's
    const HystereticSphere sphere{in[radius], in[contact_modulus], next_to_nothing * work, in[rest_factor] * work};
    return {sphere,
            {.maximum_force = contact::jkr::force(in[contact_radius], sphere.approach()),
             .machine_stiffness = in[machine_stiffness]},
            {{in[reference_speed], in[exponent]}, pull.motor_speed, pull.reading_time}};
}

double factor_at(const std::vector<double>& in, const EdgePull& pull, double work) {
    const auto [sphere, pressing, edge] = pulled(in, pull, work);
    return work_read(sphere, pressing, edge, pull.reading) / work;
}

std::vector<TracedValue> inputs_of(const TracedSphere& sphere, const TracedEdgeSpeed& edge) {
    return {sphere.radius,        sphere.contact_modulus, sphere.contact_radius, sphere.machine_stiffness,
            edge.reference_speed, edge.exponent,          edge.rest_factor};
}

}  // namespace

double SpeedFactor::at(double factor_there, double of_work) const {
    return of_work > 0.0 ? factor_there * std::pow(of_work / work, slope) : factor_there;
}

double SpeedFactor::at_reading(double factor_there) const {
    return of_reading ? factor.value + (factor_there - factor.value) / (1.0 + slope) : factor_there;
}

SpeedFactor speed_factor(const TracedSphere& sphere, const TracedEdgeSpeed& edge, const EdgePull& pull, double work) {
    const auto inputs = inputs_of(sphere, edge);
    SpeedFactor result{.work = work};
    result.factor = setae::propagated([&](const std::vector<double>& in) { return factor_at(in, pull, work); }, inputs);
    std::vector<double> values;
    for (const auto& input : inputs) values.push_back(input.value);
    constexpr double apart = 1.1;
    const double there = factor_at(values, pull, apart * work);
    result.slope = std::log(there / result.factor.value) / std::log(apart);
    return result;
}

SpeedFactor speed_factor_of_reading(const TracedSphere& sphere, const TracedEdgeSpeed& edge, const EdgePull& pull,
                                    double read) {
    const auto inputs = inputs_of(sphere, edge);
    std::vector<double> values;
    for (const auto& input : inputs) values.push_back(input.value);
    const auto [body, pressing, moving] = pulled(values, pull, read);
    const double work = work_at_rest(body, pressing, moving, pull.reading, read) / values[rest_factor];
    auto result = speed_factor(sphere, edge, pull, work);
    result.of_reading = true;
    return result;
}

}  // namespace setae::hysteresis
