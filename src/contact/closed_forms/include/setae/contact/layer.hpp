// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "setae/contact/elasticity.hpp"
#include "setae/core/arrays.hpp"

/// JKR (W = 0: Hertz) contact of a rigid sphere and an elastic layer of finite thickness bonded to a rigid base, or of
/// a thin bonded lens and a rigid flat, without friction in the contact.
///
/// With α = a/h and four factors of α and ν, all 1 for a half-space (α → 0): s (stiffness), d and f (dry displacement
/// and force), e (edge):
///
///   δ = (a²/R) d − √(2πaW/E*)/e,   F = (4E*a³/3R) f − √(8πE*W a³) s/e
///
/// They follow from the exact linear solution, the Fredholm equation of the second kind to which the layer's dual
/// integral equations reduce (Lebedev, Ufliand 1958), solved for each ν; they agree with another method within 2e-11 up
/// to a = 2h and 1e-8 at 5h. No fitted polynomial is used: that of Dimitriadis et al. (ν = 1/2) agrees to first order
/// in χ = √(Rδ)/h and gives forces 0.9 % too low at χ = 0.19, 5.5 % at 0.42, 13 % at 0.75. Domain: 0 < a <= 5h, −1 < ν
/// <= 1/2, a << R; displacements small against h. E* = E/(1 − ν²) of the layer only: the other body is rigid. Sources:
/// Lebedev, Ufliand, J. Appl. Math. Mech. 22 (1958) 442; Hayes et al., J. Biomech. 5 (1972) 541; Dimitriadis et al.,
/// Biophys. J. 82 (2002) 2798; stiffness of the layer: Carbone, Mangialardi, J. Mech. Phys. Solids 56 (2008) 684.
namespace setae::contact::layer {

using State = ContactState;

/// Effects of finite thickness on a contact, at one a/h; all are 1 at a/h = 0.
struct Factors {
    double stiffness = 1.0;         ///< s: dF/dδ at fixed contact radius divided by 2aE*
    double dry_displacement = 1.0;  ///< d: displacement without adhesion divided by a²/R
    double dry_force = 1.0;         ///< f: force without adhesion divided by 4E*a³/(3R)
    /// e: stress intensity at the edge of a flat punch at given displacement, divided by that of a half-space
    double edge = 1.0;
};

/// Stiffness of a layer bonded to a rigid base divided by that of a half-space, k(q)/(E* q/2), at x = qh.
///
///   ((3 − 4ν) cosh 2x + 2x² + 8ν² − 12ν + 5)/((3 − 4ν) sinh 2x − 2x)
///
/// 1 for x → ∞; x → 0: 3/(2x³) for ν = 1/2, 2 (1 − ν)²/((1 − 2ν) x) otherwise.
/// @throws InvalidArgument for x <= 0 or ν outside (−1, 1/2].  Source: Carbone, Mangialardi (2008).
[[nodiscard]] double stiffness_ratio(double x, double poisson_ratio);

/// A layer with its factors tabulated; some milliseconds to make, cheap to copy.
class Layer {
public:
    /// thickness h [m], > 0; ν in (−1, 1/2]. @throws InvalidArgument outside the domain.
    Layer(double thickness, double poisson_ratio);

    [[nodiscard]] double thickness() const { return thickness_; }
    [[nodiscard]] double poisson_ratio() const { return poisson_ratio_; }
    /// Largest contact radius [m] of the factors, 5h.
    [[nodiscard]] double largest_contact_radius() const { return largest_ratio * thickness_; }

    /// @throws InvalidArgument for a contact radius [m] outside [0, 5h].
    [[nodiscard]] Factors factors(double contact_radius) const;
    /// Derivatives of the factors by contact radius [1/m]. @throws InvalidArgument for a contact radius outside [0,
    /// 5h].
    [[nodiscard]] Factors factor_slopes(double contact_radius) const;

    static constexpr double largest_ratio = 5.0;

private:
    struct Table;
    static Table table_of(double poisson_ratio);
    /// Table against a/h; tables of the Poisson ratios used so far are cached.
    static std::shared_ptr<const Table> kept_table(double poisson_ratio);
    double thickness_;
    double poisson_ratio_;
    std::shared_ptr<const Table> table_;
};

/// Force [N], displacement [m] in equilibrium at contact radius a [m], 0 <= a <= 5h.
/// @throws InvalidArgument for a outside [0, 5h] or a contact outside its domain.
[[nodiscard]] double force(double contact_radius, const AdhesiveContact& contact, const Layer& layer);
[[nodiscard]] double displacement(double contact_radius, const AdhesiveContact& contact, const Layer& layer);

/// Energy release rate G = (F_H − F)² e²/(8πE*a³ s²) [J/m²] at contact radius a [m], 0 < a <= 5h, and force F [N], F_H
/// the force of the same contact without adhesion. @throws InvalidArgument outside the domain.
[[nodiscard]] double energy_release_rate_at_force(double contact_radius, double force, const SphereOnFlat& contact,
                                                  const Layer& layer);

/// Contact radius [m] under force F [N]; NaN where no equilibrium exists: beyond pull-off, and for the inner branch F >
/// 0.
/// @throws InvalidArgument for a contact outside its domain, and where the contact radius would exceed 5h.
[[nodiscard]] double contact_radius_at_force(double force, const AdhesiveContact& contact, const Layer& layer,
                                             Branch branch = Branch::outer);
[[nodiscard]] Array1D contact_radius_at_force(const ArrayView1D& force, const AdhesiveContact& contact,
                                              const Layer& layer, Branch branch = Branch::outer);

/// Contact radius [m] at displacement δ [m]; NaN and throws as contact_radius_at_force.
[[nodiscard]] double contact_radius_at_displacement(double displacement, const AdhesiveContact& contact,
                                                    const Layer& layer, Branch branch = Branch::outer);
[[nodiscard]] Array1D contact_radius_at_displacement(const ArrayView1D& displacement, const AdhesiveContact& contact,
                                                     const Layer& layer, Branch branch = Branch::outer);

/// Separation under a dead load, and in an infinitely stiff machine.
/// @throws InvalidArgument for a contact outside its domain, and where the contact radius would exceed 5h.
[[nodiscard]] State pull_off_at_fixed_load(const AdhesiveContact& contact, const Layer& layer);
[[nodiscard]] State pull_off_at_fixed_grips(const AdhesiveContact& contact, const Layer& layer);

}  // namespace setae::contact::layer
