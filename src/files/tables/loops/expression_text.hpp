// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "setae/tables/mapping.hpp"

namespace setae::tables {

/// An expression as a user types it, "3.01 N/m * mems", taken apart for a mapping.
struct ExpressionText {
    std::string expression;                    ///< "quantity_1 * mems"
    std::vector<MappedConstant> constants;     ///< the numbers with a unit, by the names the expression has for them
    std::vector<std::string> names;            ///< the columns it names, each once
    std::map<std::string, std::string> units;  ///< of columns that it states one for: "kraft[uN]"
};

/// A number with a unit behind it, a blank between or none, is a quantity; the unit has no blank and no '*'. Names in
/// front of '(' are functions, those that begin with '_' the parser's own; accents of a name are left out. `first`
/// numbers the first quantity. @throws InvalidArgument for a column with two units.
[[nodiscard]] ExpressionText expression_text(const std::string& text, std::size_t first = 1);

/// A header cell as expressions name it: "MEMS displ." is "mems_displ", "Déplacement" "deplacement".
[[nodiscard]] std::string name_in_expressions(const std::string& header);

}  // namespace setae::tables
