// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/contact/elasticity.hpp"
#include "setae/crack_front/stress_intensity.hpp"

namespace setae::crack_front {

/// Length [m] along a front over which disorder bends it by the correlation length of the disorder: shorter fronts move
/// through it without jumps.
///
///   L_c = λ̄ (W/std w)² = λ̄ AW/(4 U_el),   λ̄: mean wavelength weighted by U_el
///
/// mean_wavelength: λ̄ [m]. energy_share: U_el/(AW), > 0. @throws InvalidArgument outside the domain.
/// Source: Larkin, Ovchinnikov, J. Low Temp. Phys. 34 (1979) 409; Gao, Rice 1989 for the front's stiffness |q|.
[[nodiscard]] double larkin_length(double mean_wavelength, double energy_share);

/// Mean wavelength λ̄ [m] of a surface, weighted by the elastic energy of each wave, from two parameters of the
/// surface.
///
///   λ̄ = 2π Σ|h_q|²/Σ|q||h_q|² = π h_rms²/(2u),   u = U_el/(A E*) = ¼ Σ|q||h_q|²
///
/// rms_height: h_rms [m], > 0. energy_per_modulus: u [m], > 0. @throws InvalidArgument outside the domain.
[[nodiscard]] double mean_wavelength(double rms_height, double energy_per_modulus);

/// Length [m] along the edge of a contact over which the sphere allows the edge to bend. The sphere keeps longer waves
/// of the edge at the radius a, like a spring of stiffness q_κ.
///
///   ℓ = π/q_κ,   q_κ = d ln G/da at fixed δ = 4a/(R|D|) − 1/a,   |D| = √(2πaW/E*);   ℓ at most 2πa
///
/// 2πa/10 without load, 2πa/4 at pull-off under a dead load. A straight front has ℓ = L_z where its spring is π/L_z.
/// contact_radius: a [m], > 0. contact: R, E*, W > 0. @throws InvalidArgument outside the domain.
/// Source: G of a sphere, Maugis, Contact, Adhesion and Rupture (2000), ch. 4; docs/concepts/crack-front.md.
[[nodiscard]] double free_length(double contact_radius, const contact::AdhesiveContact& contact);

/// Number of Larkin lengths within free_length(): a large number corresponds to a long front. energy_share: U_el/(AW),
/// > 0. @throws InvalidArgument outside the domain.
[[nodiscard]] double larkin_lengths(double contact_radius, const contact::AdhesiveContact& contact,
                                    double mean_wavelength, double energy_share);

/// Conditions of validity of the front theory for one roughness.
struct FrontValidity {
    double energy_share = 0.0;     ///< U_el/(AW)
    double work_scatter = 0.0;     ///< std w/W = 2 √(U_el/(AW)) of the linear field
    double negative_share = 0.0;   ///< share of a Gaussian linear field with w < 0, where no work keeps the contact
    double larkin_length = 0.0;    ///< [m]
    double front_length = 0.0;     ///< [m]
    double points_per_wave = 0.0;  ///< points of the field per shortest wavelength λ_s, in the coarser direction
    /// One sentence for each of: U_el/(AW) above 1/16 (one position in forty has w < 0), above 0.3 (no spontaneous full
    /// contact, adhesive-cells.md), a front below its Larkin length, fewer than 8 points per wavelength.
    std::vector<std::string> cautions;
};

/// front_length: 2πa of the contact, or the width of a straight front [m]. line_spacing: spacing of lines, at that
/// radius [m]. @throws InvalidArgument for lengths or a mean work W [J/m²] <= 0, and a surface without roughness.
[[nodiscard]] FrontValidity validity_of(const StressIntensity& intensity, double mean_work, double front_length,
                                        double line_spacing);

}  // namespace setae::crack_front
