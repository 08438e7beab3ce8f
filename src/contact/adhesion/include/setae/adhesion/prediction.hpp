// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "setae/adhesion/pair_fit.hpp"
#include "setae/adhesion/work_of_adhesion.hpp"
#include "setae/roughness/parameter_spread.hpp"

namespace setae::adhesion {

/// A rough surface for the balances: parameters of its spectrum and their uncertainties.
struct RoughSide {
    std::string name;
    const roughness::SpectralParameters& parameters;
    const roughness::ParameterSpread& spread;

    /// A function of the parameters with its inputs.
    [[nodiscard]] TracedValue traced(const roughness::ParameterSpread::Function& function) const {
        return {function(parameters), spread.components(function, name)};
    }
};

/// The soft solid in contact with the rough surface.
struct SoftSide {
    std::string name;
    TracedValue contact_modulus;  ///< E* [Pa]
    TracedValue surface_energy;   ///< γ1 [J/m²]
};

/// Balances of one pair as lines in W_int, with the variances from their uncertain inputs; without measured values.
[[nodiscard]] PairPoint modified_point(const RoughSide& rough, const SoftSide& soft);             ///< (7)
[[nodiscard]] PairPoint persson_tosatti_point(const RoughSide& rough, const SoftSide& soft);      ///< (S13)
[[nodiscard]] PairPoint point_without_area_change(const RoughSide& rough, const SoftSide& soft);  ///< (2)
/// Full-contact balance (Eq. 7) without stored energy: slope r, offset γ1 (r − 1).
[[nodiscard]] PairPoint point_without_stored_energy(const RoughSide& rough, const SoftSide& soft);

/// Full-contact balance (Eq. 7) with W_int of an elastomer in proportion to W_app of a smooth reference on that
/// elastomer, as a line in the factor c.
///
///   W_app = max(0, c W_ref r − γ1 (r − 1) − U_el/A)
///
/// modified: Eq. 7 as a line in W_int. reference: W_ref [J/m²], > 0.
[[nodiscard]] PairPoint reference_scaled_point(PairPoint modified, const TracedValue& reference);

/// Full-contact balance (Eq. 7) of an edge that roughness pins on approach: an additional energy k U_el/A.
///
/// gained: Eq. 7 without stored energy.
[[nodiscard]] PairPoint pinned_point(PairPoint modified, const PairPoint& gained, double k);

/// One balance evaluated for a pair.
struct PredictedWork {
    ApparentWork work;
    TracedValue traced;  ///< raw value with all its inputs, including those of W_int
    Estimate estimate;   ///< max(0, raw value) with all sources of its error: rectified()
};

/// The standard error of a prediction by Eq. 7 if only one of these were uncertain [J/m²]; they add in squares where
/// W_int does not depend on the others.
struct PredictionBudget {
    double spectrum = 0.0, modulus = 0.0, surface_energy = 0.0, work_of_adhesion = 0.0;
};

/// Predictions of the balances for a pair at one W_int.
struct Prediction {
    double area_ratio = 1.0;            ///< r
    Estimate stored_energy;             ///< U_el/A_app [J/m²]
    PredictedWork modified;             ///< (7)
    PredictedWork persson_tosatti;      ///< (S13)
    PredictedWork without_area_change;  ///< (2)
    PredictionBudget budget;            ///< budget of `modified`
};

/// Errors by linear propagation over inputs, including correlations between a fitted W_int and the inputs of its fit.
/// Degrees of freedom by Welch and Satterthwaite.
/// work_of_adhesion: W_int [J/m²], >= 0.
/// @throws InvalidArgument as the balances do.
[[nodiscard]] Prediction predict(const RoughSide& rough, const SoftSide& soft, const TracedValue& work_of_adhesion);

/// E_loss = W_int r A [J] of a contact of area A [m²]. Source: [D19], Eq. 10.
[[nodiscard]] TracedValue predicted_loss(const RoughSide& rough, const TracedValue& work_of_adhesion,
                                         const TracedValue& contact_area);

/// Full-contact balance (Eq. 7) of one surface against the contact modulus.
struct PredictionCurve {
    Array1D contact_modulus;   ///< [Pa]
    Array1D work_of_adhesion;  ///< max(0, Eq. 7) [J/m²]
    Array1D lower, upper;      ///< ends of the 95 % band: errors of spectrum, surface energy and W_int, floored at 0
};

/// surface_energy: γ1 [J/m²].  work_of_adhesion: W_int [J/m²].  contact_moduli: [Pa], > 0.
/// Source: [D19], Eq. 7.
[[nodiscard]] PredictionCurve prediction_curve(const RoughSide& rough, const TracedValue& surface_energy,
                                               const TracedValue& work_of_adhesion, const Array1D& contact_moduli);

}  // namespace setae::adhesion
