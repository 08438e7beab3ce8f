// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/contact/maugis_dugdale.hpp"

/// The transition equation of Carpick, Ogletree and Salmeron: contact radius against force between DMT (α = 0) and JKR
/// (α = 1) with three parameters that can be fitted.
///
///   a/a0 = [(α + √(1 − F/Fc))/(1 + α)]^(2/3),   λ = −0.924 ln(1 − 1.02 α)
///
/// a0: radius at F = 0.  Fc < 0: force at pull-off.  Exact for α = 0 and α = 1.
/// Compared with Maugis–Dugdale, with λ from this relation and equal a0 and Fc (measured, F from −0.95 ❘Fc❘ to 10
/// ❘Fc❘): contact radii agree within 1.6 % of a0 for every λ, within 0.7 % for λ >= 1.5; at pull-off itself, where
/// Maugis' radius decreases faster with λ, within 0.06 a0. The relation ends at α = 1/1.02 (λ = ∞): larger α are JKR.
/// Source: Carpick, Ogletree, Salmeron, J. Colloid Interface Sci. 211 (1999) 395.
namespace setae::contact::transition {

struct RadiusCurve {
    double zero_load_radius = 0.0;  ///< a0 [m], > 0
    double pull_off_force = 0.0;    ///< Fc [N], < 0
    double transition_share = 0.0;  ///< α, 0 (DMT) to 1 (JKR)
};

/// Contact radius [m] under force F [N], on the stable branch; NaN for F < Fc.
/// @throws InvalidArgument for a curve outside its domain.
[[nodiscard]] double contact_radius(double force, const RadiusCurve& curve);
[[nodiscard]] Array1D contact_radius(const ArrayView1D& force, const RadiusCurve& curve);

/// Force F = Fc {1 − [(1 + α)(a/a0)^(3/2) − α]²} [N] at contact radius a [m]; NaN below the radius at pull-off.
/// @throws InvalidArgument for a < 0 or a curve outside its domain.
[[nodiscard]] double force(double contact_radius, const RadiusCurve& curve);
[[nodiscard]] Array1D force(const ArrayView1D& contact_radius, const RadiusCurve& curve);

/// α = (1 − e^(−λ/0.924))/1.02 for Maugis' λ. @throws InvalidArgument for λ <= 0.
[[nodiscard]] double transition_share(double transition_parameter);

/// λ = −0.924 ln(1 − 1.02 α). @throws InvalidArgument for α outside (0, 1/1.02), where the relation gives no λ.
[[nodiscard]] double transition_parameter(double transition_share);

/// The curve of a Maugis–Dugdale contact: with its a0 and Fc, and α from its λ.
/// @throws InvalidArgument for a contact outside its domain.
[[nodiscard]] RadiusCurve curve_of(const maugis_dugdale::Contact& contact);

/// The Maugis–Dugdale contact of sphere radius R [m] with a0, Fc and λ(α) of a curve: the result of a fit. @throws
/// InvalidArgument for R <= 0, a curve outside its domain, or α outside (0, 1/1.02).
[[nodiscard]] maugis_dugdale::Contact contact_of(const RadiusCurve& curve, double radius);

}  // namespace setae::contact::transition
