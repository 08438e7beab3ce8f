// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "setae/core/arrays.hpp"

namespace setae::fields {

/// Values of a column in outputs at most: longer ones hold every so many samples of the record.
inline constexpr Index max_samples = 20'000;

/// Every how many samples a column of so many holds, where it does not hold all of them.
[[nodiscard]] std::optional<Index> step_of(Index samples);

/// The samples that an output holds.
[[nodiscard]] Array1D thinned(const Array1D& values);

}  // namespace setae::fields
