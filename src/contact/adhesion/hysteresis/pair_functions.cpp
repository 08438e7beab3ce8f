// SPDX-License-Identifier: GPL-3.0-or-later
#include "pair_functions.hpp"

#include <algorithm>
#include <cmath>

#include "setae/core/constants.hpp"
#include "setae/numerics/bracketing.hpp"

namespace setae::hysteresis {
namespace {

/// Smallest share of the area, so that models have a contact where simulated patches have almost none.
constexpr double min_contact = 1e-6;

/// 0 of an edge so short that nothing pins it: the error of k over such a k is no number.
double relative_error(const PinningCoefficient& k) {
    constexpr double least = 1e-12;
    return k.value > least ? k.standard_error / k.value : 0.0;
}

}  // namespace

bool is_of_simulated_fronts(Law law) { return law == Law::pinning || law == Law::pinning_by_bands; }

bool counts_jumps(Law law) { return law == Law::conformal_loss || law == Law::fitted_conformal_loss; }

ViscousBody viscous_body(const RetractionModel& model, const EdgeSpeed& edge, std::span<const double> terms) {
    ViscousBody body;
    if (model.tip == Tip::speed) body.edge = edge;
    for (std::size_t i = 0; i < terms.size(); i += 2)
        body.relaxation.push_back({std::max(0.0, terms[i]), terms[i + 1]});
    return body;
}

PairFunctions::PairFunctions(const RetractionPair& pair) : pair_(pair) {
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
    inputs_[patches] = {Estimate{.value = 0.0, .standard_error = 1.0}, adhesion::simulated_patches_input};
    const auto [share, measured, on_approach, on_retraction] = pinning(Roughness(pair.rough.parameters), values());
    const double error = std::max(relative_error(on_approach.coefficient), relative_error(on_retraction.coefficient));
    inputs_[pinning_factor] = {Estimate{.value = 1.0, .standard_error = error}, simulated_pinning_input};
}

void PairFunctions::set(const FittedModel& fitted) {
    inputs_[parameter] = fitted.parameter;
    if (fitted.work_of_adhesion) inputs_[work_of_adhesion] = *fitted.work_of_adhesion;
    inputs_[scatter] = fitted.shared_scatter.value_or(
        TracedValue(fitted.scatter,
                    adhesion::own_noise_name("pairs about " + fitted.model.name(), pair_.rough.name, pair_.soft.name)));
}

PairFunctions::Inputs PairFunctions::values() const {
    Inputs values;
    for (const auto& input : inputs_) values.push_back(input.value);
    return values;
}

PairState PairFunctions::contact_state(const Roughness& rough, const Inputs& in) const {
    PairState state{.area_ratio = rough.area_ratio,
                    .stored_energy = in[contact_modulus] * rough.elastic_energy_per_modulus,
                    .work_of_adhesion = in[work_of_adhesion],
                    .surface_energy = in[surface_energy],
                    .work_approach = 0.0,
                    .tip_factor = 1.0,
                    .pinning_factor = in[pinning_factor],
                    .mean_wavelength = rough.mean_wavelength,
                    .jumps_per_area = 0.0};
    const double gain = state.full_contact_gain();
    const auto contact = adhesion::unloaded_contact(state.stored_energy / gain);
    const double gained = contact.gain + in[patches] * contact.gain_error;
    state.contact_fraction = std::clamp(contact.area_fraction + in[patches] * contact.area_error, min_contact, 1.0);
    // a contact gains its share of W minus its stored energy
    state.stored_energy = std::max(0.0, state.contact_fraction - gained) * gain;
    state.work_approach = gained * gain;
    return state;
}

PairState PairFunctions::contact_state(const RetractionModel& model, const Roughness& rough, const Inputs& in) const {
    auto state = contact_state(rough, in);
    const bool known = pair_.radius && rough.mean_wavelength > 0.0;
    if (!known || !is_of_simulated_fronts(model.law)) return state;
    const auto sphere = sphere_of(state, in);
    state.edge = edge_lengths(largest_radius(sphere, in), sphere);
    return state;
}

/// That W is the energy gained in contact; the works of both branches are about it.
contact::AdhesiveContact PairFunctions::sphere_of(const PairState& state, const Inputs& in) const {
    return {in[radius], in[contact_modulus], state.contact_fraction * state.full_contact_gain()};
}

double PairFunctions::largest_radius(const contact::AdhesiveContact& sphere, const Inputs& in) const {
    if (pair_.contact_area) return std::sqrt(in[contact_area] / pi);
    return contact::jkr::contact_radius_at_force(pressing(sphere, in).maximum_force, sphere);
}

PairPinning PairFunctions::pinning(const Roughness& rough, const Inputs& in) const {
    const auto state = contact_state({Law::pinning, Tip::none}, rough, in);
    PairPinning found{.energy_share = state.energy_share(), .measured_radius = static_cast<bool>(pair_.contact_area)};
    const auto branch = [&](double free_length) {
        const double length = edge_larkin_lengths(free_length, state.mean_wavelength, found.energy_share);
        const auto constants = pinning_constants(found.energy_share, length);
        return BranchPinning{
            .larkin_lengths = length, .coefficient = constants.retraction, .measured = constants.measured};
    };
    found.approach = branch(state.edge.approach);
    found.retraction = branch(state.edge.retraction);
    if (!pair_.radius) return found;
    const auto sphere = sphere_of(state, in);
    found.approach.contact_radius = largest_radius(sphere, in);
    found.retraction.contact_radius = contact::jkr::pull_off_at_fixed_load(sphere).contact_radius;
    return found;
}

double PairFunctions::predicted_approach(const RetractionModel& model, const Roughness& rough, const Inputs& in) const {
    const auto at = contact_state(model, rough, in);
    return std::max(0.0, at.work_approach - pinned_on_approach(model, at, pair_.bands, in[parameter]));
}

PairState PairFunctions::state(const RetractionModel& model, const Roughness& rough, const Inputs& in) const {
    auto at = contact_state(model, rough, in);
    at.work_approach = pair_.approach ? std::max(0.0, in[approach]) : predicted_approach(model, rough, in);
    if (model.tip != Tip::none) at.tip_factor = in[model.tip == Tip::speed ? speed_factor_input : tip_factor];
    if (counts_jumps(model.law)) at.jumps_per_area = jumps_per_area(at, in);
    return at;
}

RetractionLine PairFunctions::line(const RetractionModel& model, const Roughness& rough, const Inputs& in) const {
    auto at = state(model, rough, in);
    if (model.tip == Tip::speed) at.tip_factor = pair_.speed_factor->at_reading(at.tip_factor);
    return retraction_line(model, at, pair_.bands);
}

double PairFunctions::work_retraction(const RetractionModel& model, const Roughness& rough, const Inputs& in) const {
    const auto at = state(model, rough, in);
    const auto line = retraction_line(model, at, pair_.bands);
    double work = line.slope * in[parameter] + line.constant;
    if (model.tip == Tip::speed) work = at_speed(work / at.tip_factor, at.tip_factor);
    return std::max(at.work_approach, work + in[scatter]);
}

/// W_ret from roughness times the factor at the resulting speed of the edge.
double PairFunctions::at_speed(double of_roughness, double factor_as_read) const {
    return of_roughness * pair_.speed_factor->at(factor_as_read, of_roughness);
}

double PairFunctions::work_at_rest(const RetractionModel& model, const Roughness& rough, const Inputs& in) const {
    const double work = work_retraction(model, rough, in);
    if (model.tip != Tip::speed) return work;
    const auto at = state(model, rough, in);
    const auto line = retraction_line(model, at, pair_.bands);
    const double of_roughness = (line.slope * in[parameter] + line.constant) / at.tip_factor;
    return in[rest_factor] * work / pair_.speed_factor->at(at.tip_factor, of_roughness);
}

HystereticSphere PairFunctions::sphere(const RetractionModel& model, const Roughness& rough, const Inputs& in) const {
    const double least =
        1e-6 * in[work_of_adhesion];  // share of W_app, for derivatives of a pair with almost no contact
    HystereticSphere sphere{in[radius], in[contact_modulus], std::max(least, state(model, rough, in).work_approach),
                            0.0};
    sphere.work_retraction = std::max(sphere.work_approach, work_at_rest(model, rough, in));
    return sphere;
}

ViscousBody PairFunctions::body(const RetractionModel& model) const {
    const auto in = values();
    const auto terms = pair_.drive ? std::span(in).subspan(input_count) : std::span<const double>();
    return viscous_body(model, {in[reference_speed], in[exponent]}, terms);
}

/// For the true-area loss (Eq. 10): the edge loses W_int A_true/A of the contact minus these losses, which depend on
/// W_ret themselves.
double PairFunctions::jumps_per_area(const PairState& state, const Inputs& in) const {
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

/// Loss of both jumps [J]: closed forms under fixed grips.
double PairFunctions::jump_loss(const HystereticSphere& sphere, const Pressing& pressing) {
    if (std::isinf(pressing.machine_stiffness))
        return contact::jkr::ideal_loop_loss(sphere.approach()).jump_in +
               contact::jkr::ideal_loop_loss(sphere.retraction()).jump_out;
    const auto loop = sphere_loop(sphere, pressing);
    return loop.jump_in_loss + loop.jump_out_loss;
}

}  // namespace setae::hysteresis
