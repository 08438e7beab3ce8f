// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <vector>

#include "setae/core/arrays.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/spectral_fit/mode_bins.hpp"

namespace setae::spectral_fit {

/// Conversion of a line of equidistant points to a periodogram.
struct ScanShape {
    Index points = 0;
    int trend_degree =
        1;  ///< polynomial removed by least squares before the Hann window: 0 mean, 1 tilt, 2 parabola … 12

    friend auto operator<=>(const ScanShape&, const ScanShape&) = default;
};

/// Periodogram of lines of equidistant points, averaged over the lines and over groups of modes.
///
///   P_k = (Δ/n) |F(w ∘ (I − VVᵀ) h)|²_k,  k = 1 … n/2,  w Hann with Σw² = n, V an orthonormal basis of the trend
///
/// heights: (points, lines) [m]; pixel_size Δ [m]. One value [m³] for each of ModeBins(n/2).
/// @throws InvalidArgument for fewer than 8 points or a degree outside 0 … 12; UndefinedDataError for undefined
/// heights.
[[nodiscard]] Array1D scan_periodogram(const ArrayView2D& heights, double pixel_size, int trend_degree,
                                       parallel::Threads threads = {});

/// Expectation of that periodogram for a surface, exact in window, detrending, sampling and all aliases.
///
/// C_iso is given at nodes (hat_node.hpp) with q_jΔ = e^{jh}, so one kernel applies to every pixel size. With R_j the
/// autocovariance of a node, a(m) = Σ_i w_i w_{i+m} and u_l = F(w ∘ V_l):
///
///   E[P_k] = (Δ/n) [ a(0)R(0) + 2 Σ_m a(m) R(mΔ) cos(2πkm/n) − 2 Σ_l Re(ū_l F(w ∘ RV_l))_k + Σ_lm Re(u_l ū_m)_k
///   V_lᵀRV_m ]
///
/// Source: the expected periodogram of Sykulski et al., Biometrika 106 (2019) 251; detrending derived here.
struct ScanKernel {
    Index first_node = 0;  ///< j of column 0
    Array2D response;  ///< (group of modes, node): E[P] Δ/C_iso(q_j) [1]; columns scale as E[P] = Σ_j response f_j/Δ
    Array1D flat_response;   ///< response for C_iso constant below the first node
    Array1D noise_response;  ///< E[P]/(Δσ²) for white noise of variance σ² in every point
};

/// The kernel for nodes first … last. Computed columns are kept for the lifetime of the process. O(n log n) per node.
/// @throws InvalidArgument as scan_periodogram, or for last < first.
[[nodiscard]] ScanKernel scan_kernel(const ScanShape& shape, Index first_node, Index last_node,
                                     parallel::Threads threads = {});

}  // namespace setae::spectral_fit
