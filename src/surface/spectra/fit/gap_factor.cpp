// SPDX-License-Identifier: GPL-3.0-or-later
#include "gap_factor.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/synthesis/random_surface.hpp"
#include "setae/topography/gaps.hpp"

namespace setae::spectral_fit {
namespace {

constexpr Index max_lines_kept = 64;
constexpr Index min_simulated = 16, max_simulated = 256;
constexpr Index heights_simulated = Index{1} << 22;
constexpr double min_defined = 0.5;

}  // namespace

BridgedLines bridged_lines(const Array2D& heights, const std::string& label) {
    std::vector<Index> used, gapped;
    for (Index j = 0; j < heights.cols(); ++j) {
        const auto undefined_points = static_cast<double>(heights.col(j).isNaN().count());
        if (undefined_points > (1.0 - min_defined) * static_cast<double>(heights.rows())) continue;
        used.push_back(j);
        if (undefined_points > 0.0) gapped.push_back(j);
    }
    if (used.empty())
        throw UndefinedDataError(fmt::format("{}: in no line along x are half of the heights defined", label));
    const Index kept = std::min(max_lines_kept, std::ssize(gapped));
    BridgedLines result{
        Array2D(heights.rows(), std::ssize(used)),
        {{heights.rows(), kept}, static_cast<double>(gapped.size()) / static_cast<double>(used.size())}};
    for (Index l = 0; l < kept; ++l)
        result.gaps.undefined.col(l) =
            heights.col(gapped[static_cast<std::size_t>(l * std::ssize(gapped) / kept)]).isNaN();
    for (Index j = 0; j < std::ssize(used); ++j) {
        Array1D line = heights.col(used[static_cast<std::size_t>(j)]);
        topography::bridge_gaps(line);
        result.heights.col(j) = line;
    }
    return result;
}

Array1D gap_factor(const GappedLines& gaps, const ScanShape& shape, double pixel_size,
                   const spectra::SpectralDensity& C1D, std::uint64_t seed, parallel::Threads threads) {
    const Index n = shape.points, masks = gaps.undefined.cols();
    if (masks == 0) return Array1D::Ones(ModeBins(n / 2).size());
    const Index wanted = std::clamp(heights_simulated / n, min_simulated, max_simulated);
    const Index repeats = (wanted + masks - 1) / masks, count = repeats * masks;
    Array2D whole(n, count), bridged(n, count);
    parallel::for_each_index(static_cast<std::size_t>(count), threads, [&](std::size_t index) {
        const auto l = static_cast<Index>(index);
        // a period twice as long: the ends of a scan are independent
        const auto line = synthesis::random_line(C1D, {2 * n, 2.0 * static_cast<double>(n) * pixel_size},
                                                 {.key = {seed, static_cast<std::uint64_t>(index)}, .threads = {1}});
        Array1D values = line.heights.head(n);
        whole.col(l) = values;
        values = gaps.undefined.col(l % masks).select(std::numeric_limits<double>::quiet_NaN(), values);
        topography::bridge_gaps(values);
        bridged.col(l) = values;
    });
    const Array1D ratio = scan_periodogram(bridged, pixel_size, shape.trend_degree, threads) /
                          scan_periodogram(whole, pixel_size, shape.trend_degree, threads);
    return 1.0 + gaps.share * (ratio - 1.0);
}

}  // namespace setae::spectral_fit
