// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include <fmt/format.h>

#include "filter_arguments.hpp"
#include "gaussian_deviation.hpp"
#include "local_regression.hpp"
#include "robust_weights.hpp"
#include "setae/core/errors.hpp"
#include "setae/processing/iso_filter.hpp"

namespace setae::processing {
namespace {

void require_valid(const RobustGaussianFilter& filter, const topography::Metadata& metadata) {
    require_cutoff(filter.cutoff, "robust Gaussian filter", metadata);
    if (filter.order < 0 || filter.order > 2)
        throw InvalidArgument(
            fmt::format("{}: robust Gaussian filter with a local polynomial of order {}; expected 0, 1 or 2",
                        topography::label(metadata), filter.order));
}

/// @returns the number of updates of the weights.
int filter_robustly(Eigen::Ref<Array2D> heights, const Neighbourhood& near, Kept keep, parallel::Threads threads) {
    Array2D smooth(heights.rows(), heights.cols()), weights;
    RobustScale scale;
    do local_regression(heights, weights, near, Regression::value, smooth, threads);
    while (scale.update(heights, smooth, weights));
    heights = keep == Kept::short_waves
                  ? Array2D(heights - smooth)
                  : Array2D(heights.isNaN().select(std::numeric_limits<double>::quiet_NaN(), smooth));
    return scale.updates();
}

/// In place; returns the number of updates of the weights.
int filter_robustly(topography::HeightMap& map, const RobustGaussianFilter& filter, parallel::Threads threads) {
    require_valid(filter, map.metadata);
    const auto pixel = map.pixel_size();
    const double deviation = gaussian_deviation(filter.cutoff, filter.order);
    return filter_robustly(map.heights, {{deviation / pixel[0], deviation / pixel[1]}, map.periodic, filter.order},
                           filter.keep, threads);
}

int filter_robustly(topography::LineScan& scan, const RobustGaussianFilter& filter, parallel::Threads threads) {
    require_valid(filter, scan.metadata);
    Eigen::Map<Array2D> row(scan.heights.data(), 1, scan.heights.size());
    return filter_robustly(
        row, {{0.0, gaussian_deviation(filter.cutoff, filter.order) / scan.pixel_size()}, scan.periodic, filter.order},
        filter.keep, threads);
}

}  // namespace

topography::HeightMap filtered(topography::HeightMap map, const RobustGaussianFilter& filter,
                               parallel::Threads threads) {
    filter_robustly(map, filter, threads);
    return map;
}

topography::LineScan filtered(topography::LineScan scan, const RobustGaussianFilter& filter,
                              parallel::Threads threads) {
    filter_robustly(scan, filter, threads);
    return scan;
}

Processed apply(const RobustGaussianFilter& filter, topography::Measurement measurement, parallel::Threads threads) {
    return filtered_in_place(
        filter, std::move(measurement), [&](auto& data) { return filter_robustly(data, filter, threads); }, true);
}

}  // namespace setae::processing
