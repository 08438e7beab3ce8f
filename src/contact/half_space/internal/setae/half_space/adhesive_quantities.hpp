// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/core/quantity.hpp"
#include "setae/half_space/adhesive_loop.hpp"

namespace setae::half_space {

/// The quantities of a cell in equilibrium with names, symbols and units, in the order of the output; area, perimeter
/// and patches are those of the points at gap 0.
[[nodiscard]] std::vector<Quantity> adhesive_quantities(const AdhesiveCell& cell, const AdhesiveState& state);

/// The quantities of a loop: works, loss, greatest tension, energies per area of the cell.
[[nodiscard]] std::vector<Quantity> loop_quantities(const AdhesiveLoop& loop);

/// The state, and the loop, in a sentence or two for a reader.
[[nodiscard]] std::string adhesive_sentence(const AdhesiveCell& cell, const AdhesiveState& state);
[[nodiscard]] std::string loop_sentence(const AdhesiveLoop& loop, const Interaction& interaction);

}  // namespace setae::half_space
