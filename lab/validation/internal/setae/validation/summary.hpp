// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "setae/fields/describe.hpp"
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

/// Rows of the data sets of a recipe: output of `setae lab causes` and `setae lab closure`.
struct RecipeSummary {
    std::string recipe;
    int runs = 0;
    std::uint64_t first_seed = 0;
    std::vector<SummaryRow> rows;
};

/// One row a quantity and method, in the order of their first appearance.
[[nodiscard]] std::vector<SummaryRow> summary(const std::vector<Comparison>& comparisons);

/// Wilson's interval for a share of `hits` in `count`. @throws InvalidArgument unless 0 <= hits <= count and count > 0.
/// Source: Wilson, J. Am. Stat. Assoc. 22 (1927) 209.
[[nodiscard]] Interval share_interval(int hits, int count, double level = 0.95);

/// The same for a share from 0 to 1 in a count, > 0, that need not be whole.
[[nodiscard]] Interval share_interval(double share, double count, double level = 0.95);

}  // namespace setae::validation

template <>
struct setae::fields::Described<setae::validation::SummaryRow> {
    using T = validation::SummaryRow;
    static constexpr std::array rows{
        field<&T::quantity>("quantity", "name of the quantity"),
        field<&T::method>("method", "method of determination"),
        made<T>("unit", "unit of the deviations: 1 where they are relative to the true value",
                [](const T& of) {
                    return of.measure == validation::Deviation::relative ? std::string_view("1") : of.unit;
                }),
        field<&T::count>("count", "number of comparisons"),
        field<&T::bias>("bias", "mean deviation of the found value from the true value"),
        field<&T::bias_error>("bias_standard_error", "standard error of the bias"),
        field<&T::scatter>("scatter", "standard deviation of the deviations"),
        field<&T::stated>("stated", "mean of the reported standard errors"),
        field<&T::worst>("worst", "deviation of the largest size"),
        field<&T::coverage>("coverage", "share of 95 % intervals that cover the true value"),
        made<T>("coverage_interval", "lower and upper end of the 95 % interval of the coverage",
                [](const T& of) {
                    return std::array{of.coverage_interval.lower, of.coverage_interval.upper};
                }),
        inner<&T::unit>(),
        inner<&T::measure>(),
        inner<&T::coverage_interval>(),
    };
    static constexpr Description description{"trial", "comparison of found and true values of one quantity", rows};
};
static_assert(setae::fields::complete<setae::validation::SummaryRow>);

template <>
struct setae::fields::Described<setae::validation::RecipeSummary> {
    using T = validation::RecipeSummary;
    static constexpr std::array rows{
        field<&T::recipe>("recipe", "name of the recipe's file, as given"),
        field<&T::runs>("runs", "number of data sets"),
        field<&T::first_seed>("first_seed", "seed of the first data set"),
        field<&T::rows>("rows", "one entry per quantity and method"),
    };
    static constexpr Description description{"", "studies of simulated surfaces with known parameters", rows};
    static constexpr Description of_causes{"", "effects of uncorrected causes of error", rows};
};
static_assert(setae::fields::complete<setae::validation::RecipeSummary>);
