// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "setae/adhesion/partial_contact.hpp"
#include "setae/contact/jkr.hpp"
#include "setae/crack_front/pinning.hpp"
#include "setae/hysteresis/retraction_pair.hpp"

namespace setae::hysteresis {

/// Roughness in a contact: true area and energy in full contact.
struct Roughness {
    double area_ratio = 1.0;                  ///< r
    double elastic_energy_per_modulus = 0.0;  ///< U_el/(A E*) [m]
    double mean_wavelength = 0.0;             ///< λ̄ [m], weighed by U_el; 0 of a mirror

    Roughness(double ratio, double energy, double wavelength)
        : area_ratio(ratio), elastic_energy_per_modulus(energy), mean_wavelength(wavelength) {}
    explicit Roughness(const roughness::SpectralParameters& p)
        : Roughness(p.area_ratio(), p.elastic_energy_per_modulus,
                    p.rms_height > 0.0 && p.elastic_energy_per_modulus > 0.0
                        ? crack_front::mean_wavelength(p.rms_height, p.elastic_energy_per_modulus)
                        : 0.0) {}
};

/// Whether W_app and W_ret of a model include k of simulated fronts.
[[nodiscard]] bool is_of_simulated_fronts(Law law);
/// Whether W_ret of a model includes the loss of the sphere's jumps.
[[nodiscard]] bool counts_jumps(Law law);

/// Time dependence of loops for a model, with share and time of the terms of relaxation in sequence.
[[nodiscard]] ViscousBody viscous_body(const RetractionModel& model, const EdgeSpeed& edge,
                                       std::span<const double> terms);

/// Quantities of a pair as functions of its inputs.
class PairFunctions {
public:
    /// Inputs of a pair in addition to its spectrum, in their order.
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
        input_count  // followed by share and time of each term of the relaxation
    };
    using Inputs = std::vector<double>;  ///< their values

    explicit PairFunctions(const RetractionPair& pair);

    void set(const FittedModel& fitted);

    /// A function of roughness and inputs with all its inputs.
    template <class Function>
    [[nodiscard]] TracedValue traced(const Function& function) const {
        return adhesion::traced_function(
            pair_.rough, inputs_,
            [&](const roughness::SpectralParameters& p, const Inputs& in) { return function(Roughness(p), in); });
    }

    /// The contact that the model comes to without load; of a tip φ where W_ret was read.
    [[nodiscard]] PairState state(const RetractionModel& model, const Roughness& rough, const Inputs& in) const;
    /// W_app [J/m²] of that contact, minus the effect of pinning; >= 0.
    [[nodiscard]] double predicted_approach(const RetractionModel& model, const Roughness& rough,
                                            const Inputs& in) const;
    [[nodiscard]] RetractionLine line(const RetractionModel& model, const Roughness& rough, const Inputs& in) const;
    [[nodiscard]] double work_retraction(const RetractionModel& model, const Roughness& rough, const Inputs& in) const;
    /// W_ret at zero speed: work at the edge of the loop without rate dependence.
    [[nodiscard]] double work_at_rest(const RetractionModel& model, const Roughness& rough, const Inputs& in) const;
    [[nodiscard]] HystereticSphere sphere(const RetractionModel& model, const Roughness& rough, const Inputs& in) const;

    /// Sphere at the values of the inputs.
    [[nodiscard]] HystereticSphere sphere(const RetractionModel& model) const {
        return sphere(model, Roughness(pair_.rough.parameters), values());
    }
    [[nodiscard]] Pressing pressing(const contact::jkr::Contact& contact) const { return pressing(contact, values()); }
    [[nodiscard]] Pressing pressing(const contact::jkr::Contact& contact, const Inputs& in) const {
        return pair_.pressed(contact, in[contact_area], in[machine_stiffness]);
    }

    /// Pinning of the edge of that contact.
    [[nodiscard]] PairPinning pinning(const Roughness& rough, const Inputs& in) const;

    /// Time dependence of the loop by a model.
    [[nodiscard]] ViscousBody body(const RetractionModel& model) const;

    /// Work of a smooth edge at zero speed divided by W_app, by a model.
    [[nodiscard]] static double resting_factor(const RetractionModel& model, const Inputs& in) {
        if (model.tip == Tip::none) return 1.0;
        return in[model.tip == Tip::speed ? rest_factor : tip_factor];
    }

    [[nodiscard]] const std::vector<TracedValue>& inputs() const { return inputs_; }
    [[nodiscard]] Inputs values() const;

private:
    [[nodiscard]] PairState contact_state(const Roughness& rough, const Inputs& in) const;
    [[nodiscard]] PairState contact_state(const RetractionModel& model, const Roughness& rough, const Inputs& in) const;
    [[nodiscard]] contact::AdhesiveContact sphere_of(const PairState& state, const Inputs& in) const;
    [[nodiscard]] double largest_radius(const contact::AdhesiveContact& sphere, const Inputs& in) const;
    [[nodiscard]] double at_speed(double of_roughness, double factor_as_read) const;
    [[nodiscard]] double jumps_per_area(const PairState& state, const Inputs& in) const;
    [[nodiscard]] static double jump_loss(const HystereticSphere& sphere, const Pressing& pressing);

    const RetractionPair& pair_;
    std::vector<TracedValue> inputs_;
};

}  // namespace setae::hysteresis
