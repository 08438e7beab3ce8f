// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/validation/comparison.hpp"

namespace setae::validation {

/// All comparisons of one quantity by one method.
struct SummaryRow {
    std::string quantity, method, unit;
    Deviation measure = Deviation::relative;
    int count = 0;
    double bias = 0.0;        ///< mean deviation
    double bias_error = 0.0;  ///< its standard error; comparisons of one run count as one where they share a value
    double scatter = 0.0;     ///< standard deviation of the deviations
    double worst = 0.0;       ///< deviation of the largest size
    double stated = 0.0;      ///< mean of the standard deviations the intervals state
    double coverage = 0.0;    ///< share of 95 % intervals that cover the true value
    /// Wilson's 95 % interval, for as many independent comparisons as give the scatter between runs
    Interval coverage_interval;
};

/// One row a quantity and method, in the order of their first appearance.
[[nodiscard]] std::vector<SummaryRow> summary(const std::vector<Comparison>& comparisons);

/// Wilson's interval for a share of `hits` in `count`. @throws InvalidArgument unless 0 <= hits <= count and count > 0.
/// Source: Wilson, J. Am. Stat. Assoc. 22 (1927) 209.
[[nodiscard]] Interval share_interval(int hits, int count, double level = 0.95);

/// The same for a share from 0 to 1 in a count, > 0, that need not be whole.
[[nodiscard]] Interval share_interval(double share, double count, double level = 0.95);

}  // namespace setae::validation
