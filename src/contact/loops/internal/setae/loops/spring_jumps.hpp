// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/contact/jkr.hpp"

namespace setae::loops {

/// Jumps of a smooth JKR sphere in a machine of stiffness k, and their energy losses.
///
/// With a = a_c v², a_c that of the pull-off under fixed grips, and κ = 4E*a_c/(3k), the position of the stage is
///
///   m = δ + F/k = (a_c²/R) [v⁴ − 4v + κ (v⁶ − 6v³)]
///
/// Contact forms at m = 0 and follows this curve down to dm/dv = 0. Jumps at constant m dissipate the difference of
/// contact energy and of the spring's, F²/(2k).
struct SpringJumps {
    contact::jkr::State after_jump_in;
    contact::jkr::State before_jump_out;
    double jump_in_loss = 0.0;   ///< [J]
    double jump_out_loss = 0.0;  ///< [J], including the energy of the spring

    [[nodiscard]] double total() const { return jump_in_loss + jump_out_loss; }
};

/// Limits: k → ∞ is fixed grips, κ = 0, v³ = 4 and v³ = 1, loss 1.2749410291 in Maugis' units; k → 0 is a dead load, v³
/// = 6 and v³ = 3, where the jump out costs F²/(2k) beyond all bounds. contact: with W > 0. machine_stiffness: k [N/m],
/// > 0; infinite for fixed grips.
/// @throws InvalidArgument outside the domain.
/// Source: Maugis, Contact, Adhesion and Rupture of Elastic Solids (2000), ch. 4; of the losses: energy balance.
[[nodiscard]] SpringJumps spring_jumps(const contact::jkr::Contact& contact, double machine_stiffness);

}  // namespace setae::loops
