// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/parallel/for_each.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::texture {

/// Slope and area of a map.
///
///   Sdq² = ⟨z_x² + z_y²⟩,   Sdr = ⟨sqrt(1 + z_x² + z_y²) − 1⟩
///
/// The standard leaves open how slopes come from points, so the two ways in use are both given.
/// Source: ISO 25178-2:2021, 4.3 and annex D.
struct HybridParameters {
    double Sdq = 0.0;               ///< central differences over two pixels, one-sided at edges, as most programs take them [1]
    double Sdr = 0.0;               ///< the same slopes in the integral [1]
    double Sdq_forward = 0.0;       ///< forward differences over one pixel, as spectra and roughness::real_space_parameters [1]
    double Sdr_triangulated = 0.0;  ///< area of the triangles through the points, both diagonals averaged, minus 1 [1]
    Index defined = 0;              ///< points with both central differences
};

/// Points with an undefined neighbour are left out of the first two. One pass each.
/// @throws UndefinedDataError where no point has both slopes, or no pixel four defined corners.
[[nodiscard]] HybridParameters hybrid_parameters(const topography::HeightMap& map, parallel::Threads threads = {});

}  // namespace setae::texture
