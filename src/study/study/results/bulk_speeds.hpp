// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/study/hysteresis.hpp"

namespace setae::study {

/// Elastomers whose edge needs more at speed than their bulk can take: W_ret as read over W_ret at rest of a pair more
/// than two standard errors above 1 + Σ g of the relaxation that the study states. SPEED_BEYOND_BULK, of the pair that
/// is farthest beyond.
/// Source: contact::crack_speed::largest_bulk_factor().
[[nodiscard]] std::vector<Alert> speeds_beyond_bulk(const Hysteresis& hysteresis);

}  // namespace setae::study
