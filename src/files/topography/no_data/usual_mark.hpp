// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace setae::topography {

/// Whether a number, as a file has it, is one that programs write where there is none: three nines or more and nothing
/// else from 99 on (−9999, 999.999), ±2^15, 2^16, ±2^31, 2^32 and those less one, powers of ten from 1e6, anything from
/// 1e20. Within 1e-7, what single
/// precision keeps of a number.
[[nodiscard]] bool is_usual_mark(double number);

}  // namespace setae::topography
