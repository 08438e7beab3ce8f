// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/core/arrays.hpp"
#include "setae/core/units.hpp"
#include "setae/tables/mapping.hpp"

namespace setae::tables {

/// Letters, digits and '_', not beginning with a digit.
[[nodiscard]] bool is_identifier(const std::string& name);

/// Checks that an expression parses with these names. @throws InvalidArgument.
void require_expression(const std::string& expression, const std::vector<std::string>& names);

/// Named inputs of an expression, in SI.
struct ExpressionInputs {
    struct Column {
        std::string name;
        Array1D values;
        Dimension dimension;
    };
    std::vector<Column> columns;
    std::vector<MappedConstant> constants;
};

/// An expression row by row.
///
/// Its dimension is checked by changing the base units one at a time: if metres become twice as large, a result of
/// dimension length^n must scale with 2^n.
/// @throws InvalidArgument for an expression that does not parse or whose dimension is not `expected`.
[[nodiscard]] Array1D evaluate(const std::string& expression, const ExpressionInputs& inputs,
                               const Dimension& expected);

}  // namespace setae::tables
