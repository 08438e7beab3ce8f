// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/core/quantity.hpp"
#include "setae/half_space/hard_wall.hpp"

namespace setae::half_space {

/// The quantities of a contact with names, symbols and units, in the order of the output.
/// contact_stiffness: see there [Pa/m].
[[nodiscard]] std::vector<Quantity> contact_quantities(const HardWall& problem, const HardWallContact& contact,
                                                       double contact_stiffness);

/// The contact in a sentence or two for a reader: area, pressure, gap, stiffness.
[[nodiscard]] std::string contact_sentence(const HardWall& problem, const HardWallContact& contact,
                                           double contact_stiffness);

/// "converged", "not_converged".
[[nodiscard]] const char* name_of(SolveStatus status);
/// "finite", "undefined", "blocked".
[[nodiscard]] const char* name_of(MeanDisplacement mean);

}  // namespace setae::half_space
