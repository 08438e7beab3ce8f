// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/parallel/for_each.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::texture {

/// Mean products of heights z about their mean at every lag of the full circle, over those at lag 0.
///
/// Scale-dependent statistics use height differences (scales/autocorrelation.hpp); the standard's parameters are of
/// products.
class AutocorrelationOfProducts {
public:
    /// @throws UndefinedDataError for a constant map.
    AutocorrelationOfProducts(const topography::HeightMap& map, double mean, parallel::Threads threads);

    /// Largest lags in pixels: n − 1, or n/2 in periodic maps.
    [[nodiscard]] Index reach_x() const { return reach_x_; }
    [[nodiscard]] Index reach_y() const { return reach_y_; }

    /// f at lag (i, j), |i| <= reach_x, |j| <= reach_y; NaN without a pair.
    [[nodiscard]] double operator()(Index i, Index j) const {
        const auto nx = values_.rows(), ny = values_.cols();
        return values_(i < 0 ? i + nx : i, j < 0 ? j + ny : j);
    }

private:
    Array2D values_;  ///< lags wrap
    Index reach_x_ = 0, reach_y_ = 0;
};

}  // namespace setae::texture
