// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "setae/core/quantity.hpp"

namespace setae::output {

/// Quantities for a reader, one a row, in lines of at most so many characters: name, symbol, value ± standard error and
/// 95 % interval. Wavelengths and n stand in the title where all that have them share them, else in columns; the title
/// says where intervals come from, too.
[[nodiscard]] std::string quantity_table(const std::string& title, const std::vector<Quantity>& list,
                                         std::size_t width = 100);

}  // namespace setae::output
