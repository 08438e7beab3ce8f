// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "range_draws.hpp"
#include "setae/simulation/recipe.hpp"
#include "stated_draws.hpp"

namespace setae::simulation {

/// Reads [elastomers.NAME]. @throws FormatError as read_recipe.
[[nodiscard]] ElastomerRecipe read_elastomer(const std::string& name, bytes::TomlReader reader,
                                             const RangeDraws& ranges, StatedDraws& stated);

}  // namespace setae::simulation
