// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include <Eigen/Core>

#include "setae/parallel/for_each.hpp"
#include "setae/topography/detrend.hpp"

namespace setae::topography {

/// A trend of a map: polynomial in u, v = −1 … 1 along x and y.
struct MapTrend {
    Index nx = 0, ny = 0;
    double origin = 0.0;                  ///< [m], added to the polynomial
    std::array<double, 6> coefficient{};  ///< of 1, u, v, u², v², uv [m]

    /// Takes the trend from the scan lines first, first + 1, …; `band` has shape (nx, count).
    void subtract_from(Eigen::Ref<Array2D> band, Index first, parallel::Threads threads) const;
};

/// Least-squares fit of a trend to a map's defined points, gathered band by band of scan lines.
class MapTrendFit {
public:
    MapTrendFit(Trend trend, Index nx, Index ny);

    /// Same bytes for any number of threads.
    void add(const ArrayView2D& band, Index first, parallel::Threads threads);

    /// @throws UndefinedDataError where fewer points were defined than the trend has coefficients.
    [[nodiscard]] MapTrend solved() const;

    /// Sums of products of the basis functions, and of heights with them.
    struct Moments {
        Eigen::Matrix<double, 6, 6> gram = Eigen::Matrix<double, 6, 6>::Zero();
        Eigen::Matrix<double, 6, 1> heights = Eigen::Matrix<double, 6, 1>::Zero();
        double defined = 0.0;
    };

private:
    Trend trend_;
    Index nx_, ny_;
    std::optional<double> origin_;  // a defined height: sums about it lose no digits to an offset
    Moments moments_;
};

}  // namespace setae::topography
