// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/hysteresis/pinning_law.hpp"

namespace setae::hysteresis {

/// What roughness adds to the work of adhesion on the way back.
enum class Law {
    reversible,             ///< nothing
    pinning,                ///< the edge is held: 2k U_el/A, k of simulated fronts as long as the contact's edge
    pinning_by_bands,       ///< the same of every band of a factor of 4, one after the other
    fitted_pinning,         ///< 2k U_el/A with one k of all pairs
    conformal_loss,         ///< all that is gained on approach is lost: E_loss = W_int A_true (10)
    fitted_conformal_loss,  ///< the same with a work of its own: E_loss = W_x A_true
    opening_work,           ///< opening costs one work a true area, whatever was stored: W_ret = W_x r
};

/// A number of a law that is fitted to all pairs.
struct ModelParameter {
    std::string symbol;    ///< "k", "W_x"
    std::string quantity;  ///< "pinning_coefficient", "work_per_true_area"
    std::string unit;      ///< "1", "J/m2"
};

/// What the tip of the crack loses of itself, on smooth surfaces as well.
enum class Tip {
    none,
    reference,  ///< by the factor by which the smooth reference needs more on the way back: φ = W_ret/W_app
    speed,      ///< by that of the speed at which the pair's own edge recedes: φ = 1 + (v/v0)^n
};

/// A law, alone or times the crack tip's own loss.
///
///   W_ret = φ (W_app + x),  φ of the same elastomer, 1 without the crack tip
///
/// x: the law's.  Pinning and (10) are two accounts of one energy and exclude each other, and so do the two accounts of
/// the tip; either law goes with either tip, which multiplies what an edge costs to move. opening_work has W_x r in
/// place of W_app + x.
struct RetractionModel {
    Law law = Law::reversible;
    Tip tip = Tip::none;

    /// "pinning", "crack_tip_pinning", "crack_speed_pinning"; of the tip alone "crack_tip", "crack_speed".
    [[nodiscard]] std::string name() const;
    [[nodiscard]] std::string formula() const;       ///< "φ (W_app + 2k U_el/A)"
    [[nodiscard]] bool fitted() const;               ///< whether it has a parameter
    [[nodiscard]] ModelParameter parameter() const;  ///< of a fitted one

    friend bool operator==(const RetractionModel&, const RetractionModel&) = default;
};

/// All of them with each of these tips.
[[nodiscard]] std::vector<RetractionModel> retraction_models(const std::vector<Tip>& tips = {Tip::none,
                                                                                             Tip::reference});

/// What a model is told of a pair; nothing of its errors. Where the bodies touch in part, of the part that they touch.
struct PairState {
    double area_ratio = 1.0;        ///< r, >= 1, of the surface
    double contact_fraction = 1.0;  ///< α of the area in contact, 0 to 1: A_true/A of the contact is α r
    double stored_energy = 0.0;     ///< U_el/A [J/m²], >= 0, of the contact over the whole area
    double work_of_adhesion = 0.0;  ///< W_int [J/m²], > 0
    double surface_energy = 0.0;    ///< γ1 [J/m²]
    double work_approach = 0.0;     ///< W_app [J/m²], >= 0
    double tip_factor = 1.0;        ///< φ of the model's tip
    double pinning_factor = 1.0;    ///< on k of simulated fronts
    double mean_wavelength = 0.0;   ///< λ̄ [m] of the surface, weighed by U_el
    EdgeLengths edge{};             ///< of the contact
    double jumps_per_area = 0.0;    ///< what both jumps of the sphere lose over π a_max² [J/m²]

    /// α r: A_true/A of the contact.
    [[nodiscard]] double true_contact() const { return contact_fraction * area_ratio; }
    /// W_int r − γ1 (r − 1): what conforming gains before it stores anything [J/m²].
    [[nodiscard]] double conforming_gain() const;
    /// U_el over what its contact gains.
    [[nodiscard]] double energy_share() const { return stored_energy / (contact_fraction * conforming_gain()); }
};

/// W_ret = slope θ + constant, θ the model's parameter [J/m²]; slope 0 without one.
struct RetractionLine {
    double slope = 0.0, constant = 0.0;
};

/// bands: of U_el; pinning_by_bands alone looks at them.
/// (10) counts the sphere's jumps: they are taken off what the edge loses.
/// @throws InvalidArgument for a state outside its domains.
[[nodiscard]] RetractionLine retraction_line(const RetractionModel& model, const PairState& state,
                                             const std::vector<PinningBand>& bands);

/// What the model takes off W_app [J/m²]: an edge that roughness holds is held on its way in, too.
///
///   W_app = g W − k U_el/A,   k at the largest load
///
/// 0 of models without pinning. parameter: θ, of fitted_pinning k. Source: simulated fronts,
/// docs/validation/crack-front.md.
[[nodiscard]] double pinned_on_approach(const RetractionModel& model, const PairState& state,
                                        const std::vector<PinningBand>& bands, double parameter);

}  // namespace setae::hysteresis
