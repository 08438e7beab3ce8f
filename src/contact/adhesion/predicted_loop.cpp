// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/adhesion/predicted_loop.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "setae/adhesion/partial_contact.hpp"
#include "setae/adhesion/traced_function.hpp"
#include "setae/contact/jkr.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/numerics/bracketing.hpp"

namespace setae::adhesion {
namespace {

using roughness::SpectralParameters;

/// All inputs of a loop in addition to the surface, without errors.
struct Inputs {
    double contact_modulus, surface_energy, work, radius, patches;  ///< E*, γ1, W_int, R, simulated patches
};

/// A loop's numbers, without errors.
struct Loop {
    double radius = 0.0, contact_radius = 0.0, work_approach = 0.0;
    double ideal_loss = 0.0;                            ///< loss of the jumps with W_app
    double conformal_loss = 0.0, conformal_work = 0.0;  ///< true-area loss (Eq. 10) and its W_ret
};

/// W_ret for a given loss of edge and jumps: more than the jumps with W_app, since W_int r >= W_app and a_max is larger
/// than after the jump into contact.
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

/// W_app, with a positive lower limit for derivatives of a pair with almost no contact.
double work_approach(const ConformalState& state, const Inputs& inputs) {
    constexpr double min_share = 1e-6;
    const double gain = inputs.work * state.area_ratio - inputs.surface_energy * (state.area_ratio - 1.0);
    return std::max(min_share * inputs.work, partial_balance(gain, state.stored_energy, inputs.patches));
}

Loop loop_of(const ConformalState& state, const Inputs& inputs, double preload) {
    Loop loop{.radius = inputs.radius, .work_approach = work_approach(state, inputs)};
    const contact::AdhesiveContact approach{inputs.radius, inputs.contact_modulus, loop.work_approach};
    loop.contact_radius = contact::jkr::contact_radius_at_force(preload, approach);
    const double area = pi * loop.contact_radius * loop.contact_radius;
    loop.ideal_loss = contact::jkr::ideal_loop_loss(approach).total;
    loop.conformal_loss = inputs.work * state.area_ratio * area;
    loop.conformal_work = work_of_retraction(approach, area, loop.conformal_loss);
    return loop;
}

Loop loop_of(const SpectralParameters& parameters, const Inputs& inputs, double preload) {
    return loop_of(
        ConformalState{parameters.area_ratio(), inputs.contact_modulus * parameters.elastic_energy_per_modulus}, inputs,
        preload);
}

double pull_off(double radius, double work) { return 1.5 * pi * radius * work; }

}  // namespace

std::optional<PredictedLoop> predict_loop(const RoughSide& rough, const SoftSide& soft, const TracedValue& work,
                                          const Press& press) {
    const double radius = press.radius.value;
    if (!(radius > 0.0) || !(press.preload >= 0.0) || !std::isfinite(radius + press.preload))
        throw InvalidArgument(
            fmt::format("a sphere of radius {} m under {} N; expected a radius above 0 and a force of at least 0",
                        radius, press.preload));
    if (!(partial_prediction(rough, soft, work).value > 0.0)) return std::nullopt;
    const TracedValue patches({.value = 0.0, .standard_error = 1.0}, simulated_patches_input);
    const auto propagated = [&](auto number) {
        return traced_function(rough, {soft.contact_modulus, soft.surface_energy, work, press.radius, patches},
                               [&](const SpectralParameters& p, const std::vector<double>& in) {
                                   return number(loop_of(p, {in[0], in[1], in[2], in[3], in[4]}, press.preload));
                               });
    };
    const auto estimate = [&](auto number) { return propagated(number).estimate(); };
    const auto smooth =
        loop_of(ConformalState{}, {soft.contact_modulus.value, soft.surface_energy.value, work.value, radius, 0.0},
                press.preload);
    return PredictedLoop{
        .contact_radius = estimate([](const Loop& loop) { return loop.contact_radius; }),
        .reversible = {.energy_loss = propagated([](const Loop& loop) { return loop.ideal_loss; }),
                       .work_retraction = estimate([](const Loop& loop) { return loop.work_approach; }),
                       .pull_off_force =
                           estimate([](const Loop& loop) { return pull_off(loop.radius, loop.work_approach); }),
                       .smooth_pull_off_force = pull_off(radius, smooth.work_approach)},
        .conformal_loss = {
            .energy_loss = propagated([](const Loop& loop) { return loop.conformal_loss; }),
            .work_retraction = estimate([](const Loop& loop) { return loop.conformal_work; }),
            .pull_off_force = estimate([](const Loop& loop) { return pull_off(loop.radius, loop.conformal_work); }),
            .smooth_pull_off_force = pull_off(radius, smooth.conformal_work)}};
}

}  // namespace setae::adhesion
