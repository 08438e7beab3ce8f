// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include <fmt/format.h>

#include "filter_arguments.hpp"
#include "gaussian_deviation.hpp"
#include "local_regression.hpp"
#include "setae/core/errors.hpp"
#include "setae/processing/iso_filter.hpp"

namespace setae::processing {
namespace {

void require_valid(const GaussianFilter& filter, const topography::Metadata& metadata) {
    require_cutoff(filter.cutoff, "Gaussian filter", metadata);
    if (filter.order != 0 && filter.order != 1)
        throw InvalidArgument(fmt::format("{}: Gaussian filter with a local polynomial of order {}; expected 0 or 1",
                                          topography::label(metadata), filter.order));
}

Regression kind_of(Kept keep) { return keep == Kept::long_waves ? Regression::value : Regression::residual; }

/// The original heights: undefined ones are marked first, because regression also gives a value there.
void filter_in_place(Eigen::Ref<Array2D> heights, const Neighbourhood& near, Kept keep, parallel::Threads threads) {
    const auto undefined_points = (heights.isNaN()).count();
    if (undefined_points == 0 || keep == Kept::short_waves) {
        local_regression(heights, {}, near, kind_of(keep), heights, threads);
        return;
    }
    Array2D smooth(heights.rows(), heights.cols());
    local_regression(heights, {}, near, Regression::value, smooth, threads);
    heights = heights.isNaN().select(std::numeric_limits<double>::quiet_NaN(), smooth);
}

}  // namespace

topography::HeightMap filtered(topography::HeightMap map, const GaussianFilter& filter, parallel::Threads threads) {
    require_valid(filter, map.metadata);
    const auto pixel = map.pixel_size();
    filter_in_place(map.heights,
                    {{gaussian_deviation(filter.cutoff, 0) / pixel[0], gaussian_deviation(filter.cutoff, 0) / pixel[1]},
                     map.periodic,
                     filter.order},
                    filter.keep, threads);
    return map;
}

topography::LineScan filtered(topography::LineScan scan, const GaussianFilter& filter, parallel::Threads threads) {
    require_valid(filter, scan.metadata);
    Eigen::Map<Array2D> row(scan.heights.data(), 1, scan.heights.size());
    filter_in_place(row, {{0.0, gaussian_deviation(filter.cutoff, 0) / scan.pixel_size()}, scan.periodic, filter.order},
                    filter.keep, threads);
    return scan;
}

Processed apply(const GaussianFilter& filter, topography::Measurement measurement, parallel::Threads threads) {
    if (const auto* profile = std::get_if<topography::Profile>(&measurement))
        refuse_profile(step_name(filter), *profile);
    StepRecord record = filter_record(step_name(filter), filter.cutoff, measurement);
    if (auto* map = std::get_if<topography::HeightMap>(&measurement))
        return {filtered(std::move(*map), filter, threads), std::move(record)};
    return {filtered(std::get<topography::LineScan>(std::move(measurement)), filter, threads), std::move(record)};
}

}  // namespace setae::processing
