// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "setae/core/estimate.hpp"

namespace setae {

/// "37.0 ± 3.7": the standard error with two significant digits, the value to the same place; four significant digits
/// if no error is known, "–" for NaN.
///
/// Far from 1 both share a power of ten, "(1.00 ± 0.20)×10⁻³⁰". Source: JCGM 100:2008, 7.2.6. Values are divided by
/// factor first.
[[nodiscard]] std::string uncertain_number(const Estimate& estimate, double factor = 1.0);

/// "36.98 [36.67, 37.28]": the value and its 95 % interval to the place of the standard error's second digit;
/// uncertain_number() if there is no interval.
[[nodiscard]] std::string number_with_interval(const Estimate& estimate, double factor = 1.0);

/// "37.0 ± 3.7 [29.7, 44.3]": standard error and interval.
[[nodiscard]] std::string full_number(const Estimate& estimate, double factor = 1.0);

/// uncertain_number() with the prefix that format_value() chooses for the larger of value and error: "37.0 ± 3.7
/// mJ/m²".
[[nodiscard]] std::string format_uncertain(const Estimate& estimate, std::string_view si_unit);

/// number_with_interval() with the prefix of format_uncertain(): "36.98 [36.67, 37.28] mJ/m²".
[[nodiscard]] std::string format_interval(const Estimate& estimate, std::string_view si_unit);

/// full_number() with the prefix of format_uncertain(): "37.0 ± 3.7 [29.7, 44.3] mJ/m²".
[[nodiscard]] std::string format_full(const Estimate& estimate, std::string_view si_unit);

/// A probability as printed in papers: "0.57", "1", "4·10⁻³³".
[[nodiscard]] std::string probability_text(double probability);

}  // namespace setae
