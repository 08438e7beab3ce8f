// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "range_draws.hpp"
#include "setae/simulation/recipe.hpp"

namespace setae::simulation {

/// Reads spectrum, anisotropy and skewness of a surface and stores all parameters. folder: folder of the files.
/// @throws FormatError as read_recipe.
void read_spectrum(bytes::TomlReader& surface_table, const std::string& folder, const RangeDraws& draws,
                   SurfaceRecipe& recipe);

}  // namespace setae::simulation
