// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include "setae/core/arrays.hpp"

namespace setae::tables {

/// The finite number that is the whole entry of a header; empty if it is no number.
[[nodiscard]] std::optional<double> finite_number(std::string_view text);

/// A count, 0 to 2^40; empty if the entry is no such number.
[[nodiscard]] std::optional<Index> count_in(std::string_view text);

}  // namespace setae::tables
