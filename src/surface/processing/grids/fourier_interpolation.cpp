// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/format.h>

#include "fourier_lines.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/extent.hpp"
#include "setae/fourier/buffer.hpp"
#include "setae/processing/interpolation.hpp"

namespace setae::processing {
namespace {

constexpr Index fourier_columns_per_block = 16;

void require_points(Index n, const topography::Metadata& metadata) {
    if (n < 1)
        throw InvalidArgument(fmt::format("{}: interpolation to {} points along a direction; expected at least 1",
                                          topography::label(metadata), n));
}

}  // namespace

void require_periodic(bool periodic, bool complete, const char* what, const topography::Metadata& metadata) {
    if (!periodic)
        throw InvalidArgument(
            fmt::format("{}: {} needs periodic data, and these are not periodic: the result would oscillate near the "
                        "ends; use a filter of ISO 16610 or another method of interpolation, or apply a window first",
                        topography::label(metadata), what));
    if (!complete)
        throw UndefinedDataError(
            fmt::format("{}: {} needs all heights, and some are undefined; fill them first (step fill_undefined)",
                        topography::label(metadata), what));
}

FourierLine::FourierLine(Index points, Index new_points) : forward_(points), back_(new_points) {}

void FourierLine::resample(const double* heights, double* resampled) const {
    const Index n = forward_.points(), N = back_.points();
    thread_local fourier::Buffer<double> line;
    thread_local fourier::Buffer<fourier::Complex> modes;
    line.resize(extent(std::max(n, N)));
    modes.resize(extent(std::max(forward_.modes(), back_.modes())));
    std::copy(heights, heights + n, line.begin());
    forward_.forward(line.data(), modes.data());
    if (N > n) {
        std::fill(modes.begin() + forward_.modes(), modes.begin() + back_.modes(), fourier::Complex(0.0));
        if (n % 2 == 0) modes[extent(n / 2)] *= 0.5;
    } else if (N < n && N % 2 == 0) {
        modes[extent(N / 2)] = 2.0 * modes[extent(N / 2)].real();
    }
    back_.apply(modes.data(), line.data());
    const double factor = 1.0 / static_cast<double>(n);
    for (Index i = 0; i < N; ++i) resampled[i] = factor * line[extent(i)];
}

topography::HeightMap fourier_interpolated(const topography::HeightMap& map, Index nx, Index ny,
                                           parallel::Threads threads) {
    require_points(std::min(nx, ny), map.metadata);
    require_periodic(map.periodic, !map.heights.isNaN().any(), "Fourier interpolation", map.metadata);
    const Index old_nx = map.heights.rows();
    Array2D along_y(old_nx, ny);
    const FourierLine rows(map.heights.cols(), ny), columns(old_nx, nx);
    parallel::for_each_index(extent(old_nx), threads, [&](std::size_t row) {
        rows.resample(&map.heights(static_cast<Index>(row), 0), &along_y(static_cast<Index>(row), 0));
    });
    topography::HeightMap result{Array2D(nx, ny), map.size, true, map.metadata};
    parallel::for_each_index(extent((ny + fourier_columns_per_block - 1) / fourier_columns_per_block), threads,
                             [&](std::size_t block) {
                                 const Index first = static_cast<Index>(block) * fourier_columns_per_block,
                                             count = std::min(fourier_columns_per_block, ny - first);
                                 const Array2D lines = along_y.middleCols(first, count).transpose();
                                 Array2D resampled(count, nx);
                                 for (Index j = 0; j < count; ++j) columns.resample(&lines(j, 0), &resampled(j, 0));
                                 result.heights.middleCols(first, count) = resampled.transpose();
                             });
    return result;
}

topography::LineScan fourier_interpolated(const topography::LineScan& scan, Index points) {
    require_points(points, scan.metadata);
    require_periodic(scan.periodic, !scan.heights.isNaN().any(), "Fourier interpolation", scan.metadata);
    topography::LineScan result{Array1D(points), scan.size, true, scan.metadata};
    FourierLine(scan.heights.size(), points).resample(scan.heights.data(), result.heights.data());
    return result;
}

}  // namespace setae::processing
