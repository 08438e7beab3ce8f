// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/synthesis/random_surface.hpp"

#include <cmath>

#include "setae/core/summation.hpp"
#include "setae/fourier/inverse_map_transform.hpp"
#include "setae/synthesis/rms_height.hpp"
#include "setae/synthesis/surface_modes.hpp"

namespace setae::synthesis {
namespace {

/// √⟨h²⟩ of heights of zero mean, row sums added in a fixed order.
double rms(const Array2D& heights, parallel::Threads threads) {
    Array1D sums(heights.rows());
    parallel::for_each_index(static_cast<std::size_t>(heights.rows()), threads, [&](std::size_t row) {
        const Index i = static_cast<Index>(row);
        sums[i] = heights.row(i).square().sum();
    });
    return std::sqrt(pairwise_sum(sums) / static_cast<double>(heights.size()));
}

}  // namespace

topography::HeightMap random_surface(const spectra::SpectralDensity& C_iso, const SurfaceGrid& grid,
                                     const SurfaceOptions& options) {
    if (options.exact_rms_height) require_rms_height(*options.exact_rms_height);
    const SurfaceModes modes(C_iso, grid, options);
    topography::HeightMap map{
        .heights = Array2D(grid.nx, grid.ny), .size = {grid.size_x, grid.size_y}, .periodic = true};
    fourier::inverse_transform_map([&](Index ky, fourier::Complex* line) { modes.line(ky, line); }, map.heights,
                                   options.threads);
    if (!options.exact_rms_height) return map;
    const double factor = scale_to(*options.exact_rms_height, rms(map.heights, options.threads));
    parallel::for_each_index(static_cast<std::size_t>(grid.nx), options.threads,
                             [&](std::size_t row) { map.heights.row(static_cast<Index>(row)) *= factor; });
    return map;
}

ExpectedRoughness expected_roughness(const spectra::SpectralDensity& C_iso, const SurfaceGrid& grid,
                                     const SurfaceOptions& options) {
    const SurfaceModes modes(C_iso, grid, options);
    Array1D height(grid.ny / 2 + 1), slope(grid.ny / 2 + 1);
    parallel::for_each_index(static_cast<std::size_t>(height.size()), options.threads, [&](std::size_t line) {
        const Index ky = static_cast<Index>(line);
        const auto sums = modes.sums(ky);
        height[ky] = sums.height_square;
        slope[ky] = sums.slope_square;
    });
    return {std::sqrt(pairwise_sum(height)), std::sqrt(pairwise_sum(slope))};
}

}  // namespace setae::synthesis
