// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "setae/bytes/toml_reader.hpp"
#include "setae/simulation/recipe.hpp"

namespace setae::simulation {

/// Instruments of a surface by name, without its spectrum.
using Protocols = std::map<std::string, SurfaceRecipe>;

/// Reads [protocols.NAME]. @throws FormatError as read_recipe.
[[nodiscard]] Protocols read_protocols(bytes::TomlReader& recipe);

}  // namespace setae::simulation
