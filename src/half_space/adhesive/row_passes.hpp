// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/arrays.hpp"
#include "setae/core/summation.hpp"
#include "setae/numerics/row_blocks.hpp"
#include "setae/parallel/for_each.hpp"

namespace setae::half_space {

/// A row of a map as one dimension.
using Row = Eigen::Map<Array1D>;
using ConstRow = Eigen::Map<const Array1D>;
inline Row row(Array2D& map, Index i) { return {map.data() + i * map.cols(), map.cols()}; }
inline ConstRow row(const Array2D& map, Index i) { return {map.data() + i * map.cols(), map.cols()}; }

/// Passes over a map row by row, on threads where it is large; sums are taken over rows in their order, so that they
/// do not depend on threads.
class RowPasses {
public:
    RowPasses(const Array2D& shape, parallel::Threads threads)
        : points_per_row_(shape.cols()),
          threads_{shape.size() < least_points ? 1 : threads.resolved()},
          sums_(shape.rows()) {}

    /// Σ of body(row) over all rows.
    template <class Body>
    double sum(Body&& body) {
        each([&](Index i) { sums_[i] = body(i); });
        return pairwise_sum(sums_);
    }
    template <class Body>
    double largest(Body&& body) {
        each([&](Index i) { sums_[i] = body(i); });
        return sums_.maxCoeff();
    }
    template <class Body>
    void each(Body&& body) const {
        numerics::for_each_row(sums_.size(), points_per_row_, threads_, body);
    }

private:
    static constexpr Index least_points = 1 << 17;
    Index points_per_row_;
    parallel::Threads threads_;
    Array1D sums_;
};

}  // namespace setae::half_space
