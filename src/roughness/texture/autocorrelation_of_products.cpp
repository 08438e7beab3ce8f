// SPDX-License-Identifier: GPL-3.0-or-later
#include "autocorrelation_of_products.hpp"

#include <cmath>
#include <complex>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/extent.hpp"
#include "setae/fourier/fast_length.hpp"
#include "setae/fourier/inverse_map_transform.hpp"
#include "setae/fourier/map_transform.hpp"

namespace setae::texture {
namespace {

/// Sum over all points of v(x) v(x + t) at every wrapped lag of an nx × ny grid; load(i, row) writes row i.
template <class Load>
Array2D products(Index nx, Index ny, Load load, parallel::Threads threads) {
    Array2D power(ny / 2 + 1, nx);
    fourier::transform_map(
        nx, ny, load,
        [&power](const fourier::SpectrumBlock& block) {
            for (Index m = 0; m < block.lines; ++m)
                for (Index k = 0; k < block.modes; ++k) power(block.first + m, k) = std::norm(block.line(m)[k]);
        },
        threads);
    Array2D sums(nx, ny);
    const double scale = 1.0 / (static_cast<double>(nx) * static_cast<double>(ny));
    fourier::inverse_transform_map(
        [&](Index m, fourier::Complex* modes) {
            for (Index k = 0; k < nx; ++k) modes[k] = power(m, k) * scale;
        },
        sums, threads);
    return sums;
}

}  // namespace

AutocorrelationOfProducts::AutocorrelationOfProducts(const topography::HeightMap& map, double mean,
                                                     parallel::Threads threads) {
    const auto nx = map.heights.rows(), ny = map.heights.cols();
    const auto grid_x = map.periodic ? nx : fourier::fast_length(2 * nx - 1),
               grid_y = map.periodic ? ny : fourier::fast_length(2 * ny - 1);
    reach_x_ = map.periodic ? nx / 2 : nx - 1;
    reach_y_ = map.periodic ? ny / 2 : ny - 1;
    const auto load = [&](auto value) {
        return [&map, nx, ny, grid_y, value](Index i, double* row) {
            for (Index j = 0; j < grid_y; ++j) row[j] = i < nx && j < ny ? value(map.heights(i, j)) : 0.0;
        };
    };
    values_ = products(grid_x, grid_y, load([mean](double h) { return h == h ? h - mean : 0.0; }), threads);
    const bool whole = (map.heights == map.heights).all();
    const auto lag = [](Index k, Index n) { return static_cast<double>(std::min(k, n - k)); };
    const auto pairs_at = [&](Index i, Index j) {
        return (static_cast<double>(nx) - lag(i, grid_x)) * (static_cast<double>(ny) - lag(j, grid_y));
    };
    Array2D counted;
    if (!whole) counted = products(grid_x, grid_y, load([](double h) { return h == h ? 1.0 : 0.0; }), threads).round();
    /// Mean product of the pairs at a lag, undefined where there are none.
    const auto mean_at = [&](Index i, Index j) {
        if (whole && map.periodic) return values_(i, j);
        const double pairs = whole ? pairs_at(i, j) : counted(i, j);
        return pairs > 0.0 ? values_(i, j) / pairs : undefined;
    };
    const double square = mean_at(0, 0);
    if (!(square > 0.0))
        throw UndefinedDataError(topography::label(map.metadata) +
                                 ": all heights are equal, so their autocorrelation is undefined");
    parallel::for_each_index(extent(grid_x), threads, [&](std::size_t row) {
        const auto i = static_cast<Index>(row);
        for (Index j = 0; j < grid_y; ++j) values_(i, j) = mean_at(i, j) / square;
    });
}

}  // namespace setae::texture
