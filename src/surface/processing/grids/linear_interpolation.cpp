// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>

#include "grid_place.hpp"
#include "setae/processing/interpolation.hpp"

namespace setae::processing {
namespace {

constexpr double linear_outside = std::numeric_limits<double>::quiet_NaN();

/// Weight times height; a height with weight zero is ignored.
double share(double weight, double height) { return weight == 0.0 ? 0.0 : weight * height; }

}  // namespace

double LinearInterpolator::operator()(double x, double y) const {
    const auto& heights = map_->heights;
    const auto pixel = map_->pixel_size();
    const auto along_x = grid_place(x / pixel[0], heights.rows(), map_->periodic),
               along_y = grid_place(y / pixel[1], heights.cols(), map_->periodic);
    if (!along_x || !along_y) return linear_outside;
    const double u = along_x->fraction, v = along_y->fraction;
    const double lower_upper = heights(along_x->lower, along_y->upper),
                 upper_lower = heights(along_x->upper, along_y->lower);
    if (u + v > 1.0)
        return share(u + v - 1.0, heights(along_x->upper, along_y->upper)) + share(1.0 - u, lower_upper) +
               share(1.0 - v, upper_lower);
    return share(1.0 - u - v, heights(along_x->lower, along_y->lower)) + share(u, upper_lower) + share(v, lower_upper);
}

double LinearLineInterpolator::operator()(double x) const {
    const auto place = grid_place(x / scan_->pixel_size(), scan_->heights.size(), scan_->periodic);
    if (!place) return linear_outside;
    return share(1.0 - place->fraction, scan_->heights[place->lower]) +
           share(place->fraction, scan_->heights[place->upper]);
}

}  // namespace setae::processing
