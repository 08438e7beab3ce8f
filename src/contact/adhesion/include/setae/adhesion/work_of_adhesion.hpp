// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/arrays.hpp"

namespace setae::adhesion {

/// Effect of roughness on the energy balance, per apparent area.
struct ConformalState {
    double area_ratio = 1.0;     ///< r = A_true/A_app, >= 1
    double stored_energy = 0.0;  ///< U_el/A_app [J/m²], >= 0
};

/// Apparent work of adhesion on approach.
struct ApparentWork {
    double raw = 0.0;      ///< result of the balance [J/m²]; negative where full contact costs energy
    double floored = 0.0;  ///< max(0, raw): measurable work
    bool conforms = true;  ///< raw > 0; necessary, not sufficient: see scale_balance.hpp
};

/// Full-contact balance with the area change of the soft side at constant surface energy.
///
///   W_app = W_int r − γ1 (r − 1) − U_el/A_app
///
/// work_of_adhesion: W_int [J/m²], >= 0.  surface_energy: γ1 of the soft solid [J/m²], >= 0.
/// Limits: flat W_int; E* → 0: W_int r − γ1 (r − 1).
/// @throws InvalidArgument outside the domain.  Source: [D19], Eq. 7.
[[nodiscard]] ApparentWork modified_balance(double work_of_adhesion, double surface_energy,
                                            const ConformalState& state);

/// Small-slope balance, without area change of the soft side: W_app = W_int r − U_el/A_app. Source: [D19], Eq. 2.
[[nodiscard]] ApparentWork balance_without_area_change(double work_of_adhesion, const ConformalState& state);

/// Persson–Tosatti balance: W_app = W_int (1 + h'²/2) − U_el/A_app. Source: [PT01]; [D19], Eq. S13.
[[nodiscard]] ApparentWork persson_tosatti_balance(double work_of_adhesion, double rms_slope, double stored_energy);

/// Surface energy γ1s of the soft solid against its stretched area x = A/A_app.
struct SurfaceEnergyLaw {
    Array1D area_ratio;      ///< nodes x, increasing from 1
    Array1D surface_energy;  ///< γ1s(x) [J/m²], linear between nodes, constant beyond the last

    /// @throws InvalidArgument unless there are as many energies as ratios and the ratios increase from 1.
    void validate() const;

    /// γ1s at x [J/m²].
    [[nodiscard]] double at(double x) const;
    /// ∫_1^x γ1s dx' [J/m²], exact for the law.
    [[nodiscard]] double integral(double x) const;
};

/// Balance of end states with an interface that differs from the unstrained one.
///
///   W_app = W_int r − γ1 (r − 1) − (γ1s2 − γ12) r − U_el/A_app
///
/// Stretching from A_app to A_true costs ∫ Υ dA with the surface stress Υ = d(γ1s A)/dA. Therefore γ1s A_true − γ1
/// A_app is spent, and γ1s A_true is gained where the stretched side is covered. The strain dependence of γ1s cancels.
/// interface_change: γ1s2 − γ12 at this strain [J/m²].
/// @throws InvalidArgument outside the domain.  Source: derived in docs/concepts; [D19], Eq. 5 with ∫ Υ dA.
[[nodiscard]] ApparentWork end_state_balance(double work_of_adhesion, double surface_energy, double interface_change,
                                             const ConformalState& state);

/// The balance with a strain-dependent surface energy (Eq. 6) as printed, with ∫ γ1s dA for the cost of stretching.
///
///   W_app = W*_int r − ∫_1^r γ1s(x) dx − U_el/A_app,   W*_int = W_int + [γ1s(r) − γ1s(1)]
///
/// The strain is assumed not to change the interface (γ1s2 = γ12). Equals modified_balance for a constant law. For any
/// other law it counts the change of γ1s twice: it exceeds end_state_balance by r γ1s(r) − γ1s(1) − ∫ γ1s dx, which is
/// χ (r² − 1)/2 for a law γ1 + χ (x − 1).
/// @throws InvalidArgument outside the domain.  Source: [D19], Eqs. 5, 6; THEORY §8.
[[nodiscard]] ApparentWork printed_balance(double work_of_adhesion, const SurfaceEnergyLaw& law,
                                           const ConformalState& state);

}  // namespace setae::adhesion
