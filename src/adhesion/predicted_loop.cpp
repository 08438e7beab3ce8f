// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/adhesion/predicted_loop.hpp"

#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "setae/adhesion/traced_function.hpp"
#include "setae/contact/jkr.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/numerics/bracketing.hpp"

namespace setae::adhesion {
namespace {

using roughness::SpectralParameters;

/// Everything a loop depends on, without errors.
struct Inputs {
    double contact_modulus, surface_energy, work, radius;  ///< E*, γ1, W_int, R
};

/// A loop's numbers, without errors.
struct Loop {
    double contact_radius, energy_loss, ideal_loss, work_approach, work_retraction, radius;
};

/// W_ret with which edge and jumps together lose so much: more than the jumps alone with W_app, for W_int r >= W_app
/// and a_max is larger than after the jump into contact.
double work_of_retraction(const contact::AdhesiveContact& approach, double contact_area, double loss) {
    const double jump_in = contact::jkr::ideal_loop_loss(approach).jump_in;
    const auto excess = [&](double work) {
        auto retraction = approach;
        retraction.work_of_adhesion = work;
        return (work - approach.work_of_adhesion) * contact_area + jump_in +
               contact::jkr::ideal_loop_loss(retraction).jump_out - loss;
    };
    const double lower = approach.work_of_adhesion, upper = lower + loss / contact_area;
    return numerics::bracketed_root(excess, lower, upper, 50);
}

Loop loop_of(const SpectralParameters& parameters, const Inputs& inputs, double preload) {
    const ConformalState state{parameters.area_ratio(), inputs.contact_modulus * parameters.elastic_energy_per_modulus};
    Loop loop{};
    loop.work_approach = modified_balance(inputs.work, inputs.surface_energy, state).floored;
    const contact::AdhesiveContact approach{inputs.radius, inputs.contact_modulus, loop.work_approach};
    loop.contact_radius = contact::jkr::contact_radius_at_force(preload, approach);
    const double area = pi * loop.contact_radius * loop.contact_radius;
    loop.energy_loss = inputs.work * state.area_ratio * area;
    loop.ideal_loss = contact::jkr::ideal_loop_loss(approach).total;
    loop.work_retraction = work_of_retraction(approach, area, loop.energy_loss);
    loop.radius = inputs.radius;
    return loop;
}

}  // namespace

std::optional<PredictedLoop> predict_loop(const RoughSide& rough, const SoftSide& soft, const TracedValue& work,
                                          const Press& press) {
    const double radius = press.radius.value;
    if (!(radius > 0.0) || !(press.preload >= 0.0) || !std::isfinite(radius + press.preload))
        throw InvalidArgument(
            fmt::format("a sphere of radius {} m under {} N; expected a radius above 0 and a force of 0 or more",
                        radius, press.preload));
    if (!predict(rough, soft, work).modified.work.conforms) return std::nullopt;
    const auto propagated = [&](auto number) {
        return traced_function(
            rough, {soft.contact_modulus, soft.surface_energy, work, press.radius},
            [&](const SpectralParameters& p, const std::vector<double>& inputs) {
                return number(loop_of(p, {inputs[0], inputs[1], inputs[2], inputs[3]}, press.preload));
            });
    };
    const auto pull_off = [](const Loop& loop, double energy) { return 1.5 * pi * loop.radius * energy; };
    const auto estimate = [&](auto number) { return propagated(number).estimate(); };
    return PredictedLoop{
        .contact_radius = estimate([](const Loop& loop) { return loop.contact_radius; }),
        .energy_loss = propagated([](const Loop& loop) { return loop.energy_loss; }),
        .ideal_loss = estimate([](const Loop& loop) { return loop.ideal_loss; }),
        .work_retraction = estimate([](const Loop& loop) { return loop.work_retraction; }),
        .pull_off_force = estimate([&](const Loop& loop) { return pull_off(loop, loop.work_retraction); }),
        .pull_off_force_reversible = estimate([&](const Loop& loop) { return pull_off(loop, loop.work_approach); }),
    };
}

}  // namespace setae::adhesion
