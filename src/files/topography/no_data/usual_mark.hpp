// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace setae::topography {

/// Whether a number of a file is a usual marker of missing values: three or more nines and nothing else from 99 on
/// (−9999, 999.999), ±2^15, 2^16, ±2^31, 2^32 and these minus one, powers of ten from 1e6, any number from 1e20. Within
/// 1e-7, the precision of single-precision numbers.
[[nodiscard]] bool is_usual_mark(double number);

}  // namespace setae::topography
