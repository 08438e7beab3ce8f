// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <vector>

#include "setae/core/arrays.hpp"
#include "setae/parallel/for_each.hpp"

namespace setae::numerics {

/// Rows of a map in blocks of about 2^16 points. Blocks depend only on the shape of the map, so sums in block order are
/// the same for any number of threads.
struct RowBlocks {
    Index rows = 0;
    Index rows_per_block = 1;

    RowBlocks(Index row_count, Index points_per_row)
        : rows(row_count), rows_per_block(std::max<Index>(1, (Index{1} << 16) / std::max<Index>(1, points_per_row))) {}

    [[nodiscard]] Index count() const { return (rows + rows_per_block - 1) / rows_per_block; }
    [[nodiscard]] Index first(Index block) const { return block * rows_per_block; }
    [[nodiscard]] Index last(Index block) const { return std::min(rows, first(block) + rows_per_block); }
};

/// body(first, last, result) for the rows of every block; the results in block order.
template <class Result, class Body>
std::vector<Result> by_row_blocks(const RowBlocks& blocks, parallel::Threads threads, const Result& start,
                                  const Body& body) {
    std::vector<Result> results(static_cast<std::size_t>(blocks.count()), start);
    parallel::for_each_index(results.size(), threads, [&](std::size_t b) {
        const auto block = static_cast<Index>(b);
        body(blocks.first(block), blocks.last(block), results[b]);
    });
    return results;
}

/// body(row) for every row.
template <class Body>
void for_each_row(Index rows, Index points_per_row, parallel::Threads threads, const Body& body) {
    const RowBlocks blocks(rows, points_per_row);
    parallel::for_each_index(static_cast<std::size_t>(blocks.count()), threads, [&](std::size_t b) {
        const auto block = static_cast<Index>(b);
        for (Index row = blocks.first(block); row < blocks.last(block); ++row) body(row);
    });
}

}  // namespace setae::numerics
