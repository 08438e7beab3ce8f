// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <limits>

#include "grid_place.hpp"
#include "line_slopes.hpp"
#include "setae/core/extent.hpp"
#include "setae/processing/interpolation.hpp"

namespace setae::processing {
namespace {

constexpr double outside = std::numeric_limits<double>::quiet_NaN();
constexpr Index columns_per_block = 16;

/// Hermite's cubics between two points and their derivatives: of the heights and of the slopes there.
struct Hermite {
    double height[2], slope[2], height_derivative[2], slope_derivative[2];

    explicit Hermite(double t)
        : height{1.0 + t * t * (2.0 * t - 3.0), t * t * (3.0 - 2.0 * t)},
          slope{t * (1.0 - t) * (1.0 - t), t * t * (t - 1.0)},
          height_derivative{6.0 * t * (t - 1.0), 6.0 * t * (1.0 - t)},
          slope_derivative{(1.0 - t) * (1.0 - 3.0 * t), t * (3.0 * t - 2.0)} {}
};

/// Whether the upper point is used: not if the place is the lower point and only its slope is needed.
bool both_count(const GridPlace& place) { return place.fraction > 0.0; }

}  // namespace

BicubicInterpolator::BicubicInterpolator(const topography::HeightMap& map, parallel::Threads threads)
    : map_(&map), slopes_x_(map.heights.rows(), map.heights.cols()), slopes_y_(map.heights.rows(), map.heights.cols()) {
    const Index nx = map.heights.rows(), ny = map.heights.cols();
    const LineSlopes along_x(nx, map.periodic), along_y(ny, map.periodic);
    parallel::for_each_index(extent(nx), threads, [&](std::size_t i) {
        along_y.find(&map.heights(static_cast<Index>(i), 0), &slopes_y_(static_cast<Index>(i), 0));
    });
    parallel::for_each_index(extent((ny + columns_per_block - 1) / columns_per_block), threads, [&](std::size_t block) {
        const Index first = static_cast<Index>(block) * columns_per_block,
                    count = std::min(columns_per_block, ny - first);
        const Array2D lines = map.heights.middleCols(first, count).transpose();
        Array2D slopes(count, nx);
        for (Index j = 0; j < count; ++j) along_x.find(&lines(j, 0), &slopes(j, 0));
        slopes_x_.middleCols(first, count) = slopes.transpose();
    });
}

SurfacePoint BicubicInterpolator::at(double x, double y) const {
    const auto& heights = map_->heights;
    const auto pixel = map_->pixel_size();
    const auto place_x = grid_place(x / pixel[0], heights.rows(), map_->periodic),
               place_y = grid_place(y / pixel[1], heights.cols(), map_->periodic);
    if (!place_x || !place_y) return {outside, outside, outside};
    const Hermite along_x(place_x->fraction), along_y(place_y->fraction);
    const Index i[2] = {place_x->lower, place_x->upper}, j[2] = {place_y->lower, place_y->upper};
    SurfacePoint point;
    for (int a = 0; a < (both_count(*place_x) ? 2 : 1); ++a)
        for (int b = 0; b < (both_count(*place_y) ? 2 : 1); ++b) {
            const double h = heights(i[a], j[b]), p = slopes_x_(i[a], j[b]), q = slopes_y_(i[a], j[b]);
            point.height += h * along_x.height[a] * along_y.height[b] + p * along_x.slope[a] * along_y.height[b] +
                            q * along_x.height[a] * along_y.slope[b];
            point.slope_x += h * along_x.height_derivative[a] * along_y.height[b] +
                             p * along_x.slope_derivative[a] * along_y.height[b] +
                             q * along_x.height_derivative[a] * along_y.slope[b];
            point.slope_y += h * along_x.height[a] * along_y.height_derivative[b] +
                             p * along_x.slope[a] * along_y.height_derivative[b] +
                             q * along_x.height[a] * along_y.slope_derivative[b];
        }
    point.slope_x /= pixel[0];
    point.slope_y /= pixel[1];
    return point;
}

CubicLineInterpolator::CubicLineInterpolator(const topography::LineScan& scan)
    : scan_(&scan), slopes_(scan.heights.size()) {
    LineSlopes(scan.heights.size(), scan.periodic).find(scan.heights.data(), slopes_.data());
}

double CubicLineInterpolator::operator()(double x) const {
    const auto place = grid_place(x / scan_->pixel_size(), scan_->heights.size(), scan_->periodic);
    if (!place) return outside;
    const Hermite along(place->fraction);
    const double lower = scan_->heights[place->lower] * along.height[0] + slopes_[place->lower] * along.slope[0];
    return both_count(*place)
               ? lower + scan_->heights[place->upper] * along.height[1] + slopes_[place->upper] * along.slope[1]
               : lower;
}

}  // namespace setae::processing
