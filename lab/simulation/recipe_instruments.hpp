// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/bytes/toml_reader.hpp"
#include "setae/simulation/recipe.hpp"
#include "stated_draws.hpp"

namespace setae::simulation {

/// Reads [calibrations] and shared_tips of a recipe whose surfaces are read. @throws FormatError as read_recipe.
void read_instruments(bytes::TomlReader& reader, StatedDraws& stated, Recipe& recipe);

}  // namespace setae::simulation
