// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/parallel/for_each.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::texture {

/// Slope and area of a map.
///
///   Sdq² = ⟨z_x²⟩ + ⟨z_y²⟩,   Sdr = A/A_projected − 1
///
/// The first two are those of annex D of the standard: slopes over one pixel, each direction averaged over its pairs of
/// points; area of the triangles through the points, both diagonals averaged. Other programs put central differences
/// into the integrals Sdq² = ⟨z_x² + z_y²⟩, Sdr = ⟨sqrt(1 + z_x² + z_y²) − 1⟩; these are less sensitive to waves near
/// two pixels, and smaller. Source: ISO 25178-2:2021, 4.4 and D.3.
struct HybridParameters {
    double Sdq = 0.0;          ///< [1]
    double Sdr = 0.0;          ///< [1]
    double Sdq_central = 0.0;  ///< central differences, points with four defined neighbours; NaN without one [1]
    double Sdr_central = 0.0;  ///< the same slopes [1]
    Index defined = 0;         ///< number of heights
};

/// Three passes.
/// @throws UndefinedDataError if no pixel has four defined corners.
[[nodiscard]] HybridParameters hybrid_parameters(const topography::HeightMap& map, parallel::Threads threads = {});

}  // namespace setae::texture
