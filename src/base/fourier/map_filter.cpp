// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/fourier/map_filter.hpp"

#include <algorithm>
#include <atomic>

#include <fmt/format.h>
#include <Eigen/Core>

#include "setae/core/errors.hpp"
#include "setae/core/extent.hpp"
#include "setae/core/summation.hpp"

namespace setae::fourier {
namespace {

/// Adjacent columns of the half spectrum, stored row by row: two cache lines per row of double. A block is read
/// completely when its columns are transformed, and each row is written to as many places as there are blocks.
constexpr Index columns_per_block = 8;
/// Rows per task of a thread.
constexpr Index rows_per_task = 16;
/// Below this number of modes a second thread costs more time than it saves.
constexpr Index modes_for_threads = 128 * 64;

/// Rounded up to a cache line.
template <class Real>
constexpr Index numbers_per_line = 64 / static_cast<Index>(sizeof(ComplexOf<Real>));

Index blocks_of(Index n, Index block) { return (n + block - 1) / block; }

/// Distance of columns of a block: a multiple of cache lines, and never a power of two, or columns would share the same
/// places of the cache. Blocks have the same distance.
template <class Real>
Index stride_for(Index modes) {
    return blocks_of(modes, numbers_per_line<Real>) * numbers_per_line<Real> + numbers_per_line<Real>;
}

Index checked_side(Index points, Index period, const char* side) {
    if (points < 1 || period < points)
        throw InvalidArgument(
            fmt::format("a filter of {} points along {} with a period of {}; expected at least 1 point and a period of "
                        "at least as many",
                        points, side, period));
    return points;
}

const parallel::Slab& checked_rows(const parallel::Slab& rows, Index period) {
    checked_side(rows.all(), period, "x");
    return rows;
}

/// The modes of a row in a block: a few cache lines, for which a call costs more than the copy.
template <class Real>
void copy_piece(const ComplexOf<Real>* from, ComplexOf<Real>* to) {
    using Piece = Eigen::Array<ComplexOf<Real>, columns_per_block, 1>;
    Eigen::Map<Piece>{to} = Eigen::Map<const Piece>{from};
}

/// z(k) T(k) for a whole column: T is even in k.
template <class Real>
void multiply(ComplexOf<Real>* column, Index period, const Real* factors) {
    const Index half = period / 2;
    for (Index k = 0; k <= half; ++k) column[k] *= factors[k];
    for (Index k = half + 1; k < period; ++k) column[k] *= factors[period - k];
}

void transform_along_y(Multiplier& values, parallel::Threads threads) {
    const EvenTransform transform(values.modes_y);
    parallel::for_each_index(extent(blocks_of(values.modes_x, columns_per_block)), threads, [&](std::size_t block) {
        const Index first = static_cast<Index>(block) * columns_per_block,
                    last = std::min(values.modes_x, first + columns_per_block);
        Buffer<double> columns(extent((last - first) * values.modes_y));
        for (Index m = 0; m < values.modes_y; ++m)
            for (Index k = first; k < last; ++k)
                columns[extent((k - first) * values.modes_y + m)] = values.values[extent(m * values.modes_x + k)];
        for (Index k = first; k < last; ++k) transform.apply(columns.data() + (k - first) * values.modes_y);
        for (Index m = 0; m < values.modes_y; ++m)
            for (Index k = first; k < last; ++k)
                values.values[extent(m * values.modes_x + k)] = columns[extent((k - first) * values.modes_y + m)];
    });
}

/// Begins of the blocks of every rank, then the number of blocks.
std::vector<Index> begins_of_blocks(Index blocks, int ranks) {
    std::vector<Index> begins;
    for (Index rank = 0; rank <= ranks; ++rank) begins.push_back(blocks * rank / ranks);
    return begins;
}

std::vector<Index> begins_of_lines(const parallel::Slab& blocks, Index lines) {
    std::vector<Index> begins;
    for (int rank = 0; rank <= blocks.ranks(); ++rank)
        begins.push_back(std::min(lines, blocks.begin(rank) * columns_per_block));
    return begins;
}

template <class Real>
double weighted_power(const ComplexOf<Real>* column, Index period, const Real* factors) {
    double sum = 0.0;
    for (Index k = 0; k < period; ++k) sum += factors[std::min(k, period - k)] * std::norm(column[k]);
    return sum;
}

}  // namespace

template <class Real>
MapFilterOf<Real>::MapFilterOf(const parallel::Slab& rows, Index ny, Index period_x, Index period_y,
                               parallel::Threads threads)
    : rows_(checked_rows(rows, period_x)),
      ny_(checked_side(ny, period_y, "y")),
      modes_y_(period_y / 2 + 1),
      column_stride_(stride_for<Real>(period_x)),
      blocks_(rows.among_same(begins_of_blocks(blocks_of(modes_y_, columns_per_block), rows.ranks()))),
      lines_(rows.among_same(begins_of_lines(blocks_, modes_y_))),
      along_y_(period_y),
      back_along_y_(period_y),
      along_x_(period_x, TransformSign::minus),
      back_along_x_(period_x, TransformSign::plus),
      threads_{rows.rows() * (period_y / 2 + 1) < modes_for_threads ? 1 : threads.resolved()},
      half_(extent(blocks_.all() * (rows.rows() * columns_per_block + numbers_per_line<Real>))),
      rooms_(extent(threads_.count)) {
    for (Room& room : rooms_) {
        room.line.assign(extent(period_y), Real(0));
        room.modes.assign(extent(blocks_of(modes_y_, columns_per_block) * columns_per_block), ComplexOf<Real>{});
        room.columns.resize(extent(columns_per_block * column_stride_));
    }
    if (rows_.in_one_process()) return;
    constexpr Index bytes = sizeof(ComplexOf<Real>);
    column_begins_.push_back(0);
    for (int rank = 0; rank < rows_.ranks(); ++rank) {
        row_begins_.push_back(blocks_.begin(rank) * own_stride() * bytes);
        column_begins_.push_back(column_begins_.back() + blocks_.rows() * block_stride(rank) * bytes);
    }
    row_begins_.push_back(blocks_.all() * own_stride() * bytes);
    columns_.resize(extent(column_begins_.back() / bytes));
}

template <class Real>
Index MapFilterOf<Real>::block_stride(int rank) const {
    return rows_.rows(rank) * columns_per_block + numbers_per_line<Real>;
}

template <class Real>
Index MapFilterOf<Real>::own_stride() const {
    return rows_.rows() * columns_per_block + numbers_per_line<Real>;
}

template <class Real>
void MapFilterOf<Real>::with_rooms(Index tasks, const std::function<void(Index, Room&)>& body) {
    std::atomic<Index> next{0};
    parallel::for_each_index(rooms_.size(), threads_, [&](std::size_t worker) {
        for (Index task = next.fetch_add(1); task < tasks; task = next.fetch_add(1)) body(task, rooms_[worker]);
    });
}

template <class Real>
MultiplierOf<Real> MapFilterOf<Real>::multiplier(const std::function<double(Index, Index)>& factor) const {
    MultiplierOf<Real> result{
        .modes_x = period_x() / 2 + 1, .modes_y = period_y() / 2 + 1, .first_line = lines_.first(), .values = {}};
    result.values.resize(extent(result.modes_x * lines_.rows()));
    const double points = static_cast<double>(period_x()) * static_cast<double>(period_y());
    parallel::for_each_index(extent(lines_.rows()), threads_, [&](std::size_t own) {
        const Index m = result.first_line + static_cast<Index>(own);
        Real* line = result.values.data() + static_cast<Index>(own) * result.modes_x;
        for (Index k = 0; k < result.modes_x; ++k) line[k] = static_cast<Real>(factor(k, m) / points);
    });
    return result;
}

template <class Real>
MultiplierOf<Real> MapFilterOf<Real>::kernel_multiplier(const std::function<double(Index, Index)>& kernel,
                                                        KernelAxes along) const
    requires std::same_as<Real, double>
{
    const auto require_even = [](Index period, const char* axis) {
        if (period % 2 != 0)
            throw InvalidArgument(
                fmt::format("a kernel along {} needs an even period, but the filter has {} points", axis, period));
    };
    if (!rows_.in_one_process())
        throw InvalidArgument(
            "a kernel is given for a map that is divided between processes; expected factors of modes");
    MultiplierOf<Real> result = multiplier(kernel);
    if (along != KernelAxes::y) {
        require_even(period_x(), "x");
        const EvenTransform transform(result.modes_x);
        parallel::for_each_index(extent(result.modes_y), threads_, [&](std::size_t m) {
            transform.apply(result.values.data() + static_cast<Index>(m) * result.modes_x);
        });
    }
    if (along != KernelAxes::x) {
        require_even(period_y(), "y");
        transform_along_y(result, threads_);
    }
    return result;
}

template <class Real>
ComplexOf<Real>* MapFilterOf<Real>::block(Index index) {
    return half_.data() + index * own_stride();
}

template <class Real>
ComplexOf<Real>* MapFilterOf<Real>::piece(int rank, Index index) {
    if (rows_.in_one_process()) return block(index);
    constexpr Index bytes = sizeof(ComplexOf<Real>);
    return columns_.data() + column_begins_[extent(rank)] / bytes + (index - blocks_.first()) * block_stride(rank);
}

template <class Real>
void MapFilterOf<Real>::hand_on() {
    if (!rows_.in_one_process()) rows_.exchange(half_.data(), row_begins_, columns_.data(), column_begins_);
}

template <class Real>
void MapFilterOf<Real>::hand_back() {
    if (!rows_.in_one_process()) rows_.exchange(columns_.data(), column_begins_, half_.data(), row_begins_);
}

template <class Real>
void MapFilterOf<Real>::forward_rows(const LoadRowOf<Real>& load) {
    const Index rows = rows_.rows();
    with_rooms(blocks_of(rows, rows_per_task), [&](Index task, Room& room) {
        std::fill(room.line.begin() + ny_, room.line.end(), Real(0));
        const Index first = task * rows_per_task, blocks = blocks_of(modes_y_, columns_per_block);
        for (Index i = first; i < std::min(rows, first + rows_per_task); ++i) {
            load(i, room.line.data());
            along_y_.forward(room.line.data(), room.modes.data());
            for (Index b = 0; b < blocks; ++b)
                copy_piece(room.modes.data() + b * columns_per_block, block(b) + i * columns_per_block);
        }
    });
}

template <class Real>
void MapFilterOf<Real>::gather(Index index, ComplexOf<Real>* columns) {
    for (int rank = 0; rank < rows_.ranks(); ++rank) {
        const ComplexOf<Real>* from = piece(rank, index);
        ComplexOf<Real>* to = columns + rows_.begin(rank);
        for (Index i = 0; i < rows_.rows(rank); ++i)
            for (Index m = 0; m < columns_per_block; ++m) to[m * column_stride_ + i] = from[i * columns_per_block + m];
    }
    for (Index m = 0; m < columns_per_block; ++m)
        std::fill(columns + m * column_stride_ + rows_.all(), columns + m * column_stride_ + period_x(),
                  ComplexOf<Real>{});
}

template <class Real>
void MapFilterOf<Real>::scatter(Index index, const ComplexOf<Real>* columns) {
    for (int rank = 0; rank < rows_.ranks(); ++rank) {
        ComplexOf<Real>* to = piece(rank, index);
        const ComplexOf<Real>* from = columns + rows_.begin(rank);
        for (Index i = 0; i < rows_.rows(rank); ++i)
            for (Index m = 0; m < columns_per_block; ++m) to[i * columns_per_block + m] = from[m * column_stride_ + i];
    }
}

template <class Real>
template <class Visit>
void MapFilterOf<Real>::each_column(Index block, Room& room, const Visit& visit) {
    const Index first = block * columns_per_block, lines = std::min(columns_per_block, modes_y_ - first);
    gather(block, room.columns.data());
    for (Index m = 0; m < lines; ++m) {
        ComplexOf<Real>* column = room.columns.data() + m * column_stride_;
        along_x_.apply(column);
        visit(column, first + m);
    }
}

template <class Real>
void MapFilterOf<Real>::apply(const MultiplierOf<Real>& multiplier, const LoadRowOf<Real>& load,
                              const StoreRowOf<Real>& store) {
    forward_rows(load);
    hand_on();
    with_rooms(blocks_.rows(), [&](Index own, Room& room) {
        const Index block = blocks_.first() + own;
        each_column(block, room, [&](ComplexOf<Real>* column, Index line) {
            multiply(column, period_x(), multiplier.line(line));
            back_along_x_.apply(column);
        });
        scatter(block, room.columns.data());
    });
    hand_back();
    const Index rows = rows_.rows();
    with_rooms(blocks_of(rows, rows_per_task), [&](Index task, Room& room) {
        const Index first = task * rows_per_task, blocks = blocks_of(modes_y_, columns_per_block);
        for (Index i = first; i < std::min(rows, first + rows_per_task); ++i) {
            for (Index b = 0; b < blocks; ++b)
                copy_piece(block(b) + i * columns_per_block, room.modes.data() + b * columns_per_block);
            back_along_y_.apply(room.modes.data(), room.line.data());
            store(i, room.line.data());
        }
    });
}

template <class Real>
double MapFilterOf<Real>::quadratic_form(const MultiplierOf<Real>& multiplier, const LoadRowOf<Real>& load) {
    forward_rows(load);
    hand_on();
    Array1D sums(multiplier.modes_y);
    with_rooms(blocks_.rows(), [&](Index own, Room& room) {
        each_column(blocks_.first() + own, room, [&](const ComplexOf<Real>* column, Index line) {
            const bool twice = line > 0 && 2 * line != period_y();  // the other half of the spectrum
            sums[line] = (twice ? 2.0 : 1.0) * weighted_power(column, period_x(), multiplier.line(line));
        });
    });
    lines_.share(sums.data());
    return pairwise_sum(sums);
}

template class MapFilterOf<double>;
template class MapFilterOf<float>;

}  // namespace setae::fourier
