// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/study/hysteresis.hpp"

namespace setae::study {

/// Elastomers with a rate dependence of the edge above the limit of their bulk: W_ret as measured divided by W_ret at
/// zero speed of a pair more than two standard errors above 1 + Σ g of the stated relaxation. SPEED_BEYOND_BULK, for
/// the pair with the largest excess.
/// Source: contact::crack_speed::largest_bulk_factor().
[[nodiscard]] std::vector<Alert> speeds_beyond_bulk(const Hysteresis& hysteresis);

}  // namespace setae::study
