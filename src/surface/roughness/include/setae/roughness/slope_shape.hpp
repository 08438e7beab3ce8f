// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/parallel/for_each.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::roughness {

/// Distribution of slopes in two dimensions, independent of their size: t² = |∇h|²/⟨|∇h|²⟩ in classes.
struct SlopeShape {
    Array1D share;   ///< share of each class; Σ = 1
    Array1D square;  ///< mean t² of each; Σ share · square = 1

    /// A_true/A_app = ⟨√(1 + h'² t²)⟩, h' the rms slope: Eq. (9) for Gaussian slopes, [D19] Eq. (S3) for these.
    /// Relative error from the classes below 1e-4 of the excess area. @throws InvalidArgument for a negative slope.
    [[nodiscard]] double area_ratio(double rms_slope) const;
};

/// Distribution for the triangles of triangulated_area(). Classes: forty per decade of t², 1e-6 … 1e4.
/// @throws UndefinedDataError if no cell has four defined corners, or all are level.
[[nodiscard]] SlopeShape slope_shape(const topography::HeightMap& map, parallel::Threads threads = {});

/// Distribution of a map with known rms slope from triangulated_area().
[[nodiscard]] SlopeShape slope_shape(const topography::HeightMap& map, double rms_slope, parallel::Threads threads);

/// A distribution and its weight among several maps.
struct WeighedShape {
    SlopeShape shape;
    double area = 0.0;  ///< of the map [m²]
};
/// Mean weighted by area: tips change the slopes of small maps most. @throws InvalidArgument for an empty list.
[[nodiscard]] SlopeShape mean_shape(const std::vector<WeighedShape>& shapes);

}  // namespace setae::roughness
