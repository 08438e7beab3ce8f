// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "setae/core/arrays.hpp"

namespace setae::processing {

/// Defined values of an array by rank, without sorting it: bits of the numbers are found 16 at a time by counting,
/// until at most an eighth of the values agree in them; those are copied.
class OrderStatistics {
public:
    /// values: read as long as this lives; absolute: ranks are of |value|.
    OrderStatistics(const double* values, Index n, bool absolute);

    [[nodiscard]] Index defined() const { return defined_; }
    /// The value with `rank` smaller ones before it, 0 <= rank < defined(). Cost: two passes, five where most values
    /// are nearly equal.
    [[nodiscard]] double at(Index rank) const;
    /// Quantile, linear between order statistics (type 7 of Hyndman and Fan 1996).
    [[nodiscard]] double quantile(double probability) const;

private:
    [[nodiscard]] std::uint64_t key(double value) const;
    /// The value at a rank and the next one; the second means nothing at the last rank.
    [[nodiscard]] std::array<double, 2> pair_at(Index rank) const;
    /// The same, among the `count` values whose keys begin with `prefix` above `shift` bits.
    [[nodiscard]] std::array<double, 2> among(std::uint64_t prefix, int shift, Index rank, Index count) const;
    [[nodiscard]] std::uint64_t least_above(std::uint64_t bound) const;

    const double* values_;
    Index n_;
    bool absolute_;
    Index defined_ = 0;
};

}  // namespace setae::processing
