// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/parallel/for_each.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::roughness {

/// True over projected area of a surface with Gaussian isotropic slopes.
///
///   A_true/A_app = 1 + (√π/2) h' exp(1/h'²) erfc(1/h')
///
/// rms_slope: h' = sqrt⟨|∇h|²⟩ [1], >= 0.  Small slopes: 1 + h'²/2; large: (√π/2) h'.
/// @throws InvalidArgument for a negative slope.
/// Source: [D19] Eqs. (9), (S9).
[[nodiscard]] double gaussian_area_ratio(double rms_slope);

/// Ratio of the excess area of Gaussian slopes to its small-slope value: g(h') with A_true/A_app = 1 + ½ h'² g(h');
/// g(0) = 1, g(1) = 0.7579. Source: [D19] Eqs. (S11), (S12).
[[nodiscard]] double area_excess_factor(double rms_slope);

/// Small-slope limit 1 + h'²/2. Source: [D19] Eq. (S4).
[[nodiscard]] double small_slope_area_ratio(double rms_slope);

/// Area of the triangles through the heights.
struct TriangulatedArea {
    double area_ratio =
        0.0;  ///< true over projected area of the cells with four defined corners, both diagonals averaged
    double rms_slope = 0.0;  ///< sqrt⟨|∇h|²⟩ of the same triangles
    Index cells = 0;
};

/// Cost: linear, one pass. @throws UndefinedDataError if no cell has four defined corners.
/// Source: [D19] Eq. (S3).
[[nodiscard]] TriangulatedArea triangulated_area(const topography::HeightMap& map, parallel::Threads threads = {});

}  // namespace setae::roughness
