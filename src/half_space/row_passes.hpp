// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

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

/// Numbers of several kinds, one of each a row, from a pass over a map or from what rides along with a transform: rows
/// are added in an order of their own, whatever thread they came from.
template <std::size_t kinds>
class RowSums {
public:
    explicit RowSums(Index rows) : rows_(static_cast<Index>(kinds), rows) {}
    void store(Index row, const std::array<double, kinds>& values) {
        for (std::size_t kind = 0; kind < kinds; ++kind) rows_(static_cast<Index>(kind), row) = values[kind];
    }
    [[nodiscard]] double sum(std::size_t kind = 0) const {
        return pairwise_sum(rows_.row(static_cast<Index>(kind)).transpose());
    }
    [[nodiscard]] double least(std::size_t kind = 0) const { return rows_.row(static_cast<Index>(kind)).minCoeff(); }
    [[nodiscard]] double largest(std::size_t kind = 0) const { return rows_.row(static_cast<Index>(kind)).maxCoeff(); }

private:
    Array2D rows_;
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
