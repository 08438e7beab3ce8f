// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/scales/autocorrelation.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "area_pairs.hpp"
#include "radial_bins.hpp"
#include "setae/core/errors.hpp"
#include "setae/fourier/map_transform.hpp"

namespace setae::scales {

FunctionOfScale autocorrelation_of_area(const topography::HeightMap& map, const spectra::LogGrid& grid,
                                        const AutocorrelationOptions& options) {
    const auto lags = lags_of(map);
    if (lags.x < 1 || lags.y < 1)
        throw InvalidArgument(fmt::format("{}: {} x {} points have no area; use the autocorrelation of lines",
                                          topography::label(map.metadata), map.heights.rows(), map.heights.cols()));
    const auto pixel_size = map.pixel_size();
    const RadialBins bins(
        grid, pixel_size,
        std::min(static_cast<double>(lags.x) * pixel_size[0], static_cast<double>(lags.y) * pixel_size[1]));
    const auto blocks = static_cast<std::size_t>(fourier::block_count(lags.x + 1));
    std::vector<RadialBins::Row> partial(blocks, RadialBins::Row(static_cast<std::size_t>(bins.size())));
    for_each_lag_row(map, options.threads, [&](Index k, const double* values) {
        auto& sums = partial[static_cast<std::size_t>(k / fourier::lines_per_block)];
        bins.add(k, values, lags.y, k == 0 ? 1.0 : 2.0, sums);
    });
    RadialBins::Row sums(static_cast<std::size_t>(bins.size()));
    for (const auto& block : partial)
        for (std::size_t b = 0; b < sums.size(); ++b) {
            sums[b].distance += block[b].distance;
            sums[b].value += block[b].value;
            sums[b].vectors += block[b].vectors;
        }
    auto result = radial_average(sums, map.metadata);
    const double wavelength = shortest_reliable_wavelength(map, options.reliability, options.threads);
    result.reliable_from = std::max({0.5 * wavelength, pixel_size[0], pixel_size[1]});
    return result;
}

}  // namespace setae::scales
