// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "setae/adhesion/traced_function.hpp"
#include "setae/fields/describe.hpp"
#include "setae/hysteresis/retraction_model.hpp"
#include "setae/hysteresis/speed_factor.hpp"
#include "setae/hysteresis/viscous_body.hpp"

namespace setae::hysteresis {

/// A surface and an elastomer for retraction models, with all inputs.
///
/// The contact is that of simulated patches with the pair's U_el/(A W) without load, adhesion::unloaded_contact():
/// full, with the surface's r and U_el, up to 0.15; a share α of the area beyond, with the corresponding stored energy.
struct RetractionPair {
    adhesion::RoughSide rough;
    adhesion::SoftSide soft;
    TracedValue work_of_adhesion;           ///< W_int [J/m²]
    std::optional<TracedValue> approach{};  ///< measured W_app [J/m²]; without it, W_app of the predicted contact
    std::optional<TracedValue> reference_work{};  ///< W_app of a smooth reference on the elastomer [J/m²]
    std::optional<TracedValue> tip_factor{};      ///< φ of a smooth reference; models with its tip need it
    std::optional<TracedEdgeSpeed>
        edge_speed{};  ///< rate dependence of the elastomer; required by models with a rate-dependent tip …
    std::optional<SpeedFactor> speed_factor{};   ///< … together with speed_factor() of the pair
    std::vector<TracedRelaxation> relaxation{};  ///< relaxation of the elastomer's bulk, where it is known
    std::optional<Drive> drive{};         ///< speeds of the testing machine and hold time; required by both of these
    std::optional<TracedValue> radius{};  ///< R [m] of the sphere
    std::optional<TracedValue> contact_area{};  ///< measured π a_max² [m²]; without it, that of `pressing`
    std::optional<Pressing> pressing{};
    std::optional<TracedValue> machine_stiffness{};  ///< k_m [N/m]; without it that of `pressing`
    std::vector<PinningBand> bands;                  ///< bands of U_el

    /// U_el divided by the energy gained in full contact.
    [[nodiscard]] double energy_share() const;
    /// Loading for a known contact area and machine stiffness: the force at which a contact has this area; else
    /// `pressing`.
    [[nodiscard]] Pressing pressed(const contact::jkr::Contact& contact, double area, double stiffness) const;
    /// Empty if the model has all its inputs; otherwise the missing input in words.
    [[nodiscard]] std::string lacks(const RetractionModel& model) const;
};

/// Pinning of the edge of a pair's contact on one branch.
struct BranchPinning {
    std::optional<double> contact_radius{};  ///< a [m] of the edge; empty without a sphere
    double larkin_lengths = 0.0;             ///< N; infinite without a sphere
    PinningCoefficient coefficient;          ///< k
    bool measured = true;                    ///< PinningConstants::measured
};
struct PairPinning {
    double energy_share = 0.0;  ///< U_el/(A W) of the contact
    /// measured radius at the largest load; else that of JKR at the preload, or without load
    bool measured_radius = false;
    BranchPinning approach, retraction;  ///< at the largest load; at JKR's pull-off under a dead load
};

/// Pinning for JKR's contact with W, the energy gained in contact.
[[nodiscard]] PairPinning pinning_of(const RetractionPair& pair);

/// Name of the input that represents k of simulated fronts, as one relative error of all pairs.
inline constexpr const char* simulated_pinning_input = "k of simulated fronts";

/// A measured work of adhesion.
struct MeasuredWork {
    Estimate value;     ///< value [J/m²]; the standard error includes noise and scatter only
    Components inputs;  ///< inputs shared with other values
};

/// The pair in a fit of the model's θ. A model without θ has slope 1 and is evaluated at θ = 0.
[[nodiscard]] adhesion::PairPoint retraction_point(const RetractionModel& model, const RetractionPair& pair,
                                                   const MeasuredWork& measured);

/// Result of the fit of a model: θ, and the scatter of pairs about the model.
struct FittedModel {
    RetractionModel model;
    TracedValue parameter;  ///< θ; 0 without one
    Estimate scatter;       ///< scatter of a new pair on a new surface and elastomer: value 0, standard error [J/m²]
    std::optional<TracedValue>
        work_of_adhesion{};  ///< W_int by a model that also predicts W_app; without it that of the pair [J/m²]
    std::optional<TracedValue>
        shared_scatter{};  ///< in place of `scatter`: effects of the pair, its surface and elastomer [J/m²]
};

/// W_app [J/m²] of a pair predicted from roughness by a model: of the predicted contact, minus the effect of pinning.
[[nodiscard]] TracedValue predicted_approach(const FittedModel& fitted, const RetractionPair& pair);

/// W_ret [J/m²] of a pair by a model, at least W_app, with the scatter among its errors.
[[nodiscard]] TracedValue predicted_retraction(const FittedModel& fitted, const RetractionPair& pair);

/// Energy budget of a loop.
struct EnergyShares {
    TracedValue jump_in, jump_out;  ///< losses in the jumps of the sphere [J]
    TracedValue crack_tip;          ///< (1 − 1/φ) W_ret π a_max², or the loss by the speed of the edge [J]
    TracedValue roughness;          ///< remainder of (W_ret − W_app) π a_max² [J]
    TracedValue bulk;               ///< energy that relaxes in the elastomer's bulk [J]

    /// A share of each kind, in order, with its name.
    static constexpr int count = 5;
    struct Named {
        const char* name;
        TracedValue EnergyShares::*share;
    };
    [[nodiscard]] static const std::array<Named, count>& all();
};

/// A whole loop by a model.
struct PredictedRetraction {
    TracedValue work_approach, work_retraction;  ///< [J/m²]
    TracedValue pull_off_force;                  ///< magnitude of the smallest force [N]
    TracedValue contact_radius;                  ///< a_max [m]
    TracedValue energy_loss;                     ///< ∮F dδ [J]
    EnergyShares shares;                         ///< their sum is energy_loss
    HystereticSphere
        sphere;  ///< sphere at the values, with W_ret at zero speed; with pressing and edge for loop_course()
    Pressing pressing;
    std::optional<MovingEdge> edge;  ///< for models with a rate-dependent tip
};

/// Empty where W_app is 0: no contact forms.
/// @throws InvalidArgument unless radius and pressing are known.
[[nodiscard]] std::optional<PredictedRetraction> predicted_retraction_loop(const FittedModel& fitted,
                                                                           const RetractionPair& pair);

}  // namespace setae::hysteresis

namespace setae::fields {

template <>
struct Described<hysteresis::BranchPinning> {
    using T = hysteresis::BranchPinning;
    static constexpr std::array rows{
        field<&T::larkin_lengths>("larkin_lengths",
                                  "length of the edge in Larkin lengths N; null without a sphere, for an endless edge"),
        field<&T::measured>("measured", "whether fronts with this energy share and length were simulated"),
        made<T>("pinning_coefficient", "k", "1", "k",
                [](const T& of) {
                    return Estimate{.value = of.coefficient.value, .standard_error = of.coefficient.standard_error};
                }),
        inner<&T::coefficient>(),
        value<&T::contact_radius>("contact_radius", "m", "contact radius of the edge, by JKR; null without a sphere")
            .or_null(),
    };
    static constexpr Description description{"branch_pinning", "pinning of the edge by roughness on one branch", rows};
};
static_assert(complete<hysteresis::BranchPinning>);

template <>
struct Described<hysteresis::PairPinning> {
    using T = hysteresis::PairPinning;
    static constexpr std::array rows{
        field<&T::energy_share>("energy_share", "energy share U_el/(A W) of the contact"),
        field<&T::approach>("approach", "pinning at the largest load"),
        field<&T::retraction>("retraction", "pinning at pull-off under a dead load"),
        inner<&T::measured_radius>(),
    };
    static constexpr Description description{
        "", "pinning coefficient k of simulated fronts as long as the edge of the contact", rows};
};
static_assert(complete<hysteresis::PairPinning>);

template <>
struct Described<hysteresis::EnergyShares> {
    using T = hysteresis::EnergyShares;
    static constexpr std::array rows{
        quantity<&T::jump_in>("jump_in", "E_in", "J", "energy that is dissipated in the jump into contact"),
        quantity<&T::jump_out>("jump_out", "E_out", "J", "energy that is dissipated in the jump out of contact"),
        quantity<&T::crack_tip>(
            "crack_tip", "E_tip", "J",
            "additional energy of an edge on a smooth reference on retraction, or the contribution of "
            "the speed of the edge"),
        quantity<&T::roughness>("roughness", "E_rough", "J", "contribution of roughness, by the retraction model"),
        quantity<&T::bulk>("bulk", "E_bulk", "J",
                           "energy that relaxes in the bulk of the elastomer, where the relaxation is stated"),
    };
    static constexpr Description description{
        "energy_shares", "contributions to the predicted energy loss; their sum is that loss", rows};
};
static_assert(complete<hysteresis::EnergyShares>);

}  // namespace setae::fields
