// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "setae/contact/elasticity.hpp"

/// Selection of a model of adhesion: range of the attraction compared with the elastic deformation it causes.
///
/// μ = R^(1/3) (W/E*)^(2/3)/z0 (jkr::tabor_parameter); Maugis' λ follows from equal W and equal largest attraction of
/// Dugdale's and the Lennard-Jones law, σ0 = 16W/(9√3 z0):
///
///   λ = 2 · 16/(9√3) · (9/16π)^(1/3) μ = 1.1570 μ
///
/// Sources: Tabor, J. Colloid Interface Sci. 58 (1977) 2; Maugis, J. Colloid Interface Sci. 150 (1992) 243; Johnson,
/// Greenwood, J. Colloid Interface Sci. 192 (1997) 326 (the map).
namespace setae::contact::tabor {

/// Maugis' λ = 1.1570 μ. @throws InvalidArgument for μ <= 0.
[[nodiscard]] double transition_parameter(double tabor_parameter);

/// Largest attraction σ0 = 16W/(9√3 z0) = 1.0264 W/z0 [Pa] of a Lennard-Jones law, z0 [m] its gap of equilibrium.
/// @throws InvalidArgument for W < 0 or z0 <= 0.
[[nodiscard]] double lennard_jones_stress(double work_of_adhesion, double interaction_range);

/// Fields of Johnson and Greenwood's map.
enum class Regime {
    hertz,           ///< adhesion is small compared with the load
    rigid,           ///< the load deforms the bodies by less than the range of attraction (Bradley)
    dmt,             ///< μ < 0.1
    maugis_dugdale,  ///< 0.1 <= μ <= 5
    jkr,             ///< μ > 5
};

/// Bounds used: pull-off of Maugis' model within 5 % of DMT's below μ = 0.1 and within 0.5 % of JKR's above μ = 5;
/// adhesion neglected where 2πRW < 5 % of |F| (Hertz); bodies rigid where Hertz's penetration under |F| + 2πRW is below
/// 5 % of the range.
struct Verdict {
    Regime regime = Regime::maugis_dugdale;
    double tabor_parameter = 0.0;       ///< μ
    double transition_parameter = 0.0;  ///< λ
    std::string sentence;               ///< sentence for users: applicable model, with the numbers
};

/// Model that applies at force F [N] to a contact with an attraction of range z0 [m].
/// @throws InvalidArgument for a contact outside its domain, z0 <= 0 or a force that is not finite.
[[nodiscard]] Verdict which_model(double force, const AdhesiveContact& contact, double interaction_range);

}  // namespace setae::contact::tabor
