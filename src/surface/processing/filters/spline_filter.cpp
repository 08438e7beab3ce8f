// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>
#include <numbers>
#include <variant>

#include <fmt/format.h>

#include "filter_arguments.hpp"
#include "robust_weights.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/extent.hpp"
#include "setae/processing/iso_filter.hpp"
#include "smoothing_spline.hpp"

namespace setae::processing {
namespace {

constexpr Index spline_columns_per_block = 64;

void require_valid(const SplineFilter& filter, double pixel_size, const topography::Metadata& metadata) {
    require_cutoff(filter.cutoff, "spline filter", metadata);
    if (!(filter.cutoff > 2.0 * pixel_size))
        throw InvalidArgument(fmt::format(
            "{}: spline filter with a cutoff of {} m on points {} m apart; expected more than two of these steps",
            topography::label(metadata), filter.cutoff, pixel_size));
    if (!(filter.tension >= 0.0 && filter.tension <= 1.0))
        throw InvalidArgument(fmt::format("{}: spline filter with a tension of {}; expected 0 to 1",
                                          topography::label(metadata), filter.tension));
}

SplineStiffness stiffness(const SplineFilter& filter, double pixel_size) {
    const double alpha = 0.5 / std::sin(std::numbers::pi * pixel_size / filter.cutoff);
    return {filter.tension * alpha * alpha, (1.0 - filter.tension) * std::pow(alpha, 4.0)};
}

/// Smooths lines; the factorisation for complete lines without weights is kept.
class LineSmoother {
public:
    LineSmoother(Index points, const SplineStiffness& stiff, bool periodic)
        : stiff_(stiff), periodic_(periodic), complete_(Array1D::Ones(points), stiff, periodic) {}

    /// `factors` of the n values, or null for 1; undefined values have no weight.
    void smooth(double* values, const double* factors, Index n) const {
        Array1D weights(n);
        bool plain = factors == nullptr;
        for (Index i = 0; i < n; ++i) {
            const bool there = !std::isnan(values[i]);
            plain = plain && there;
            weights[i] = there ? (factors == nullptr ? 1.0 : factors[i]) : 0.0;
        }
        if (plain) complete_.smooth(values);
        else SmoothingSpline(weights, stiff_, periodic_).smooth(values);
    }

private:
    SplineStiffness stiff_;
    bool periodic_;
    SmoothingSpline complete_;
};

/// Every line along x with the given weights, then every line along y.
Array2D smooth_map(const Array2D& heights, const Array2D& factors, const std::array<SplineStiffness, 2>& stiff,
                   bool periodic, parallel::Threads threads) {
    Array2D smooth = heights;
    const Index nx = heights.rows(), ny = heights.cols();
    if (nx > 1) {
        const LineSmoother smoother(nx, stiff[0], periodic);
        parallel::for_each_index(
            extent((ny + spline_columns_per_block - 1) / spline_columns_per_block), threads, [&](std::size_t block) {
                const Index first = static_cast<Index>(block) * spline_columns_per_block,
                            count = std::min(spline_columns_per_block, ny - first);
                Array2D lines = heights.middleCols(first, count).transpose(), weights;
                if (factors.size() > 0) weights = factors.middleCols(first, count).transpose();
                for (Index j = 0; j < count; ++j)
                    smoother.smooth(&lines(j, 0), factors.size() > 0 ? &weights(j, 0) : nullptr, nx);
                // values from the first pass at undefined points must not be used as data in the second
                smooth.middleCols(first, count) =
                    heights.middleCols(first, count)
                        .isNaN()
                        .select(std::numeric_limits<double>::quiet_NaN(), lines.transpose());
            });
    }
    if (ny > 1) {
        const LineSmoother smoother(ny, stiff[1], periodic);
        parallel::for_each_index(extent(nx), threads, [&](std::size_t row) {
            const auto i = static_cast<Index>(row);
            smoother.smooth(&smooth(i, 0), factors.size() > 0 && nx == 1 ? &factors(i, 0) : nullptr, ny);
        });
    }
    return smooth;
}

int filter_in_place(Eigen::Ref<Array2D> heights, const SplineFilter& filter,
                    const std::array<SplineStiffness, 2>& stiff, bool periodic, parallel::Threads threads) {
    Array2D weights, smooth;
    RobustScale scale;
    do smooth = smooth_map(heights, weights, stiff, periodic, threads);
    while (filter.robust && scale.update(heights, smooth, weights));
    heights = filter.keep == Kept::short_waves
                  ? Array2D(heights - smooth)
                  : Array2D(heights.isNaN().select(std::numeric_limits<double>::quiet_NaN(), smooth));
    return scale.updates();
}

/// In place; returns the number of updates of the weights.
int filter_in_place(topography::HeightMap& map, const SplineFilter& filter, parallel::Threads threads) {
    const auto pixel = map.pixel_size();
    require_valid(filter, std::max(pixel[0], pixel[1]), map.metadata);
    return filter_in_place(map.heights, filter, {stiffness(filter, pixel[0]), stiffness(filter, pixel[1])},
                           map.periodic, threads);
}

int filter_in_place(topography::LineScan& scan, const SplineFilter& filter, parallel::Threads threads) {
    require_valid(filter, scan.pixel_size(), scan.metadata);
    Eigen::Map<Array2D> row(scan.heights.data(), 1, scan.heights.size());
    const SplineStiffness stiff = stiffness(filter, scan.pixel_size());
    return filter_in_place(row, filter, {stiff, stiff}, scan.periodic, threads);
}

}  // namespace

topography::HeightMap filtered(topography::HeightMap map, const SplineFilter& filter, parallel::Threads threads) {
    filter_in_place(map, filter, threads);
    return map;
}

topography::LineScan filtered(topography::LineScan scan, const SplineFilter& filter, parallel::Threads threads) {
    filter_in_place(scan, filter, threads);
    return scan;
}

Processed apply(const SplineFilter& filter, topography::Measurement measurement, parallel::Threads threads) {
    return filtered_in_place(
        filter, std::move(measurement), [&](auto& data) { return filter_in_place(data, filter, threads); },
        filter.robust);
}

}  // namespace setae::processing
