// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include "setae/core/arrays.hpp"

namespace setae::tables {

/// The finite number that a header's entry is as a whole; nothing where it is none.
[[nodiscard]] std::optional<double> finite_number(std::string_view text);

/// The number that counts something, 0 to 2^40; nothing where the entry is no such number.
[[nodiscard]] std::optional<Index> count_in(std::string_view text);

}  // namespace setae::tables
