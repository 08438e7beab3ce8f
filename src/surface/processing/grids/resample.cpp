// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/processing/resample.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/core/extent.hpp"
#include "setae/processing/interpolation.hpp"

namespace setae::processing {
namespace {

using topography::HeightMap;
using topography::LineScan;
using topography::Profile;

/// New points of a direction.
struct Points {
    Index count;
    double step;
    double size;
};

void require_valid(const Resample& grid, const topography::Metadata& metadata) {
    if (grid.nx < 0 || grid.ny < 0 || (grid.nx == 0 && !grid.pixel_size))
        throw InvalidArgument(
            fmt::format("{}: resampling to {} x {} points without a pixel size; expected nx or pixel_size",
                        topography::label(metadata), grid.nx, grid.ny));
    if (grid.pixel_size && (!(*grid.pixel_size > 0.0) || !std::isfinite(*grid.pixel_size)))
        throw InvalidArgument(fmt::format("{}: resampling to pixels of {} m; expected a positive size",
                                          topography::label(metadata), *grid.pixel_size));
    if (grid.pixel_size && grid.nx + grid.ny > 0)
        throw InvalidArgument(
            fmt::format("{}: resampling to {} x {} points and to pixels of {} m; expected one of both",
                        topography::label(metadata), grid.nx, grid.ny, *grid.pixel_size));
}

/// @throws InvalidArgument for more points along a direction than any map has.
Index point_count(double count, double old_count, const topography::Metadata& metadata) {
    constexpr double greatest = 2147483648.0;
    if (count > greatest)
        throw InvalidArgument(fmt::format("{}: resampling {:g} points to {:g} along a direction; expected at most {:g}",
                                          topography::label(metadata), old_count, count, greatest));
    return static_cast<Index>(count);
}

/// `requested`: number of points, or 0 for the pixel size of the grid. Open: from the first to the last of the old
/// points.
Points points_of(const Resample& grid, Index requested, Index old_count, double size, bool open,
                 const topography::Metadata& metadata) {
    const double old_step = size / static_cast<double>(old_count);
    const auto counted = [&](double count) { return point_count(count, static_cast<double>(old_count), metadata); };
    Points points{counted(static_cast<double>(requested)), 0.0, size};
    if (open) {
        const double length = old_step * static_cast<double>(old_count - 1);
        if (requested == 0) points.count = counted(std::floor(length / *grid.pixel_size * (1.0 + 1e-12))) + 1;
        points.step =
            requested == 0 ? *grid.pixel_size : length / static_cast<double>(std::max<Index>(1, requested - 1));
        points.size = points.step * static_cast<double>(points.count);
    } else {
        if (requested == 0) points.count = counted(std::round(size / *grid.pixel_size));
        points.step = size / static_cast<double>(points.count);
    }
    if (points.count < 2 || (open && old_count < 2))
        throw InvalidArgument(
            fmt::format("{}: resampling {} points to {} along a direction; expected at least 2 for both",
                        topography::label(metadata), old_count, points.count));
    return points;
}

/// Contribution of old pixels to new ones along a direction: overlaps in old pixels.
struct Overlaps {
    std::vector<Index> first;
    std::vector<std::vector<double>> shares;

    Overlaps(Index old_count, Index new_count) {
        const double ratio = static_cast<double>(old_count) / static_cast<double>(new_count);
        for (Index i = 0; i < new_count; ++i) {
            const double begin = ratio * static_cast<double>(i), end = ratio * static_cast<double>(i + 1);
            first.push_back(std::min(old_count - 1, static_cast<Index>(std::floor(begin))));
            shares.emplace_back();
            for (Index j = first.back(); j < old_count; ++j) {
                const double share =
                    std::min(end, static_cast<double>(j + 1)) - std::max(begin, static_cast<double>(j));
                if (!(share > 1e-12) && j > first.back()) break;
                shares.back().push_back(std::max(0.0, share));
            }
        }
    }
};

Array2D averaged(const Array2D& heights, Index nx, Index ny, parallel::Threads threads) {
    const Overlaps along_x(heights.rows(), nx), along_y(heights.cols(), ny);
    const double whole = static_cast<double>(heights.rows()) / static_cast<double>(nx) *
                         (static_cast<double>(heights.cols()) / static_cast<double>(ny));
    Array2D result(nx, ny);
    parallel::for_each_index(extent(nx), threads, [&](std::size_t row) {
        Array1D sums = Array1D::Zero(ny), areas = Array1D::Zero(ny);
        for (std::size_t a = 0; a < along_x.shares[row].size(); ++a) {
            const double* old_row = &heights(along_x.first[row] + static_cast<Index>(a), 0);
            for (Index j = 0; j < ny; ++j) {
                const auto& shares = along_y.shares[extent(j)];
                const double* old = old_row + along_y.first[extent(j)];
                for (std::size_t b = 0; b < shares.size(); ++b) {
                    if (std::isnan(old[b])) continue;
                    const double area = along_x.shares[row][a] * shares[b];
                    sums[j] += area * old[b];
                    areas[j] += area;
                }
            }
        }
        const double least = 0.5 * whole * (1.0 - 1e-12);
        result.row(static_cast<Index>(row)) =
            (areas >= least && areas > 0.0).select(sums / areas, std::numeric_limits<double>::quiet_NaN()).transpose();
    });
    return result;
}

template <class Interpolator>
void fill_from(const Interpolator& height, Array2D& heights, const Points& x, const Points& y,
               parallel::Threads threads) {
    parallel::for_each_index(extent(heights.rows()), threads, [&](std::size_t row) {
        const auto i = static_cast<Index>(row);
        for (Index j = 0; j < heights.cols(); ++j)
            heights(i, j) = height(static_cast<double>(i) * x.step, static_cast<double>(j) * y.step);
    });
}

template <class Interpolator>
void fill_from(const Interpolator& height, Array1D& heights, const Points& x) {
    for (Index i = 0; i < heights.size(); ++i) heights[i] = height(static_cast<double>(i) * x.step);
}

StepRecord record_of(const Resample& step, const topography::Measurement& measurement) {
    StepRecord record{.step = std::string(step_name(step))};
    const auto shape = topography::shape(measurement);
    record.numbers.push_back({.quantity = "points_x",
                              .symbol = "n_x",
                              .estimate = {.value = static_cast<double>(shape[0]), .standard_error = 0.0},
                              .unit = "1"});
    if (std::holds_alternative<HeightMap>(measurement))
        record.numbers.push_back({.quantity = "points_y",
                                  .symbol = "n_y",
                                  .estimate = {.value = static_cast<double>(shape[1]), .standard_error = 0.0},
                                  .unit = "1"});
    return record;
}

}  // namespace

HeightMap resampled(const HeightMap& map, const Resample& grid, parallel::Threads threads) {
    require_valid(grid, map.metadata);
    const Index old_nx = map.heights.rows(), old_ny = map.heights.cols();
    const Index nx = grid.nx, ny = grid.ny > 0 || grid.pixel_size
                                       ? grid.ny
                                       : static_cast<Index>(std::llround(static_cast<double>(nx * old_ny) /
                                                                         static_cast<double>(old_nx)));
    const bool open = !map.periodic && grid.method != Resampling::average;
    const Points x = points_of(grid, nx, old_nx, map.size[0], open, map.metadata),
                 y = points_of(grid, ny, old_ny, map.size[1], open, map.metadata);
    if (grid.method == Resampling::fourier) return fourier_interpolated(map, x.count, y.count, threads);
    HeightMap result{Array2D(x.count, y.count), {x.size, y.size}, map.periodic, map.metadata};
    if (grid.method == Resampling::average) result.heights = averaged(map.heights, x.count, y.count, threads);
    else if (grid.method == Resampling::linear) fill_from(LinearInterpolator(map), result.heights, x, y, threads);
    else fill_from(BicubicInterpolator(map, threads), result.heights, x, y, threads);
    return result;
}

LineScan resampled(const LineScan& scan, const Resample& grid, parallel::Threads threads) {
    require_valid(grid, scan.metadata);
    const bool open = !scan.periodic && grid.method != Resampling::average;
    const Points x = points_of(grid, grid.nx, scan.heights.size(), scan.size, open, scan.metadata);
    if (grid.method == Resampling::fourier) return fourier_interpolated(scan, x.count);
    LineScan result{Array1D(x.count), x.size, scan.periodic, scan.metadata};
    if (grid.method == Resampling::average) {
        const Array2D row = scan.heights.transpose();
        result.heights = averaged(row, 1, x.count, threads).row(0).transpose();
    } else if (grid.method == Resampling::linear) {
        fill_from(LinearLineInterpolator(scan), result.heights, x);
    } else {
        fill_from(CubicLineInterpolator(scan), result.heights, x);
    }
    return result;
}

LineScan resampled(const Profile& profile, const Resample& grid) {
    require_valid(grid, profile.metadata);
    if (grid.method != Resampling::linear)
        throw InvalidArgument(fmt::format(
            "{}: a polyline of {} points can be resampled only along its straight segments; expected method "
            "linear",
            topography::label(profile.metadata), profile.positions.size()));
    const double length = profile.size();
    Index count = grid.nx;
    if (count == 0) count = static_cast<Index>(std::floor(length / *grid.pixel_size * (1.0 + 1e-12))) + 1;
    if (count < 2)
        throw InvalidArgument(fmt::format("{}: resampling leaves {} point; expected at least 2",
                                          topography::label(profile.metadata), count));
    const double step = grid.pixel_size ? *grid.pixel_size : length / static_cast<double>(count - 1);
    LineScan result{Array1D(count), step * static_cast<double>(count), false, profile.metadata};
    const Index last = profile.positions.size() - 2;
    for (Index i = 0, segment = 0; i < count; ++i) {
        const double x = profile.positions[0] + std::min(length, static_cast<double>(i) * step);
        while (segment < last && profile.positions[segment + 1] < x) ++segment;
        const double t =
            (x - profile.positions[segment]) / (profile.positions[segment + 1] - profile.positions[segment]);
        result.heights[i] = (1.0 - t) * profile.heights[segment] + t * profile.heights[segment + 1];
    }
    return result;
}

Processed apply(const Resample& step, topography::Measurement measurement, parallel::Threads threads) {
    topography::Measurement result;
    if (const auto* map = std::get_if<HeightMap>(&measurement)) result = resampled(*map, step, threads);
    else if (const auto* scan = std::get_if<LineScan>(&measurement)) result = resampled(*scan, step, threads);
    else result = resampled(std::get<Profile>(measurement), step);
    StepRecord record = record_of(step, result);
    return {std::move(result), std::move(record)};
}

}  // namespace setae::processing
