// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "line_spectrum.hpp"
#include "setae/simulation/recipe.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::simulation {

/// All scans of a surface: with a tip those of one length on one strip, without a tip each on a line of its own.
[[nodiscard]] std::vector<topography::LineScan> stylus_scans(const KnownSurface& surface, const LineSpectrum& C1D,
                                                             const StylusProtocol& protocol, numerics::RandomKey key);

/// Scans of a smooth reference in the same session.
[[nodiscard]] std::vector<topography::LineScan> stylus_references(const StylusProtocol& protocol,
                                                                  numerics::RandomKey key);

/// Map `index` of the protocol, on a patch of its own.
[[nodiscard]] topography::HeightMap afm_scan(const KnownSurface& surface, const AfmProtocol& protocol,
                                             std::size_t index, numerics::RandomKey key);

/// Contour `index` of the protocol, on a line of its own; for a foil with thickness, on a patch.
[[nodiscard]] topography::Profile tem_contour(const KnownSurface& surface, const LineSpectrum& C1D,
                                              const TemProtocol& protocol, std::size_t index, numerics::RandomKey key);

}  // namespace setae::simulation
