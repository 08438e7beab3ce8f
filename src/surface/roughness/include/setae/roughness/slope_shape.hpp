// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/parallel/for_each.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::roughness {

/// How slopes of both directions are distributed, whatever their size: t² = |∇h|²/⟨|∇h|²⟩ in classes.
struct SlopeShape {
    Array1D share;   ///< of the classes' slopes; Σ = 1
    Array1D square;  ///< mean t² of each; Σ share · square = 1

    /// A_true/A_app = ⟨√(1 + h'² t²)⟩, h' the rms slope: (9) for Gaussian slopes, [D19] (S3) for these.
    /// Relative error by the classes below 1e-4 of the excess area. @throws InvalidArgument for a negative slope.
    [[nodiscard]] double area_ratio(double rms_slope) const;
};

/// Of the triangles that triangulated_area() sums over. Classes: forty per decade of t², 1e-6 … 1e4.
/// @throws UndefinedDataError where no cell has four defined corners, or all are level.
[[nodiscard]] SlopeShape slope_shape(const topography::HeightMap& map, parallel::Threads threads = {});

/// The same of a map whose rms slope triangulated_area() gave already.
[[nodiscard]] SlopeShape slope_shape(const topography::HeightMap& map, double rms_slope, parallel::Threads threads);

/// A map's share of what is known of a surface's slopes.
struct WeighedShape {
    SlopeShape shape;
    double area = 0.0;  ///< of the map [m²]
};
/// Mean by area: small maps are those whose slopes tips change most. @throws InvalidArgument for none.
[[nodiscard]] SlopeShape mean_shape(const std::vector<WeighedShape>& shapes);

}  // namespace setae::roughness
