// SPDX-License-Identifier: GPL-3.0-or-later
#include "autocorrelation_of_products.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/extent.hpp"
#include "setae/fourier/fast_length.hpp"
#include "setae/fourier/map_transform.hpp"

namespace setae::texture {
/// Sum over all points of v(x) v(x + t) at every wrapped lag of an nx × ny grid; load(i, row) writes row i of those
/// before the padding.
AutocorrelationOfProducts::Products::Products(Index nx, Index ny, Index rows,
                                              const std::function<void(Index, double*)>& load,
                                              parallel::Threads threads)
    : sums(nx, ny) {
    Array2D power(ny / 2 + 1, nx);
    fourier::transform_padded_map(
        nx, ny, rows, load,
        [&power](const fourier::SpectrumBlock& block) {
            for (Index m = 0; m < block.lines; ++m)
                for (Index k = 0; k < block.modes; ++k) power(block.first + m, k) = std::norm(block.line(m)[k]);
        },
        threads);
    const double scale = 1.0 / (static_cast<double>(nx) * static_cast<double>(ny));
    transform.emplace(
        [&](Index m, fourier::Complex* modes) {
            for (Index k = 0; k < nx; ++k) modes[k] = power(m, k) * scale;
        },
        sums, threads);
}

AutocorrelationOfProducts::AutocorrelationOfProducts(const topography::HeightMap& map, double mean,
                                                     parallel::Threads threads)
    : nx_(map.heights.rows()),
      ny_(map.heights.cols()),
      reach_x_(map.periodic ? nx_ / 2 : nx_ - 1),
      reach_y_(map.periodic ? ny_ / 2 : ny_ - 1),
      periodic_(map.periodic),
      threads_(threads) {
    const auto grid_x = map.periodic ? nx_ : fourier::fast_length(2 * nx_ - 1),
               grid_y = map.periodic ? ny_ : fourier::fast_length(2 * ny_ - 1);
    const auto load = [&](auto value) {
        return [&map, grid_y, value](Index i, double* row) {
            const Index ny = map.heights.cols();
            const double* const heights = map.heights.data() + i * ny;
            for (Index j = 0; j < ny; ++j) row[j] = value(heights[j]);
            std::fill(row + ny, row + grid_y, 0.0);
        };
    };
    values_.emplace(grid_x, grid_y, nx_, load([mean](double h) { return std::isnan(h) ? 0.0 : h - mean; }), threads);
    if (map.heights.isNaN().any())
        counts_.emplace(grid_x, grid_y, nx_, load([](double h) { return std::isnan(h) ? 0.0 : 1.0; }), threads);
    find_rows(0);
    if (!(square_ > 0.0))
        throw UndefinedDataError(topography::label(map.metadata) +
                                 ": all heights are equal, so their autocorrelation is undefined");
}

/// Mean product of the pairs at a lag, undefined if there are none.
double AutocorrelationOfProducts::mean_at(Index i, Index j) const {
    const auto grid_x = values_->sums.rows(), grid_y = values_->sums.cols();
    const double product = values_->sums(i, j);
    if (!counts_ && periodic_) return product;
    const auto lag = [](Index k, Index n) { return static_cast<double>(std::min(k, n - k)); };
    const double pairs =
        counts_ ? std::round(counts_->sums(i, j))
                : (static_cast<double>(nx_) - lag(i, grid_x)) * (static_cast<double>(ny_) - lag(j, grid_y));
    return pairs > 0.0 ? product / pairs : undefined;
}

void AutocorrelationOfProducts::make_rows(Index first, Index last) {
    values_->transform->make_rows(first, last, threads_);
    if (counts_) counts_->transform->make_rows(first, last, threads_);
    auto& sums = values_->sums;
    if (first == 0) square_ = mean_at(0, 0);
    if (!(square_ > 0.0)) return;
    parallel::for_each_index(extent(last - first), threads_, [&](std::size_t row) {
        const auto i = first + static_cast<Index>(row);
        for (Index j = 0; j < sums.cols(); ++j) sums(i, j) = mean_at(i, j) / square_;
    });
}

void AutocorrelationOfProducts::find_rows(Index lag) {
    constexpr Index together = 64;
    const Index rows = values_->sums.rows(), all = rows / 2 + 1;
    if (lag < found_) return;
    // lags −1, −2, … are at the end; beyond the middle they meet the positive ones
    const Index end = std::min(all, (lag / together + 1) * together);
    make_rows(found_, end);
    const Index first = std::max(end, rows - end + 1), last = std::max(end, rows - std::max<Index>(found_, 1) + 1);
    make_rows(first, last);
    found_ = end;
}

}  // namespace setae::texture
