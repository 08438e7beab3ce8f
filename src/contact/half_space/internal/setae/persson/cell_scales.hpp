// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/half_space/grid.hpp"
#include "setae/persson/scales.hpp"
#include "setae/spectra/spectral_density.hpp"

namespace setae::persson {

/// The scales of a periodic cell, which contains only waves of certain lengths and directions:
///
///   V(q) = Σ k² C_iso/A,   U(q) = ½ Σ k C_iso/A   over the modes up to q
///
/// A: area of the cell. scales_of() gives the integrals for a large cell. All waves of one length are added together:
/// between their V and that of the waves before V and U increase together, in steps of a per cent, at one q. @throws
/// InvalidArgument for a grid or a body outside its domain; UndefinedDataError where no mode has power.
[[nodiscard]] Scales scales_of_cell(const spectra::SpectralDensity& C_iso, const half_space::Grid& grid,
                                    const half_space::Body& body);

}  // namespace setae::persson
