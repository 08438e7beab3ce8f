// SPDX-License-Identifier: GPL-3.0-or-later
#include "feature_parameters.hpp"

#include <algorithm>
#include <array>
#include <functional>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/texture/height_parameters.hpp"
#include "watershed.hpp"

namespace setae::texture {
namespace {

constexpr std::size_t five = 5;

/// Mean of the five largest heights, or of all if there are fewer.
double mean_of_largest(std::vector<double> heights) {
    if (heights.empty()) return undefined;
    std::sort(heights.begin(), heights.end(), std::greater<>());
    heights.resize(std::min(five, heights.size()));
    double sum = 0.0;
    for (const double height : heights) sum += height;
    return sum / static_cast<double>(heights.size());
}

/// Mean of −½(z_xx + z_yy) at peaks.
double mean_curvature(const topography::HeightMap& map, const std::vector<Peak>& peaks) {
    const auto nx = map.heights.rows(), ny = map.heights.cols();
    const auto [dx, dy] = map.pixel_size();
    const auto at = [&](Index i, Index j) { return map.heights((i + nx) % nx, (j + ny) % ny); };
    double sum = 0.0;
    for (const auto& [i, j, height] : peaks)
        sum -= 0.5 * ((at(i - 1, j) - 2.0 * height + at(i + 1, j)) / (dx * dx) +
                      (at(i, j - 1) - 2.0 * height + at(i, j + 1)) / (dy * dy));
    return peaks.empty() ? undefined : sum / static_cast<double>(peaks.size());
}

}  // namespace

FeatureParameters feature_parameters(const topography::HeightMap& map, const FeatureOptions& options,
                                     parallel::Threads threads) {
    if (!(options.pruning >= 0.0 && options.pruning <= 1.0))
        throw InvalidArgument(fmt::format("pruning is {} of Sz; expected 0 … 1", options.pruning));
    const auto heights = height_parameters(map, threads);
    std::array<std::vector<Peak>, 2> found;
    const parallel::Threads inside{std::max(1, threads.resolved() / 2)};
    parallel::for_each_index(2, threads, [&](std::size_t k) {
        found[k] = significant_peaks(map, k == 0 ? Up::hills : Up::dales, options.pruning * heights.Sz, inside);
    });
    const auto& [peaks, pits] = found;
    const double area = map.pixel_size()[0] * map.pixel_size()[1] * static_cast<double>(heights.defined);
    const auto from_mean = [&](const std::vector<Peak>& list, double sign) {
        std::vector<double> values;
        for (const auto& peak : list) values.push_back(sign * (peak.height - heights.mean));
        return values;
    };
    FeatureParameters result;
    result.hills = static_cast<Index>(peaks.size());
    result.dales = static_cast<Index>(pits.size());
    result.Spd = static_cast<double>(result.hills) / area;
    result.Svd = static_cast<double>(result.dales) / area;
    result.Spc = mean_curvature(map, peaks);
    result.Svc = mean_curvature(map, pits);
    result.S5p = mean_of_largest(from_mean(peaks, 1.0));
    result.S5v = mean_of_largest(from_mean(pits, -1.0));
    result.S10z = result.S5p + result.S5v;
    return result;
}

}  // namespace setae::texture
