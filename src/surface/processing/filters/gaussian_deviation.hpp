// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/arrays.hpp"

namespace setae::processing {

/// Standard deviation [m] of the weights exp(−π (x/(α λc))²) of a Gaussian regression that transmits 50 % at λc: α
/// λc/sqrt(2π).
///
/// Orders 0 and 1 of the local polynomial transmit exp(−u), order 2 (1 + u) exp(−u), u = π (α λc/λ)²; so α = sqrt(u/π)
/// with u the solution for 1/2: ln 2, or 1.67834699 (ISO 16610-31 rounds α to 0.7309).
[[nodiscard]] double gaussian_deviation(double cutoff, Index order);

}  // namespace setae::processing
