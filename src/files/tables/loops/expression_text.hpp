// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "setae/tables/mapping.hpp"

namespace setae::tables {

/// An expression of the user, "3.01 N/m * mems", split for a mapping.
struct ExpressionText {
    std::string expression;                    ///< "quantity_1 * mems"
    std::vector<MappedConstant> constants;     ///< the numbers with a unit, by their names in the expression
    std::vector<std::string> names;            ///< column names in the expression, each once
    std::map<std::string, std::string> units;  ///< units stated for columns: "kraft[uN]"
};

/// A number followed by a unit, with or without a blank between, is a quantity; the unit has no blank and no '*'. Names
/// before '(' are functions, those that begin with '_' internal names of the parser; accents are removed. `first` is
/// the number of the first quantity. @throws InvalidArgument for a column with two units.
[[nodiscard]] ExpressionText expression_text(const std::string& text, std::size_t first = 1);

/// Name of a header cell in expressions: "MEMS displ." is "mems_displ", "Déplacement" "deplacement".
[[nodiscard]] std::string name_in_expressions(const std::string& header);

}  // namespace setae::tables
