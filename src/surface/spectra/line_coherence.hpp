// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/core/arrays.hpp"
#include "setae/fourier/buffer.hpp"
#include "setae/fourier/transform.hpp"
#include "setae/parallel/for_each.hpp"

namespace setae::spectra {

/// Number of independent lines among the N lines of a map, for each mode k of their mean periodogram.
///
///   a_j: mode k of line j;   S_m = |Σ_j a_j exp(−2πi jm/N)|²/N,  m = 0 … N − 1
///   n = [(Σ S)² − Σ S²]/(½ Σ S²),  between 1 and N
///
/// Heights are Gaussian, so Var(Σ S) = Σ s² with s = E S, E Σ S² = 2 Σ s² and E (Σ S)² = (Σ s)² + Σ s². C1D of the map
/// has the relative variance
///
///   1/n = Σ s²/(Σ s)² = (2π/L_y) ∫ C2D² dq_y/(∫ C2D dq_y)²
///
/// and (Σ S)² − ½ Σ S² over ½ Σ S² estimates n without bias of numerator or denominator. The additional subtraction of
/// ½ Σ S² lowers n by one. Half of that corrects for the transform, which treats the map as periodic in y and so
/// underestimates the variance if the correlation extends across the map; half allows for the error of n. Limits: N − 1
/// for white noise, 1 for a corrugation along y. If k is the Nyquist wavevector the modes are real and Var(Σ S) = 2 Σ
/// s².
///
/// The first 128 modes have a separate n each. For shorter waves n is computed for one mode in each sixteenth of a
/// decade, and is linear between them. Memory: N values per evaluated mode.
class LineCoherence {
public:
    /// points, lines: of the map.
    LineCoherence(Index points, Index lines);

    /// Stores the transform of one line: modes 0 … points/2. Lines may come from any thread.
    void take(Index line, const fourier::Complex* modes);

    /// n of each mode 1 … points/2. Call once, after all lines.
    [[nodiscard]] Array1D independent_lines(parallel::Threads threads);

private:
    Index points_, lines_;
    std::vector<Index> modes_;                  ///< evaluated modes, increasing
    fourier::Buffer<fourier::Complex> values_;  ///< lines of each evaluated mode
    Index stride_;                              ///< distance of modes; keeps the alignment of the transform
};

}  // namespace setae::spectra
