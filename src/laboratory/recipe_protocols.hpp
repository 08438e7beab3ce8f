// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "setae/io/toml_reader.hpp"
#include "setae/laboratory/recipe.hpp"

namespace setae::laboratory {

/// Who measures, by name: the instruments of a surface without its spectrum.
using Protocols = std::map<std::string, SurfaceRecipe>;

/// Reads [protocols.NAME]. @throws FormatError as read_recipe.
[[nodiscard]] Protocols read_protocols(io::TomlReader& recipe);

}  // namespace setae::laboratory
