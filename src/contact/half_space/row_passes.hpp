// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include <boost/container/small_vector.hpp>

#include "setae/core/arrays.hpp"
#include "setae/core/extent.hpp"
#include "setae/core/summation.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/parallel/slab.hpp"

namespace setae::half_space {

/// A map of float or double, and a row of it as one dimension.
template <class Real>
using MapOf = Eigen::Array<Real, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
template <class Real>
using RowOf = Eigen::Map<Eigen::Array<Real, Eigen::Dynamic, 1>>;
template <class Real>
using ConstRowOf = Eigen::Map<const Eigen::Array<Real, Eigen::Dynamic, 1>>;
using Row = RowOf<double>;
using ConstRow = ConstRowOf<double>;
template <class Real>
RowOf<Real> row(MapOf<Real>& map, Index i) {
    return {map.data() + i * map.cols(), map.cols()};
}
template <class Real>
ConstRowOf<Real> row(const MapOf<Real>& map, Index i) {
    return {map.data() + i * map.cols(), map.cols()};
}

/// 1 where a number is above 0, else 0, in vector instructions as comparisons are not; less than 1 below 1e-300.
[[nodiscard]] auto above_zero(const auto& numbers) { return (numbers.max(0.0) * 1e300).min(1.0); }

/// Numbers of several kinds, one of each per row, from a pass over a map or from an operation within a transform: rows
/// are added in a fixed order, independent of threads and processes. Processes store their own rows, counted from 0,
/// and read together.
template <std::size_t kinds>
class RowSums {
public:
    /// slab outlives the sums.
    explicit RowSums(const parallel::Slab& slab) : slab_(slab), values_(kinds * extent(slab.all())) {}
    void store(Index row, const std::array<double, kinds>& values) {
        for (std::size_t kind = 0; kind < kinds; ++kind)
            values_[kind * extent(slab_.all()) + extent(slab_.first() + row)] = values[kind];
    }
    [[nodiscard]] double sum(std::size_t kind = 0) const { return pairwise_sum(of(kind)); }
    [[nodiscard]] double least(std::size_t kind = 0) const { return of(kind).minCoeff(); }
    [[nodiscard]] double largest(std::size_t kind = 0) const { return of(kind).maxCoeff(); }
    /// Rows of all processes, and the result of one row.
    [[nodiscard]] Index rows() const { return slab_.all(); }
    [[nodiscard]] double at(Index row, std::size_t kind = 0) const { return of(kind)[row]; }

private:
    [[nodiscard]] ConstRow of(std::size_t kind) const {
        double* values = values_.data() + kind * extent(slab_.all());
        if (!shared_[kind]) slab_.share(values);
        shared_[kind] = true;
        return {values, slab_.all()};
    }
    /// Size for most maps on the stack: passes are many and short.
    static constexpr std::size_t on_stack = 1024;
    const parallel::Slab& slab_;
    mutable boost::container::small_vector<double, on_stack> values_;
    mutable std::array<bool, kinds> shared_{};
};

/// Passes over a map row by row, on threads where it is large.
class RowPasses {
public:
    /// For a map of a number of columns, of which this process has the rows of a slab.
    RowPasses(const parallel::Slab& slab, Index columns, parallel::Threads threads)
        : slab_(slab),
          columns_(columns),
          rows_per_task_(std::max<Index>(1, points_per_task / std::max<Index>(1, columns))),
          threads_{slab.rows() * columns < 2 * points_per_task ? 1 : threads.resolved()} {}

    /// Number of points of the whole map.
    [[nodiscard]] double points() const { return static_cast<double>(slab_.all()) * static_cast<double>(columns_); }
    /// For operations within a transform.
    template <std::size_t kinds>
    [[nodiscard]] RowSums<kinds> sums() const {
        return RowSums<kinds>(slab_);
    }

    /// body(row) of every row.
    template <class Body>
    void each(const Body& body) const {
        const Index rows = slab_.rows(), tasks = (rows + rows_per_task_ - 1) / rows_per_task_;
        parallel::for_each_index(static_cast<std::size_t>(tasks), threads_, [&](std::size_t task) {
            const Index first = static_cast<Index>(task) * rows_per_task_;
            for (Index i = first; i < std::min(rows, first + rows_per_task_); ++i) body(i);
        });
    }
    /// Sums of the arrays that body(row) returns for all rows.
    template <std::size_t kinds, class Body>
    [[nodiscard]] RowSums<kinds> numbers(const Body& body) const {
        auto result = sums<kinds>();
        each([&](Index i) { result.store(i, body(i)); });
        return result;
    }
    /// Σ of body(row), a number.
    template <class Body>
    [[nodiscard]] double sum(const Body& body) const {
        return numbers<1>([&](Index i) { return std::array{body(i)}; }).sum();
    }
    template <class Body>
    [[nodiscard]] double largest(const Body& body) const {
        return numbers<1>([&](Index i) { return std::array{body(i)}; }).largest();
    }

private:
    static constexpr Index points_per_task = 1 << 13;
    parallel::Slab slab_;
    Index columns_, rows_per_task_;
    parallel::Threads threads_;
};

}  // namespace setae::half_space
