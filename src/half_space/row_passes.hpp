// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include <boost/container/small_vector.hpp>

#include "setae/core/arrays.hpp"
#include "setae/core/summation.hpp"
#include "setae/parallel/for_each.hpp"

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

/// Numbers of several kinds, one of each a row, from a pass over a map or from what rides along with a transform: rows
/// are added in an order of their own, whatever thread they came from.
template <std::size_t kinds>
class RowSums {
public:
    explicit RowSums(Index rows) : rows_(rows), values_(kinds * static_cast<std::size_t>(rows)) {}
    void store(Index row, const std::array<double, kinds>& values) {
        for (std::size_t kind = 0; kind < kinds; ++kind)
            values_[kind * static_cast<std::size_t>(rows_) + static_cast<std::size_t>(row)] = values[kind];
    }
    [[nodiscard]] double sum(std::size_t kind = 0) const { return pairwise_sum(of(kind)); }
    [[nodiscard]] double least(std::size_t kind = 0) const { return of(kind).minCoeff(); }
    [[nodiscard]] double largest(std::size_t kind = 0) const { return of(kind).maxCoeff(); }

private:
    [[nodiscard]] ConstRow of(std::size_t kind) const {
        return {values_.data() + kind * static_cast<std::size_t>(rows_), rows_};
    }
    /// Of most maps on the stack: passes are many and short.
    static constexpr std::size_t on_stack = 1024;
    Index rows_;
    boost::container::small_vector<double, on_stack> values_;
};

/// Passes over a map row by row, on threads where it is large.
class RowPasses {
public:
    RowPasses(const Array2D& shape, parallel::Threads threads)
        : rows_(shape.rows()),
          rows_per_task_(std::max<Index>(1, points_per_task / std::max<Index>(1, shape.cols()))),
          threads_{shape.size() < 2 * points_per_task ? 1 : threads.resolved()} {}

    /// body(row) of every row.
    template <class Body>
    void each(const Body& body) const {
        const Index tasks = (rows_ + rows_per_task_ - 1) / rows_per_task_;
        parallel::for_each_index(static_cast<std::size_t>(tasks), threads_, [&](std::size_t task) {
            const Index first = static_cast<Index>(task) * rows_per_task_;
            for (Index i = first; i < std::min(rows_, first + rows_per_task_); ++i) body(i);
        });
    }
    /// What body(row), an array of that many numbers, says of every row.
    template <std::size_t kinds, class Body>
    [[nodiscard]] RowSums<kinds> numbers(const Body& body) const {
        RowSums<kinds> result(rows_);
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
    Index rows_, rows_per_task_;
    parallel::Threads threads_;
};

}  // namespace setae::half_space
