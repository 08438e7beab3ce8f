// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "setae/hysteresis/retraction_pair.hpp"

namespace setae::hysteresis {

/// A count that rests on uncertain inputs: 2.5 and 97.5 % of draws lie below and above.
struct CountRange {
    int lower = 0, upper = 0;
};

/// How many of the pairs come into full contact of themselves where everything that their U_el/(A W) rests on is drawn
/// within its ±, inputs that pairs share alike for all of them. ln U_el/(A W) is normal. A pair that gains nothing by
/// conforming never does.
[[nodiscard]] CountRange pairs_in_full_contact(const std::vector<RetractionPair>& pairs, std::uint64_t seed = 1);

}  // namespace setae::hysteresis
