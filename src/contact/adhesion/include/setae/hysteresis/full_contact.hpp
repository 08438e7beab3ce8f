// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "setae/hysteresis/retraction_pair.hpp"

namespace setae::hysteresis {

/// A count with uncertain inputs: 2.5 and 97.5 % of draws lie below and above.
struct CountRange {
    int lower = 0, upper = 0;
};

/// Number of pairs in spontaneous full contact when all inputs of their U_el/(A W) are drawn within their standard
/// errors; shared inputs are equal for all pairs. ln U_el/(A W) is normal. A pair with no gain in full contact is never
/// counted.
[[nodiscard]] CountRange pairs_in_full_contact(const std::vector<RetractionPair>& pairs, std::uint64_t seed = 1);

}  // namespace setae::hysteresis
