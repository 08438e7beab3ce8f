// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/hysteresis/retraction_pair.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>

#include <fmt/format.h>

#include "pair_functions.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::hysteresis {
namespace {

using adhesion::PairPoint;
using contact::jkr::Contact;

/// One loop, whose results are computed with all their inputs.
///
/// A loop in closed form is computed from the pair's own inputs. A loop with time dependence is expensive: it is
/// computed from its few parameters, which have their own inputs, and stored for its other results.
class TracedLoop {
public:
    TracedLoop(const PairFunctions& functions, const RetractionModel& model, const RetractionPair& pair)
        : functions_(functions), model_(model), pair_(pair) {
        const auto body = functions.body(model);
        if (!body.edge && body.relaxation.empty()) return;
        using In = std::vector<double>;
        const auto of_sphere = [&](auto number) {
            return functions_.traced(
                [&](const Roughness& rough, const In& in) { return number(functions_.sphere(model_, rough, in), in); });
        };
        makers_ = {*pair.radius, pair.soft.contact_modulus};
        makers_.push_back(of_sphere([](const HystereticSphere& sphere, const In&) { return sphere.work_approach; }));
        makers_.push_back(of_sphere([](const HystereticSphere& sphere, const In&) { return sphere.work_retraction; }));
        makers_.push_back(of_sphere([&](const HystereticSphere& sphere, const In& in) {
            return functions_.pressing(sphere.approach(), in).maximum_force;
        }));
        const auto& inputs = functions.inputs();
        using F = PairFunctions;
        for (const auto input : {F::machine_stiffness, F::reference_speed, F::exponent, F::rest_factor, F::tip_factor})
            makers_.push_back(inputs[input]);
        makers_.insert(makers_.end(), inputs.begin() + F::input_count, inputs.end());
    }

    /// number(loop, sphere, work of a smooth edge at zero speed divided by W_app)
    template <class Number>
    [[nodiscard]] TracedValue traced(const Number& number) {
        if (makers_.empty())
            return functions_.traced([&](const Roughness& rough, const std::vector<double>& in) {
                const auto sphere = functions_.sphere(model_, rough, in);
                return number(sphere_loop(sphere, functions_.pressing(sphere.approach(), in)), sphere,
                              PairFunctions::resting_factor(model_, in));
            });
        return setae::propagated(
            [&](const std::vector<double>& made) {
                const HystereticSphere sphere{made[0], made[1], made[2], std::max(made[2], made[3])};
                return number(made_of(sphere, made), sphere, resting_factor(made));
            },
            makers_);
    }

private:
    enum Maker : std::size_t { force = 4, machine, speed, power, at_rest, by_reference, first_term };

    [[nodiscard]] double resting_factor(const std::vector<double>& made) const {
        if (model_.tip == Tip::none) return 1.0;
        return made[model_.tip == Tip::speed ? at_rest : by_reference];
    }

    const SphereLoop& made_of(const HystereticSphere& sphere, const std::vector<double>& made) {
        const auto [place, is_new] = loops_.try_emplace(made);
        if (!is_new) return place->second;
        Pressing pressing{.maximum_force = std::max(0.0, made[force])};
        if (pair_.machine_stiffness) pressing.machine_stiffness = made[machine];
        else if (pair_.pressing) pressing.machine_stiffness = pair_.pressing->machine_stiffness;
        const auto body = viscous_body(model_, {made[speed], made[power]}, std::span(made).subspan(first_term));
        return place->second = sphere_loop(sphere, pressing, *pair_.drive, body);
    }

    const PairFunctions& functions_;
    const RetractionModel& model_;
    const RetractionPair& pair_;
    std::vector<TracedValue> makers_;
    std::map<std::vector<double>, SphereLoop> loops_;
};

}  // namespace

const std::array<EnergyShares::Named, EnergyShares::count>& EnergyShares::all() {
    static constexpr std::array<Named, count> shares{{{"jump in", &EnergyShares::jump_in},
                                                      {"jump out", &EnergyShares::jump_out},
                                                      {"crack tip", &EnergyShares::crack_tip},
                                                      {"roughness", &EnergyShares::roughness},
                                                      {"bulk", &EnergyShares::bulk}}};
    return shares;
}

double RetractionPair::energy_share() const {
    const auto& p = rough.parameters;
    return PairState{.area_ratio = p.area_ratio(),
                     .stored_energy = soft.contact_modulus.value * p.elastic_energy_per_modulus,
                     .work_of_adhesion = work_of_adhesion.value,
                     .surface_energy = soft.surface_energy.value}
        .energy_share();
}

Pressing RetractionPair::pressed(const Contact& contact, double area, double stiffness) const {
    auto result = pressing.value_or(Pressing{});
    if (machine_stiffness) result.machine_stiffness = stiffness;
    if (contact_area) result.maximum_force = std::max(0.0, contact::jkr::force(std::sqrt(area / pi), contact));
    return result;
}

std::string RetractionPair::lacks(const RetractionModel& model) const {
    if (model.tip == Tip::reference && !tip_factor) return "no smooth reference on " + soft.name;
    if (model.tip == Tip::speed && !edge_speed) return "no speed dependence of the contact edge on " + soft.name;
    if (model.tip == Tip::speed && !speed_factor)
        return fmt::format("no sphere radius, machine speed or contact area of {} on {}", soft.name, rough.name);
    if (model.law == Law::pinning_by_bands && bands.empty()) return "no spectrum of " + rough.name;
    return "";
}

PairPinning pinning_of(const RetractionPair& pair) {
    const PairFunctions functions(pair);
    return functions.pinning(Roughness(pair.rough.parameters), functions.values());
}

PairPoint retraction_point(const RetractionModel& model, const RetractionPair& pair, const MeasuredWork& measured) {
    const PairFunctions functions(pair);
    PairPoint point;
    point.surface = pair.rough.name;
    point.elastomer = pair.soft.name;
    point.quantity = "W_ret";
    point.measured = measured.value;
    point.in_unitputs = measured.inputs;
    point.floored = false;
    const auto slope = functions.traced(
        [&](const Roughness& rough, const std::vector<double>& in) { return functions.line(model, rough, in).slope; });
    const auto offset = functions.traced([&](const Roughness& rough, const std::vector<double>& in) {
        return -functions.line(model, rough, in).constant;
    });
    point.slope = model.fitted() ? slope.value : 1.0;
    if (model.fitted()) point.slope_inputs = slope.components;
    point.offset = offset.value;
    point.offset_inputs = offset.components;
    return point;
}

TracedValue predicted_approach(const FittedModel& fitted, const RetractionPair& pair) {
    PairFunctions functions(pair);
    functions.set(fitted);
    return functions.traced([&](const Roughness& rough, const std::vector<double>& in) {
        return functions.predicted_approach(fitted.model, rough, in);
    });
}

TracedValue predicted_retraction(const FittedModel& fitted, const RetractionPair& pair) {
    PairFunctions functions(pair);
    functions.set(fitted);
    return functions.traced([&](const Roughness& rough, const std::vector<double>& in) {
        return functions.work_retraction(fitted.model, rough, in);
    });
}

std::optional<PredictedRetraction> predicted_retraction_loop(const FittedModel& fitted, const RetractionPair& pair) {
    if (!pair.radius || !(pair.pressing || pair.contact_area))
        throw InvalidArgument(fmt::format("the loop of {} on {}: expected a sphere radius and a preload",
                                          pair.soft.name, pair.rough.name));
    PairFunctions functions(pair);
    functions.set(fitted);
    const auto& model = fitted.model;
    const auto approach_at = [&](const Roughness& rough, const std::vector<double>& in) {
        return functions.state(model, rough, in).work_approach;
    };
    const auto work_approach = functions.traced(approach_at);
    if (!(work_approach.value > 0.0)) return std::nullopt;
    PredictedRetraction result;
    result.sphere = functions.sphere(model);
    result.pressing = functions.pressing(result.sphere.approach());
    if (pair.drive) result.edge = functions.body(model).moving_edge(*pair.drive);
    TracedLoop loops(functions, model, pair);
    const auto of_loop = [&](double SphereLoop::*field) {
        return loops.traced([=](const SphereLoop& loop, const HystereticSphere&, double) { return loop.*field; });
    };
    const auto tip_loss = [](const SphereLoop& loop, const HystereticSphere& sphere, double factor) {
        const double share = std::max(0.0, 1.0 - 1.0 / factor);
        return loop.speed_loss + std::min(loop.edge_loss, share * sphere.work_retraction * loop.largest_contact_area());
    };
    result.work_approach = work_approach;
    result.work_retraction = predicted_retraction(fitted, pair);
    result.pull_off_force =
        loops.traced([](const SphereLoop& loop, const HystereticSphere&, double) { return -loop.smallest_force; });
    result.contact_radius = loops.traced(
        [](const SphereLoop& loop, const HystereticSphere&, double) { return loop.turning_point.contact_radius; });
    result.energy_loss =
        loops.traced([](const SphereLoop& loop, const HystereticSphere&, double) { return loop.energy_loss(); });
    auto& shares = result.shares;
    shares.jump_in = of_loop(&SphereLoop::jump_in_loss);
    shares.jump_out = of_loop(&SphereLoop::jump_out_loss);
    shares.bulk = of_loop(&SphereLoop::bulk_loss);
    shares.crack_tip = loops.traced(tip_loss);
    shares.roughness = loops.traced([&](const SphereLoop& loop, const HystereticSphere& sphere, double factor) {
        return loop.edge_loss + loop.speed_loss - tip_loss(loop, sphere, factor);
    });
    return result;
}

}  // namespace setae::hysteresis
