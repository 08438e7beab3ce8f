// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/hysteresis/retraction_pair.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>

#include <fmt/format.h>

#include "setae/adhesion/partial_contact.hpp"
#include "setae/contact/jkr.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/hysteresis/pinning_law.hpp"
#include "setae/numerics/bracketing.hpp"

namespace setae::hysteresis {
namespace {

using adhesion::PairPoint;
using contact::jkr::Contact;
using roughness::SpectralParameters;

/// Inputs of a pair beside its spectrum, in their order.
enum Input : std::size_t {
    contact_modulus,
    surface_energy,
    work_of_adhesion,
    approach,
    tip_factor,
    pinning_factor,
    patches,
    parameter,
    scatter,
    radius,
    contact_area,
    machine_stiffness,
    speed_factor_input,
    reference_speed,
    exponent,
    rest_factor,
    input_count  // behind them share and time of each term of the relaxation
};

/// Of the area, so that laws have a contact to speak of where simulated patches have next to none.
constexpr double least_contact = 1e-6;

/// What time does to loops of a model, terms of the relaxation as share and time after each other.
ViscousBody viscous_body(const RetractionModel& model, const EdgeSpeed& edge, std::span<const double> terms) {
    ViscousBody body;
    if (model.tip == Tip::speed) body.edge = edge;
    for (std::size_t i = 0; i < terms.size(); i += 2)
        body.relaxation.push_back({std::max(0.0, terms[i]), terms[i + 1]});
    return body;
}

/// Numbers of a pair as functions of its inputs.
class PairFunctions {
public:
    explicit PairFunctions(const RetractionPair& pair) : pair_(pair) {
        const auto or_zero = [](const std::optional<TracedValue>& value) { return value.value_or(TracedValue()); };
        inputs_.resize(input_count);
        inputs_[contact_modulus] = pair.soft.contact_modulus;
        inputs_[surface_energy] = pair.soft.surface_energy;
        inputs_[work_of_adhesion] = pair.work_of_adhesion;
        inputs_[approach] = or_zero(pair.approach);
        inputs_[tip_factor] = pair.tip_factor.value_or(TracedValue(1.0));
        inputs_[radius] = or_zero(pair.radius);
        inputs_[contact_area] = or_zero(pair.contact_area);
        inputs_[machine_stiffness] = or_zero(pair.machine_stiffness);
        inputs_[speed_factor_input] = pair.speed_factor ? pair.speed_factor->factor : TracedValue(1.0);
        if (pair.edge_speed) {
            inputs_[reference_speed] = pair.edge_speed->reference_speed;
            inputs_[exponent] = pair.edge_speed->exponent;
            inputs_[rest_factor] = pair.edge_speed->rest_factor;
        }
        for (const auto& term : pair.relaxation) {
            inputs_.push_back(term.share);
            inputs_.push_back(term.time);
        }
        const Estimate factor{.value = 1.0, .standard_error = pinning_uncertainty(pair.energy_share())};
        inputs_[pinning_factor] = {factor, simulated_pinning_input};
        inputs_[patches] = {Estimate{.value = 0.0, .standard_error = 1.0}, adhesion::simulated_patches_input};
    }

    void set(const FittedModel& fitted) {
        inputs_[parameter] = fitted.parameter;
        inputs_[scatter] = fitted.shared_scatter.value_or(TracedValue(
            fitted.scatter,
            adhesion::own_noise_name("pairs about " + fitted.model.name(), pair_.rough.name, pair_.soft.name)));
    }

    [[nodiscard]] TracedValue traced(const adhesion::RoughFunction& function) const {
        return adhesion::traced_function(pair_.rough, inputs_, function);
    }

    [[nodiscard]] PairState state(const SpectralParameters& p, const std::vector<double>& in) const {
        PairState state{.area_ratio = p.area_ratio(),
                        .stored_energy = in[contact_modulus] * p.elastic_energy_per_modulus,
                        .work_of_adhesion = in[work_of_adhesion],
                        .surface_energy = in[surface_energy],
                        .work_approach = 0.0,
                        .tip_factor = 1.0,
                        .pinning_factor = in[pinning_factor],
                        .jumps_per_area = 0.0};
        const double gain = state.conforming_gain();
        const auto contact = adhesion::unloaded_contact(state.stored_energy / gain);
        const double gained = contact.gain + in[patches] * contact.gain_error;
        state.contact_fraction =
            std::clamp(contact.area_fraction + in[patches] * contact.area_error, least_contact, 1.0);
        // a contact gains its share of W less what it stores
        state.stored_energy = std::max(0.0, state.contact_fraction - gained) * gain;
        state.work_approach = std::max(0.0, pair_.approach ? in[approach] : gained * gain);
        return state;
    }

    /// The same as a law needs it; of a tip that minds its speed φ where W_ret was read.
    [[nodiscard]] PairState state(const RetractionModel& model, const SpectralParameters& p,
                                  const std::vector<double>& in) const {
        auto at = state(p, in);
        if (model.tip != Tip::none) at.tip_factor = in[model.tip == Tip::speed ? speed_factor_input : tip_factor];
        const bool counts_jumps = model.law == Law::conformal_loss || model.law == Law::fitted_conformal_loss;
        if (counts_jumps) at.jumps_per_area = jumps_per_area(at, in);
        return at;
    }

    [[nodiscard]] RetractionLine line(const RetractionModel& model, const SpectralParameters& p,
                                      const std::vector<double>& in) const {
        auto at = state(model, p, in);
        if (model.tip == Tip::speed) at.tip_factor = pair_.speed_factor->at_reading(at.tip_factor);
        return retraction_line(model, at, pair_.band_shares);
    }

    [[nodiscard]] double work_retraction(const RetractionModel& model, const SpectralParameters& p,
                                         const std::vector<double>& in) const {
        const auto at = state(model, p, in);
        const auto line = retraction_line(model, at, pair_.band_shares);
        double work = line.slope * in[parameter] + line.constant;
        if (model.tip == Tip::speed) work = at_speed(work / at.tip_factor, at.tip_factor);
        return std::max(at.work_approach, work + in[scatter]);
    }

    /// What roughness asks for times the factor of the speed at which the edge then recedes.
    [[nodiscard]] double at_speed(double of_roughness, double factor_as_read) const {
        return of_roughness * pair_.speed_factor->at(factor_as_read, of_roughness);
    }

    /// W_ret at rest: what the edge of the loop needs before its speed adds to it.
    [[nodiscard]] double work_at_rest(const RetractionModel& model, const SpectralParameters& p,
                                      const std::vector<double>& in) const {
        const double work = work_retraction(model, p, in);
        if (model.tip != Tip::speed) return work;
        const auto at = state(model, p, in);
        const auto line = retraction_line(model, at, pair_.band_shares);
        const double of_roughness = (line.slope * in[parameter] + line.constant) / at.tip_factor;
        return in[rest_factor] * work / pair_.speed_factor->at(at.tip_factor, of_roughness);
    }

    [[nodiscard]] HystereticSphere sphere(const RetractionModel& model, const SpectralParameters& p,
                                          const std::vector<double>& in) const {
        const double least = 1e-6 * in[work_of_adhesion];  // of W_app, for derivatives of a pair that hardly conforms
        HystereticSphere sphere{in[radius], in[contact_modulus], std::max(least, state(p, in).work_approach), 0.0};
        sphere.work_retraction = std::max(sphere.work_approach, work_at_rest(model, p, in));
        return sphere;
    }

    /// Of the inputs' values.
    [[nodiscard]] HystereticSphere sphere(const RetractionModel& model) const {
        return sphere(model, pair_.rough.parameters, values());
    }
    [[nodiscard]] Pressing pressing(const Contact& contact) const { return pressing(contact, values()); }

    /// What time does to the loop by a model.
    [[nodiscard]] ViscousBody body(const RetractionModel& model) const {
        const auto in = values();
        const auto terms = pair_.drive ? std::span(in).subspan(input_count) : std::span<const double>();
        return viscous_body(model, {in[reference_speed], in[exponent]}, terms);
    }

    /// What a smooth edge at rest needs over W_app by a model.
    [[nodiscard]] static double resting_factor(const RetractionModel& model, const std::vector<double>& in) {
        if (model.tip == Tip::none) return 1.0;
        return in[model.tip == Tip::speed ? rest_factor : tip_factor];
    }

    [[nodiscard]] const std::vector<TracedValue>& inputs() const { return inputs_; }

    [[nodiscard]] Pressing pressing(const Contact& contact, const std::vector<double>& in) const {
        return pair_.pressed(contact, in[contact_area], in[machine_stiffness]);
    }

private:
    [[nodiscard]] std::vector<double> values() const {
        std::vector<double> values;
        for (const auto& input : inputs_) values.push_back(input.value);
        return values;
    }

    /// Of (10): the edge loses W_int A_true/A of the contact less these, which depend on W_ret themselves.
    [[nodiscard]] double jumps_per_area(const PairState& state, const std::vector<double>& in) const {
        const bool known = pair_.radius && (pair_.contact_area || pair_.pressing);
        if (!known || !(state.work_approach > 0.0)) return 0.0;
        HystereticSphere sphere{in[radius], in[contact_modulus], state.work_approach, 0.0};
        const auto pressed = pressing(sphere.approach(), in);
        const double lost = state.work_of_adhesion * state.true_contact();
        const double largest = contact::jkr::contact_radius_at_force(pressed.maximum_force, sphere.approach()),
                     area = pi * largest * largest;
        const auto jumps_at = [&](double edge_loss) {
            sphere.work_retraction = state.work_approach + edge_loss;
            return jump_loss(sphere, pressed) / area;
        };
        if (jumps_at(0.0) >= lost) return lost;
        constexpr int bits = 30;
        return lost - numerics::bracketed_root([&](double edge_loss) { return edge_loss + jumps_at(edge_loss) - lost; },
                                               0.0, lost, bits);
    }

    /// Of both jumps [J]: closed forms under fixed grips.
    [[nodiscard]] static double jump_loss(const HystereticSphere& sphere, const Pressing& pressing) {
        if (std::isinf(pressing.machine_stiffness))
            return contact::jkr::ideal_loop_loss(sphere.approach()).jump_in +
                   contact::jkr::ideal_loop_loss(sphere.retraction()).jump_out;
        const auto loop = sphere_loop(sphere, pressing);
        return loop.jump_in_loss + loop.jump_out_loss;
    }

    const RetractionPair& pair_;
    std::vector<TracedValue> inputs_;
};

/// One loop, of whose numbers each is wanted with everything it rests on.
///
/// A loop in closed form is followed from the pair's own inputs. One that time has a part in is dear: it is followed
/// from the few numbers that make it, which know what they rest on, and kept for its other numbers.
class TracedLoop {
public:
    TracedLoop(const PairFunctions& functions, const RetractionModel& model, const RetractionPair& pair)
        : functions_(functions), model_(model), pair_(pair) {
        const auto body = functions.body(model);
        if (!body.edge && body.relaxation.empty()) return;
        using P = SpectralParameters;
        using In = std::vector<double>;
        const auto of_sphere = [&](auto number) {
            return functions_.traced(
                [&](const P& p, const In& in) { return number(functions_.sphere(model_, p, in), in); });
        };
        makers_ = {*pair.radius, pair.soft.contact_modulus};
        makers_.push_back(of_sphere([](const HystereticSphere& sphere, const In&) { return sphere.work_approach; }));
        makers_.push_back(of_sphere([](const HystereticSphere& sphere, const In&) { return sphere.work_retraction; }));
        makers_.push_back(of_sphere([&](const HystereticSphere& sphere, const In& in) {
            return functions_.pressing(sphere.approach(), in).maximum_force;
        }));
        const auto& inputs = functions.inputs();
        for (const auto input : {machine_stiffness, reference_speed, exponent, rest_factor, tip_factor})
            makers_.push_back(inputs[input]);
        makers_.insert(makers_.end(), inputs.begin() + input_count, inputs.end());
    }

    /// number(loop, sphere, what a smooth edge at rest needs over W_app)
    template <class Number>
    [[nodiscard]] TracedValue traced(const Number& number) {
        if (makers_.empty())
            return functions_.traced([&](const SpectralParameters& p, const std::vector<double>& in) {
                const auto sphere = functions_.sphere(model_, p, in);
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
    if (model.tip == Tip::speed && !edge_speed) return "no law of the edge's speed on " + soft.name;
    if (model.tip == Tip::speed && !speed_factor)
        return fmt::format("no sphere, machine speed or contact area of {} on {}", soft.name, rough.name);
    if (model.law == Law::pinning_by_bands && band_shares.empty()) return "no spectrum of " + rough.name;
    return "";
}

PairPoint retraction_point(const RetractionModel& model, const RetractionPair& pair,
                           const MeasuredRetraction& measured) {
    const PairFunctions functions(pair);
    PairPoint point;
    point.surface = pair.rough.name;
    point.elastomer = pair.soft.name;
    point.quantity = "W_ret";
    point.measured = measured.value;
    point.measured_inputs = measured.inputs;
    point.floored = false;
    const auto slope = functions.traced(
        [&](const SpectralParameters& p, const std::vector<double>& in) { return functions.line(model, p, in).slope; });
    const auto offset = functions.traced([&](const SpectralParameters& p, const std::vector<double>& in) {
        return -functions.line(model, p, in).constant;
    });
    point.slope = model.fitted() ? slope.value : 1.0;
    if (model.fitted()) point.slope_inputs = slope.components;
    point.offset = offset.value;
    point.offset_inputs = offset.components;
    return point;
}

TracedValue predicted_retraction(const FittedModel& fitted, const RetractionPair& pair) {
    PairFunctions functions(pair);
    functions.set(fitted);
    return functions.traced([&](const SpectralParameters& p, const std::vector<double>& in) {
        return functions.work_retraction(fitted.model, p, in);
    });
}

std::optional<PredictedRetraction> predicted_retraction_loop(const FittedModel& fitted, const RetractionPair& pair) {
    if (!pair.radius || !(pair.pressing || pair.contact_area))
        throw InvalidArgument(fmt::format("the loop of {} on {}: expected the radius of its sphere and a preload",
                                          pair.soft.name, pair.rough.name));
    PairFunctions functions(pair);
    functions.set(fitted);
    const auto& model = fitted.model;
    const auto approach_at = [&](const SpectralParameters& p, const std::vector<double>& in) {
        return functions.state(p, in).work_approach;
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
