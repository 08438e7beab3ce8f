// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/figures/figure.hpp"
#include "setae/validation/summary.hpp"

namespace setae::validation {

/// The rows as aligned text: per cent where relative, the unit where absolute.
[[nodiscard]] std::string summary_table(const std::vector<SummaryRow>& rows);

/// Biases only, one quantity per line, one method per column, in per cent where relative and in the unit where
/// absolute.
[[nodiscard]] std::string bias_table(const std::vector<SummaryRow>& rows);

/// Every comparison as CSV: run, item, quantity, unit, method, planted, found, standard_error, interval_lower,
/// interval_upper, covered.
[[nodiscard]] std::string comparisons_csv(const std::vector<Comparison>& comparisons);

/// Bias within 1.96 of its standard errors, for quantities relative to the true value, and coverage within Wilson's
/// interval, for all; one quantity per line, one colour per method.
[[nodiscard]] figures::Figure validation_figure(const std::vector<SummaryRow>& rows);

}  // namespace setae::validation
