// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdlib>
#include <functional>
#include <optional>

#include "setae/fourier/inverse_map_transform.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::texture {

/// Mean products of heights z about their mean at every lag of the full circle, divided by that at lag 0.
///
/// Scale-dependent statistics use height differences (scales/autocorrelation.hpp); the parameters of the standard use
/// products. Lags along x are computed on request.
class AutocorrelationOfProducts {
public:
    /// @throws UndefinedDataError for a constant map.
    AutocorrelationOfProducts(const topography::HeightMap& map, double mean, parallel::Threads threads);

    /// Largest lags in pixels: n − 1, or n/2 in periodic maps.
    [[nodiscard]] Index reach_x() const { return reach_x_; }
    [[nodiscard]] Index reach_y() const { return reach_y_; }

    /// f at lag (i, j), |i| <= reach_x, |j| <= reach_y; NaN without a pair.
    [[nodiscard]] double operator()(Index i, Index j) {
        if (std::abs(i) >= found_) find_rows(std::abs(i));
        const auto& f = values_->sums;
        return f(i < 0 ? i + f.rows() : i, j < 0 ? j + f.cols() : j);
    }

private:
    /// Sums over pairs at the computed rows of wrapped lags.
    struct Products {
        Products(Index nx, Index ny, Index rows, const std::function<void(Index, double*)>& load,
                 parallel::Threads threads);

        Array2D sums;
        std::optional<fourier::InverseMapTransform> transform;
    };

    /// Computes rows of lags −lag … lag and some more.
    void find_rows(Index lag);
    void make_rows(Index first, Index last);
    [[nodiscard]] double mean_at(Index i, Index j) const;

    Index nx_, ny_, reach_x_, reach_y_;
    bool periodic_;
    parallel::Threads threads_;
    std::optional<Products> values_;  ///< f in the computed rows
    std::optional<Products> counts_;  ///< of pairs, if heights are undefined
    double square_ = 0.0;             ///< mean product at lag 0
    Index found_ = 0;                 ///< lags |i| below this are computed
};

}  // namespace setae::texture
