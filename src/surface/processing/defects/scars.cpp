// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/processing/scars.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "pipeline/step_record.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/extent.hpp"
#include "setae/numerics/row_blocks.hpp"

namespace setae::processing {
namespace {

using numerics::for_each_row;

using topography::HeightMap;
using topography::Mask;

constexpr std::uint8_t near_scar = 1;  // differs enough to belong to a scar
constexpr std::uint8_t scar = 2;

void require_domain(const RemoveScars& step) {
    if (!(step.low > 0.0 && step.high >= step.low && std::isfinite(step.high)))
        throw InvalidArgument(
            fmt::format("thresholds of scars low {} and high {}; expected 0 < low <= high", step.low, step.high));
    if (step.length < 1 || step.width < 1)
        throw InvalidArgument(
            fmt::format("scars of length {} and width {} points; expected numbers >= 1", step.length, step.width));
}

/// body(first, last, values, result) for the rows of every block; the results in block order.
template <class Result, class Body>
std::vector<Result> by_blocks(const RowsOfHeights& map, parallel::Threads threads, const Result& start,
                              const Body& body) {
    return numerics::by_row_blocks(numerics::RowBlocks(map.rows, map.columns), threads, start,
                                   [&](Index first, Index last, Result& result) {
                                       Array1D room((last - first) * map.columns);
                                       body(first, last, map.rows_of(first, last, room.data()), result);
                                   });
}

/// Rms of the differences of neighbouring scan lines; 0 if there are none.
double rms_difference(const RowsOfHeights& map, parallel::Threads threads) {
    struct Sum {
        double squares = 0.0, count = 0.0;
    };
    Sum all;
    const Index ny = map.columns;
    for (const auto& part :
         by_blocks(map, threads, Sum{}, [&](Index first, Index last, const double* heights, Sum& sum) {
             for (Index i = first; i < last; ++i) {
                 const double* const row = heights + (i - first) * ny;
                 for (Index j = 0; j + 1 < ny; ++j) {
                     const double difference = row[j + 1] - row[j];
                     const bool defined = !std::isnan(difference);
                     sum.squares += defined ? difference * difference : 0.0;
                     sum.count += defined ? 1.0 : 0.0;
                 }
             }
         })) {
        all.squares += part.squares;
        all.count += part.count;
    }
    return all.count > 0.0 ? std::sqrt(all.squares / all.count) : 0.0;
}

/// Marks the runs of one row along y that differ from the points at both ends; sign −1 for valleys. Returns whether
/// there are any.
bool mark_row(const double* heights, Index n, Index width, double low, double high, double sign, std::uint8_t* marks) {
    bool marked = false;
    for (Index start = 0; start + 2 < n; ++start) {
        if (!(sign * (heights[start + 1] - heights[start]) >= low)) continue;
        const double before = sign * heights[start];
        double least = sign * heights[start + 1], base_of_run = undefined;
        Index run = 0;  // the longest significant one
        for (Index k = 1; k <= width && start + k + 1 < n; ++k) {
            least = std::min(least, sign * heights[start + k]);
            if (!(sign * heights[start + k] - before >= low)) break;  // the run ends, or is undefined
            const double after = sign * heights[start + k + 1], base = std::max(before, after);
            if (std::isnan(after) || !(least - base >= low)) continue;
            run = k;
            base_of_run = base;
        }
        for (Index m = start + 1; m <= start + run; ++m)
            marks[m] = std::max(marks[m], sign * heights[m] - base_of_run >= high ? scar : near_scar);
        marked = marked || run > 0;
    }
    return marked;
}

/// Marks of a map, and the rows with marks.
struct Marks {
    Mask points;
    std::vector<std::uint8_t> in_row;

    [[nodiscard]] bool any(Index i) const { return in_row[static_cast<std::size_t>(i)] != 0; }
};

/// Points next to a scar along x belong to it.
void spread_along_x(Marks& marks) {
    auto& points = marks.points;
    const auto join = [&](Index from, Index to) {
        if (!marks.any(from) || !marks.any(to)) return;
        for (Index j = 0; j < points.cols(); ++j)
            if (points(from, j) == scar && points(to, j) == near_scar) points(to, j) = scar;
    };
    for (Index i = 1; i < points.rows(); ++i) join(i - 1, i);
    for (Index i = points.rows() - 1; i > 0; --i) join(i, i - 1);
}

/// Keeps sufficiently long runs of scars along x, as 1; everything else becomes 0.
void keep_long(Marks& marks, Index length) {
    auto& points = marks.points;
    std::vector<Index> run(static_cast<std::size_t>(points.cols()), 0);
    const auto end = [&](Index after, Index j) {
        auto& in_run = run[static_cast<std::size_t>(j)];
        if (in_run < length)
            for (Index i = after - in_run; i < after; ++i) points(i, j) = 0;
        in_run = 0;
    };
    for (Index i = 0; i < points.rows(); ++i) {
        if (!marks.any(i) && (i == 0 || !marks.any(i - 1))) continue;
        for (Index j = 0; j < points.cols(); ++j) {
            const bool in_scar = points(i, j) == scar;
            points(i, j) = in_scar ? 1 : 0;
            if (in_scar) ++run[static_cast<std::size_t>(j)];
            else end(i, j);
        }
    }
    for (Index j = 0; j < points.cols(); ++j) end(points.rows(), j);
}

std::vector<double> signs_of(ScarSign sign) {
    if (sign == ScarSign::both) return {1.0, -1.0};
    return {sign == ScarSign::positive ? 1.0 : -1.0};
}

/// Marks of each sign, for points that differ within their rows.
std::vector<Marks> marks_of_rows(const RemoveScars& step, const RowsOfHeights& map, double difference,
                                 parallel::Threads threads) {
    const auto signs = signs_of(step.sign);
    const Index ny = map.columns;
    std::vector<Marks> marks(signs.size(), {Mask::Zero(map.rows, ny), std::vector<std::uint8_t>(extent(map.rows))});
    struct Nothing {};
    by_blocks(map, threads, Nothing{}, [&](Index first, Index last, const double* heights, Nothing&) {
        for (Index i = first; i < last; ++i)
            for (std::size_t s = 0; s < signs.size(); ++s)
                marks[s].in_row[extent(i)] =
                    mark_row(heights + (i - first) * ny, ny, step.width, step.low * difference, step.high * difference,
                             signs[s], marks[s].points.data() + i * ny);
    });
    return marks;
}

/// New heights for the scars of one row, from the nearest points before and after without scar.
void fill_row(double* heights, const std::uint8_t* marks, Index n, ScarReplacement replacement) {
    for (Index j = 0; j < n; ++j) {
        if (!marks[j]) continue;
        Index end = j;
        while (end < n && (marks[end] || std::isnan(heights[end]))) ++end;
        Index begin = j - 1;
        while (begin >= 0 && std::isnan(heights[begin])) --begin;
        for (Index k = j; k < end; ++k) {
            if (!marks[k]) continue;
            if (replacement == ScarReplacement::undefined || (begin < 0 && end == n)) heights[k] = undefined;
            else if (begin < 0) heights[k] = heights[end];
            else if (end == n) heights[k] = heights[begin];
            else
                heights[k] = heights[begin] + (heights[end] - heights[begin]) * static_cast<double>(k - begin) /
                                                  static_cast<double>(end - begin);
        }
        j = end - 1;
    }
}

/// Strokes: runs along x.
Index strokes(const Mask& marks) {
    Index count = 0;
    for (Index i = 0; i < marks.rows(); ++i)
        for (Index j = 0; j < marks.cols(); ++j) count += marks(i, j) && (i == 0 || !marks(i - 1, j));
    return count;
}

}  // namespace

Mask find_scars(const RemoveScars& step, const RowsOfHeights& map, parallel::Threads threads) {
    require_domain(step);
    const double difference = rms_difference(map, threads);
    if (difference == 0.0) return Mask::Zero(map.rows, map.columns);
    auto marks = marks_of_rows(step, map, difference, threads);
    for (auto& of_sign : marks) {
        spread_along_x(of_sign);
        keep_long(of_sign, step.length);
    }
    auto& points = marks.front().points;
    if (marks.size() > 1) points = points.max(marks.back().points);
    return std::move(points);
}

Mask find_scars(const RemoveScars& step, const HeightMap& map, parallel::Threads threads) {
    const auto [nx, ny] = map.shape();
    return find_scars(step,
                      RowsOfHeights{nx, ny,
                                    [&heights = map.heights](Index first, Index, double*) {
                                        return heights.data() + first * heights.cols();
                                    }},
                      threads);
}

Processed apply(const RemoveScars& step, topography::Measurement measurement, parallel::Threads threads) {
    auto* map = std::get_if<HeightMap>(&measurement);
    if (!map)
        refuse_line(step_name(step), measurement,
                    "remove_scars needs a map, since scars are strokes across several scan lines; remove spikes of "
                    "a single line with despike");
    const auto marks = find_scars(step, *map, threads);
    const auto [nx, ny] = map->shape();
    for_each_row(nx, ny, threads, [&, columns = ny](Index i) {
        fill_row(map->heights.data() + i * columns, marks.data() + i * columns, columns, step.replace_by);
    });
    StepRecord record{std::string(step_name(step)), {}, {}};
    record.numbers = {recorded_count("strokes", strokes(marks)), recorded_count("scar_points", (marks != 0).count())};
    return {std::move(measurement), std::move(record)};
}

}  // namespace setae::processing
