// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace setae {

/// Scaled complementary error function, erfcx(x) = exp(x²) erfc(x), without overflow for large x.
///
/// Relative error below 1e-13 for x >= 0; for x < 0 erfcx(x) = 2 exp(x²) − erfcx(−x), infinite below about −26.6.
/// Source: DLMF 7.2, 7.9.3 (continued fraction).
[[nodiscard]] double scaled_complementary_error_function(double x);

}  // namespace setae
