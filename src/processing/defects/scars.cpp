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
#include "setae/numerics/row_blocks.hpp"

namespace setae::processing {
namespace {

using numerics::by_row_blocks;
using numerics::for_each_row;
using numerics::RowBlocks;

using topography::HeightMap;
using topography::Mask;

constexpr std::uint8_t beside = 1;  // stands out enough to belong to a scar
constexpr std::uint8_t scar = 2;

void require_domain(const RemoveScars& step) {
    if (!(step.low > 0.0 && step.high >= step.low && std::isfinite(step.high)))
        throw InvalidArgument(
            fmt::format("thresholds of scars low {} and high {}; expected 0 < low <= high", step.low, step.high));
    if (step.length < 1 || step.width < 1)
        throw InvalidArgument(
            fmt::format("scars of length {} and width {} points; expected numbers >= 1", step.length, step.width));
}

/// Rms of the differences of neighbouring scan lines; 0 where there are none.
double rms_difference(const HeightMap& map, parallel::Threads threads) {
    struct Sum {
        double squares = 0.0, count = 0.0;
    };
    Sum all;
    const Index ny = map.heights.cols();
    for (const auto& part :
         by_row_blocks(RowBlocks(map.heights.rows(), ny), threads, Sum{}, [&](Index first, Index last, Sum& sum) {
             for (Index i = first; i < last; ++i) {
                 const double* const row = map.heights.data() + i * ny;
                 for (Index j = 0; j + 1 < ny; ++j) {
                     const double difference = row[j + 1] - row[j];
                     if (difference != difference) continue;
                     sum.squares += difference * difference;
                     sum.count += 1.0;
                 }
             }
         })) {
        all.squares += part.squares;
        all.count += part.count;
    }
    return all.count > 0.0 ? std::sqrt(all.squares / all.count) : 0.0;
}

/// Marks the runs of one row along y that stand out of the points that end them; sign −1 looks at valleys. Whether
/// there are some.
bool mark_row(const double* heights, Index n, Index width, double low, double high, double sign, std::uint8_t* marks) {
    bool marked = false;
    for (Index start = 0; start + 2 < n; ++start) {
        if (!(sign * (heights[start + 1] - heights[start]) >= low)) continue;
        const double before = sign * heights[start];
        double least = sign * heights[start + 1], base_of_run = undefined;
        Index run = 0;  // the longest one that stands out
        for (Index k = 1; k <= width && start + k + 1 < n; ++k) {
            least = std::min(least, sign * heights[start + k]);
            if (!(sign * heights[start + k] - before >= low)) break;  // the run has come down, or is undefined
            const double behind = sign * heights[start + k + 1], base = std::max(before, behind);
            if (behind != behind || !(least - base >= low)) continue;
            run = k;
            base_of_run = base;
        }
        for (Index m = start + 1; m <= start + run; ++m)
            marks[m] = std::max(marks[m], sign * heights[m] - base_of_run >= high ? scar : beside);
        marked = marked || run > 0;
    }
    return marked;
}

/// Marks of a map, and which rows have some.
struct Marks {
    Mask points;
    std::vector<std::uint8_t> in_row;

    [[nodiscard]] bool any(Index i) const { return in_row[static_cast<std::size_t>(i)] != 0; }
};

/// Points beside a scar along x belong to it.
void spread_along_x(Marks& marks) {
    auto& points = marks.points;
    const auto join = [&](Index from, Index to) {
        if (!marks.any(from) || !marks.any(to)) return;
        for (Index j = 0; j < points.cols(); ++j)
            if (points(from, j) == scar && points(to, j) == beside) points(to, j) = scar;
    };
    for (Index i = 1; i < points.rows(); ++i) join(i - 1, i);
    for (Index i = points.rows() - 1; i > 0; --i) join(i, i - 1);
}

/// Keeps runs of scars along x that are long enough, as 1; everything else becomes 0.
void keep_long(Marks& marks, Index length) {
    auto& points = marks.points;
    std::vector<Index> run(static_cast<std::size_t>(points.cols()), 0);
    const auto end = [&](Index behind, Index j) {
        auto& in_run = run[static_cast<std::size_t>(j)];
        if (in_run < length)
            for (Index i = behind - in_run; i < behind; ++i) points(i, j) = 0;
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

Mask scars_of_sign(const RemoveScars& step, const HeightMap& map, double difference, double sign,
                   parallel::Threads threads) {
    const auto [nx, ny] = map.shape();
    Marks marks{Mask::Zero(nx, ny), std::vector<std::uint8_t>(static_cast<std::size_t>(nx))};
    for_each_row(nx, ny, threads, [&, columns = ny](Index i) {
        marks.in_row[static_cast<std::size_t>(i)] =
            mark_row(map.heights.data() + i * columns, columns, step.width, step.low * difference,
                     step.high * difference, sign, marks.points.data() + i * columns);
    });
    spread_along_x(marks);
    keep_long(marks, step.length);
    return std::move(marks.points);
}

/// New heights of one row's scars, from the nearest points before and behind that are none.
void fill_row(double* heights, const std::uint8_t* marks, Index n, ScarReplacement replacement) {
    for (Index j = 0; j < n; ++j) {
        if (!marks[j]) continue;
        Index end = j;
        while (end < n && (marks[end] || heights[end] != heights[end])) ++end;
        Index begin = j - 1;
        while (begin >= 0 && heights[begin] != heights[begin]) --begin;
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

Mask find_scars(const RemoveScars& step, const HeightMap& map, parallel::Threads threads) {
    require_domain(step);
    const double difference = rms_difference(map, threads);
    if (difference == 0.0) return Mask::Zero(map.heights.rows(), map.heights.cols());
    if (step.sign != ScarSign::both)
        return scars_of_sign(step, map, difference, step.sign == ScarSign::positive ? 1.0 : -1.0, threads);
    return scars_of_sign(step, map, difference, 1.0, threads).max(scars_of_sign(step, map, difference, -1.0, threads));
}

Processed apply(const RemoveScars& step, topography::Measurement measurement, parallel::Threads threads) {
    auto* map = std::get_if<HeightMap>(&measurement);
    if (!map)
        refuse_line(step_name(step), measurement,
                    "scars are strokes across several scan lines: take spikes of a line out with despike");
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
