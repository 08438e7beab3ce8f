// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/texture/material_ratio.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "curve_sums.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/numerics/bracketing.hpp"

namespace setae::texture {
namespace {

constexpr Index grid_intervals = 1024;

/// Heights over the whole range; both ends are exact.
Array1D height_grid(double lowest, double highest) {
    Array1D grid = Array1D::LinSpaced(grid_intervals + 1, lowest, highest);
    grid[grid_intervals] = highest;
    return grid;
}

/// The last height of the grid with at least this ratio.
Index last_with(const CurveSums& sums, double ratio) {
    Index k = sums.above.size() - 1;
    while (k > 0 && sums.above[k] / sums.weight < ratio) --k;
    return k;
}

/// Crossing of a decreasing function of x with `target`, which it exceeds or equals at lower and not at upper.
template <class Function>
double crossing(double lower, double upper, double target, Function function) {
    return numerics::bisected([&](double x) { return function(x) >= target; }, lower, upper).first;
}

/// Indices of the finite heights in increasing order.
std::vector<Index> increasing_order(const ArrayView1D& heights) {
    std::vector<Index> order;
    for (Index k = 0; k < heights.size(); ++k)
        if (std::isfinite(heights[k])) order.push_back(k);
    std::stable_sort(order.begin(), order.end(), [&heights](Index k, Index m) { return heights[k] < heights[m]; });
    return order;
}

/// 1 at −infinity, 0 at infinity, otherwise NaN.
Array1D ratios_at_infinity(const ArrayView1D& heights) {
    return heights.unaryExpr([](double h) { return std::isinf(h) ? (h < 0.0 ? 1.0 : 0.0) : undefined; });
}

void require_share(double share) {
    if (!(share > 0.0 && share < 1.0))
        throw InvalidArgument(fmt::format("share of the area is {}; expected 0 < share < 1", share));
}

}  // namespace

Array1D bearing_area(const MeasurementView& measurement, const ArrayView1D& heights, Between between,
                     parallel::Threads threads) {
    const auto order = increasing_order(heights);
    Array1D ratio = ratios_at_infinity(heights);
    if (order.empty()) return ratio;
    const HeightLocator locate(heights(order));
    const auto sums = sum_curve(Elements(measurement, between), locate, Volumes::no, threads);
    ratio(order) = sums.above / sums.weight;
    return ratio;
}

MaterialRatioCurve material_ratio_curve(const MeasurementView& measurement, const ArrayView1D& heights, Between between,
                                        parallel::Threads threads) {
    if (heights.size() == 0) throw InvalidArgument("no height is defined, so that there is no material ratio");
    for (Index k = 1; k < heights.size(); ++k)
        if (!(heights[k] > heights[k - 1]))
            throw InvalidArgument(
                fmt::format("heights of a material ratio curve must increase: {} m is followed by {} m", heights[k - 1],
                            heights[k]));
    const auto sums = sum_curve(Elements(measurement, between), HeightLocator(heights), Volumes::yes, threads);
    return {heights,
            sums.above / sums.weight,
            sums.volume / sums.weight,
            heights[0] + sums.moment / sums.weight,
            sums.lowest,
            sums.highest};
}

Array1D heights_at_ratio(const Elements& elements, const HeightLocator& locate, const CurveSums& sums,
                         const ArrayView1D& ratios, parallel::Threads threads) {
    for (Index k = 0; k < ratios.size(); ++k)
        if (!(ratios[k] >= 0.0 && ratios[k] <= 1.0))
            throw InvalidArgument(fmt::format("material ratio {} is {}; expected 0 … 1", k, ratios[k]));
    const double* grid = locate.heights();
    const Index last = locate.count() - 1;
    Array1D heights(ratios.size());
    std::vector<Index> interval(static_cast<std::size_t>(ratios.size()), -1), wanted;
    for (Index k = 0; k < ratios.size(); ++k) {
        heights[k] = ratios[k] == 0.0 ? sums.highest : sums.lowest;
        if (ratios[k] == 0.0 || ratios[k] == 1.0) continue;
        const auto j = last_with(sums, ratios[k]);
        heights[k] = grid[j];
        if (j == last) continue;
        interval[static_cast<std::size_t>(k)] = j;
        wanted.push_back(j);
    }
    std::sort(wanted.begin(), wanted.end());
    wanted.erase(std::unique(wanted.begin(), wanted.end()), wanted.end());
    const Brackets brackets(elements, locate, sums, wanted, threads);
    for (Index k = 0; k < ratios.size(); ++k) {
        const auto j = interval[static_cast<std::size_t>(k)];
        if (j < 0) continue;
        const auto place = static_cast<std::size_t>(std::lower_bound(wanted.begin(), wanted.end(), j) - wanted.begin());
        heights[k] =
            crossing(grid[j], grid[j + 1], ratios[k], [&](double height) { return brackets.ratio(place, height); });
    }
    return heights;
}

Array1D heights_at_ratio(const MeasurementView& measurement, const ArrayView1D& ratios, Between between,
                         parallel::Threads threads) {
    const Elements elements(measurement, between);
    const auto range = elements.range();
    const HeightLocator locate(height_grid(range.lowest, range.highest));
    return heights_at_ratio(elements, locate, sum_curve(elements, locate, Volumes::no, threads), ratios, threads);
}

double median_height(const MeasurementView& measurement, Between between, parallel::Threads threads) {
    return heights_at_ratio(measurement, Array1D::Constant(1, 0.5), between, threads)[0];
}

double mad_height(const MeasurementView& measurement, double share, Between between, parallel::Threads threads) {
    require_share(share);
    const Elements elements(measurement, between);
    const auto range = elements.range();
    const double median = median_height(measurement, between, threads);
    const double widest = std::max(range.highest - median, median - range.lowest);
    if (widest == 0.0) return 0.0;
    // widths 0 … widest in equal steps: heights median ± width, mirrored about the middle of the grid
    constexpr Index steps = grid_intervals / 2;
    const auto width = [&](Index k) { return widest * static_cast<double>(k) / static_cast<double>(steps); };
    Array1D grid(2 * steps + 1);
    for (Index k = 0; k <= steps; ++k) {
        grid[steps + k] = median + width(k);
        grid[steps - k] = median - width(k);
    }
    const HeightLocator locate(grid);
    const auto sums = sum_curve(elements, locate, Volumes::no, threads);
    const auto outside = [&](Index k) { return 1.0 - (sums.above[steps - k] - sums.above[steps + k]) / sums.weight; };
    Index k = steps;
    while (k > 0 && outside(k) <= 1.0 - share) --k;
    if (k == steps) return widest;
    const std::vector<Index> wanted{steps - k - 1, steps + k};
    const Brackets brackets(elements, locate, sums, wanted, threads);
    return crossing(width(k), width(k + 1), 1.0 - share, [&](double m) {
        return 1.0 - brackets.ratio(0, std::max(median - m, grid[steps - k - 1])) +
               brackets.ratio(1, std::min(median + m, grid[steps + k + 1]));
    });
}

}  // namespace setae::texture
