// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "setae/core/arrays.hpp"
#include "setae/parallel/for_each.hpp"

namespace setae::processing {

/// Defined values of an array by rank, without sorting it. A sample gives two bounds around the value; those between
/// them are copied. Where the bounds miss it or the array is small: bits of the numbers are found 16 at a time by
/// counting, until at most an eighth of the values agree in them; those are copied.
class OrderStatistics {
public:
    /// values: read as long as this lives; absolute: ranks are of |value|.
    OrderStatistics(const double* values, Index n, bool absolute, parallel::Threads threads = {});

    [[nodiscard]] Index defined() const { return defined_; }
    /// The value with `rank` smaller ones before it, 0 <= rank < defined(). Cost: one pass as a rule, five where
    /// most values are nearly equal.
    [[nodiscard]] double at(Index rank) const;
    /// Quantile, linear between order statistics (type 7 of Hyndman and Fan 1996).
    [[nodiscard]] double quantile(double probability) const;

private:
    [[nodiscard]] double value(Index i) const;
    [[nodiscard]] std::uint64_t key(double value) const;
    /// The value at a rank and the next one; the second means nothing at the last rank.
    [[nodiscard]] std::array<double, 2> pair_at(Index rank) const;
    /// The same, among the values between two of a sample; nothing where that interval misses the rank.
    [[nodiscard]] std::optional<std::array<double, 2>> between_sampled(Index rank) const;
    [[nodiscard]] std::array<double, 2> by_digits(Index rank) const;
    [[nodiscard]] static std::array<double, 2> pair_of(std::vector<std::uint64_t>& keys, Index rank,
                                                       std::uint64_t above);
    /// The same, among the `count` values whose keys begin with `prefix` above `shift` bits.
    [[nodiscard]] std::array<double, 2> among(std::uint64_t prefix, int shift, Index rank, Index count) const;
    [[nodiscard]] std::uint64_t least_above(std::uint64_t bound) const;

    const double* values_;
    Index n_;
    bool absolute_;
    parallel::Threads threads_;
    Index defined_ = 0;
};

}  // namespace setae::processing
