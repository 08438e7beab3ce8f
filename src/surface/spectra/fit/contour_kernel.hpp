// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/arrays.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/spectral_fit/mode_bins.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::spectral_fit {

/// Periodogram of a traced contour and its expectation for a surface, with the same linear operator, so neither the
/// spacing of the points nor the interpolation between them causes a bias.
///
///   P_k = |A h|²_k/L,   A = (L/n_f) F(w ∘ S)(I − VVᵀ),   k = 1 … L/(2 mean step)
///   E[P_k] = (1/2πL) ∫_0^{q_s} (|A e^{iqx}|² + |A e^{−iqx}|²)_k C1D(q) dq
///
/// V: orthonormal basis of the line over the points. S: natural cubic spline onto n_f equidistant positions, four per
/// mean step. w: Hann by position with ∫w² dx = L. C_iso is given at nodes q_i = q_s e^{h(i − N)}, i = 0 … N
/// (hat_node.hpp), the last one with its lower half only, constant below the first. |A e^{iqx}|² is linear between
/// wavevectors 2π/(4L) apart, beyond the 512th mode q/2048 apart: groups of modes contain dozens there.
///
/// If the profile has the response of its trace (topography::TraceResponse), its waves have T(q)² C1D(q), and the
/// expectation includes its point-to-point noise, smoothed with K:
///
///   E[noise] = (1/2πL) ∫_0^π (|A a e^{iνk}|² + |A a e^{−iνk}|²) K(ν/step)² dν,   Σ a_k² d_k² = N L
///
/// a_k: proportional to the standard errors of the points k (equal if unknown), d_k: their share of the length, so that
/// long waves of the noise have C1D N. Source: derived here; the likelihood of expected periodograms is that of
/// Sykulski et al., Biometrika 106 (2019) 251.
struct ContourKernel {
    ModeBins bins;
    double length = 0.0;  ///< L [m]
    Array1D periodogram;  ///< means over groups of modes [m³]
    Array2D response;     ///< (group, node): E[P] = Σ_i response C_iso(q_i) [1/m]
    Array1D noise;        ///< E[P] of the stated noise of the trace [m³]; empty if unknown
};

/// Only the periodogram [m³], one value for each of ModeBins(modes).
[[nodiscard]] Array1D contour_periodogram(const topography::Profile& contour);

/// nodes: q_i [1/m], increasing by the factor e^h, the last one q_s. O(waves · points log points), waves ~ 2048 ln(q_s
/// L). @throws InvalidArgument for fewer than 8 points or as validate(); UndefinedDataError for undefined heights.
[[nodiscard]] ContourKernel contour_kernel(const topography::Profile& contour, const ArrayView1D& nodes,
                                           parallel::Threads threads = {});

/// E[P] of independent errors of the points, each of variance 1 m² [m]: mean over 512 draws, accurate to 4 % for single
/// modes and better for groups.
/// @throws as contour_kernel.
[[nodiscard]] Array1D white_noise(const topography::Profile& contour, parallel::Threads threads = {});

/// Independent share of a mode, for each group: neighbouring modes share the window, and irregular points scatter power
/// over all modes.
///
///   ω_k = 1/Σ_k' (|G_kk'|² + |H_kk'|²)/(G_kk G_k'k'),   G = ⟨F F†⟩, H = ⟨F Fᵀ⟩ of the transforms F = A h
///
/// of Gaussian heights with this spectrum and the noise of their trace, at the mode in the middle of each group. 0.514
/// for Hann on equidistant points. C_iso: at the nodes [m⁴].  O(groups · modes · q_s L).
/// @throws as contour_kernel.
[[nodiscard]] Array1D independent_share(const topography::Profile& contour, const ArrayView1D& nodes,
                                        const ArrayView1D& C_iso, parallel::Threads threads = {});

}  // namespace setae::spectral_fit
