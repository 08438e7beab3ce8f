// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/arrays.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/spectra/spectral_density.hpp"

namespace setae::spectral_fit {

/// Independent lines among N lines of a map a pitch apart, for modes at wavevectors q:
///
///   n = N²/Σ_ij ρ²(y_i − y_j),   ρ(y) = [∫_0^∞ C_iso(√(q² + p²)) cos(py) dp/(integral for y = 0)]
///
/// wavevectors, pitch > 0 [1/m, m]. signal: share of the surface, as opposed to noise, in the expectation of the
/// periodogram at each q (noise is independent from line to line).
[[nodiscard]] Array1D independent_lines(const spectra::SpectralDensity& C_iso, const ArrayView1D& wavevectors,
                                        const ArrayView1D& signal, Index lines, double pitch,
                                        parallel::Threads threads = {});

}  // namespace setae::spectral_fit
