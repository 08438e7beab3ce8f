// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "setae/core/arrays.hpp"
#include "setae/parallel/for_each.hpp"

namespace setae::processing {

/// Numbers in rows that are computed on request, without an array of all of them; NaN values are ignored. Both
/// functions are called from several threads.
struct ComputedRows {
    Index rows = 0, columns = 0;
    std::function<void(Index row, double* values)> load;
    std::function<double(Index row, Index column)> at;  ///< a single one of the same numbers
};

/// Bounds of a quantile, both included.
struct Bounds {
    double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
};

/// A sample of some thousand numbers, which gives bounds of quantiles of all.
class Sample {
public:
    /// The sample is empty for few numbers.
    explicit Sample(const ComputedRows& values);

    /// About a quantile, `width` times five standard errors of its rank on either side; unbounded for an empty sample.
    [[nodiscard]] Bounds around(double probability, double width = 1.0) const;

private:
    std::vector<double> sorted_;
};

/// Counts of numbers below and at two bounds, and copies of those between them.
class QuantileSearch {
public:
    explicit QuantileSearch(const Bounds& bounds) : bounds_(bounds) {}

    void add(const double* values, Index n);
    /// Adds the numbers of another search between the same bounds.
    void add(const QuantileSearch& other);

    [[nodiscard]] Index defined() const { return defined_; }
    /// Quantile of the defined numbers, linear between order statistics (type 7 of Hyndman and Fan 1996); empty if it
    /// is not between the bounds. @throws InternalError if no number is defined.
    [[nodiscard]] std::optional<double> quantile(double probability);

private:
    [[nodiscard]] std::optional<double> at(Index rank);

    Bounds bounds_;
    Index defined_ = 0, below_ = 0, at_low_ = 0, at_high_ = 0;
    std::vector<double> between_;
};

/// Widths of Sample::around() in the order of trials.
inline constexpr double search_widths[] = {1.0, 8.0, std::numeric_limits<double>::infinity()};

/// Quantile of the defined numbers, see QuantileSearch; empty if none is defined. The result is the same for any number
/// of threads. Cost: usually one pass, at most three; memory for about a twentieth of the numbers.
[[nodiscard]] std::optional<double> quantile(const ComputedRows& values, double probability,
                                             parallel::Threads threads = {});

}  // namespace setae::processing
