// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "setae/core/quantity.hpp"

namespace setae::output {

/// Quantities for a reader, one per row, in lines of a given width: name, symbol, value ± standard error and 95 %
/// interval. Wavelengths and n are in the title where all quantities share them, else in columns; the title also states
/// the origin of intervals.
[[nodiscard]] std::string quantity_table(const std::string& title, const std::vector<Quantity>& list,
                                         std::size_t width = 100);

}  // namespace setae::output
