// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/hysteresis/pinning_law.hpp"

namespace setae::hysteresis {

/// Effect of roughness on the work of adhesion on retraction.
enum class Law {
    reversible,             ///< no effect
    pinning,                ///< pinned edge: 2k U_el/A, k of simulated fronts as long as the contact's edge
    pinning_by_bands,       ///< pinning by each band of a factor of 4, one after the other
    fitted_pinning,         ///< 2k U_el/A with one k for all pairs
    conformal_loss,         ///< the whole gain of approach is lost: E_loss = W_int A_true (Eq. 10)
    fitted_conformal_loss,  ///< the same with an independent work: E_loss = W_x A_true
    opening_work,           ///< constant work per unit true area, independent of the stored energy: W_ret = W_x r
};

/// A parameter of a model that is fitted to all pairs.
struct ModelParameter {
    std::string symbol;    ///< "k", "W_x"
    std::string quantity;  ///< "pinning_coefficient", "work_per_true_area"
    std::string unit;      ///< "1", "J/m2"
};

/// Loss at the crack tip, which smooth surfaces also have.
enum class Tip {
    none,
    reference,  ///< by the factor of the smooth reference: φ = W_ret/W_app
    speed,      ///< by the factor at the speed of the edge of the pair: φ = 1 + (v/v0)^n
};

/// A retraction model: an effect of roughness, with or without the loss at the crack tip.
///
///   W_ret = φ (W_app + x),  φ of the same elastomer, 1 without the crack tip
///
/// x: the effect of roughness.  Pinning and the true-area loss (Eq. 10) describe the same energy and exclude each
/// other, and so do the two factors of the tip; every effect of roughness can be combined with every tip, which
/// multiplies the work of the moving edge. opening_work has W_x r in place of W_app + x.
struct RetractionModel {
    Law law = Law::reversible;
    Tip tip = Tip::none;

    /// "pinning", "crack_tip_pinning", "crack_speed_pinning"; for the tip only "crack_tip", "crack_speed".
    [[nodiscard]] std::string name() const;
    [[nodiscard]] std::string formula() const;       ///< "φ (W_app + 2k U_el/A)"
    [[nodiscard]] bool fitted() const;               ///< whether it has a parameter
    [[nodiscard]] ModelParameter parameter() const;  ///< parameter of a fitted model

    friend bool operator==(const RetractionModel&, const RetractionModel&) = default;
};

/// All effects of roughness with each of these tips.
[[nodiscard]] std::vector<RetractionModel> retraction_models(const std::vector<Tip>& tips = {Tip::none,
                                                                                             Tip::reference});

/// Inputs of a model for a pair, without their errors. For partial contact, values of the area in contact.
struct PairState {
    double area_ratio = 1.0;        ///< area ratio r of the surface, >= 1
    double contact_fraction = 1.0;  ///< share α of the area in contact, 0 to 1: A_true/A of the contact is α r
    double stored_energy = 0.0;     ///< U_el/A [J/m²] of the contact divided by the whole area, >= 0
    double work_of_adhesion = 0.0;  ///< W_int [J/m²], > 0
    double surface_energy = 0.0;    ///< γ1 [J/m²]
    double work_approach = 0.0;     ///< W_app [J/m²], >= 0
    double tip_factor = 1.0;        ///< factor φ of the model's tip
    double pinning_factor = 1.0;    ///< factor on k of simulated fronts
    double mean_wavelength = 0.0;   ///< mean wavelength λ̄ [m] of the surface, weighted by U_el
    EdgeLengths edge{};             ///< edge lengths of the contact
    double jumps_per_area = 0.0;    ///< energy loss of both jumps of the sphere divided by π a_max² [J/m²]

    /// α r: A_true/A of the contact.
    [[nodiscard]] double true_contact() const { return contact_fraction * area_ratio; }
    /// W_int r − γ1 (r − 1): energy gained in full contact, without the stored energy [J/m²].
    [[nodiscard]] double full_contact_gain() const;
    /// U_el divided by the energy gained in the contact.
    [[nodiscard]] double energy_share() const { return stored_energy / (contact_fraction * full_contact_gain()); }
};

/// W_ret = slope θ + constant, θ the model's parameter [J/m²]; slope 0 without one.
struct RetractionLine {
    double slope = 0.0, constant = 0.0;
};

/// bands: bands of U_el, used by pinning_by_bands only.
/// The true-area loss (Eq. 10) includes the jumps of the sphere: they are subtracted from the loss at the edge.
/// @throws InvalidArgument for a state outside its domains.
[[nodiscard]] RetractionLine retraction_line(const RetractionModel& model, const PairState& state,
                                             const std::vector<PinningBand>& bands);

/// Decrease of W_app by the model [J/m²]: a pinned edge is also pinned on approach.
///
///   W_app = g W − k U_el/A,   k at the largest load
///
/// 0 for models without pinning. parameter: θ, k for fitted_pinning. Source: simulated fronts,
/// docs/validation/crack-front.md.
[[nodiscard]] double pinned_on_approach(const RetractionModel& model, const PairState& state,
                                        const std::vector<PinningBand>& bands, double parameter);

}  // namespace setae::hysteresis
