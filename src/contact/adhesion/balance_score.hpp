// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "setae/adhesion/balance_comparison.hpp"

namespace setae::adhesion {

/// A score without the leave-one-out deviation.
[[nodiscard]] BalanceScore score_of(int parameters, double work, double residual_squares, double total_squares,
                                    std::size_t pairs);

}  // namespace setae::adhesion
