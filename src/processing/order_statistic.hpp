// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "setae/core/arrays.hpp"

namespace setae::processing {

/// Defined values of an array by rank, without copying or sorting it: bits of the numbers are found 16 at a time by
/// counting.
class OrderStatistics {
public:
    /// values: read as long as this lives; absolute: ranks are of |value|.
    OrderStatistics(const double* values, Index n, bool absolute);

    [[nodiscard]] Index defined() const { return defined_; }
    /// The value with `rank` smaller ones before it, 0 <= rank < defined(). Cost: four passes.
    [[nodiscard]] double at(Index rank) const;
    /// Quantile, linear between order statistics (type 7 of Hyndman and Fan 1996).
    [[nodiscard]] double quantile(double probability) const;

private:
    [[nodiscard]] std::uint64_t key(double value) const;

    const double* values_;
    Index n_;
    bool absolute_;
    Index defined_ = 0;
};

}  // namespace setae::processing
