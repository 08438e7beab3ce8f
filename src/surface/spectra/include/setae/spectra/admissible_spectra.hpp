// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "setae/core/estimate.hpp"
#include "setae/spectra/self_affine.hpp"

namespace setae::spectra {

/// Published moments of a spectrum, each with its standard error (NaN or 0: exact).
struct StatedMoments {
    Estimate rms_height;        ///< h_rms [m], > 0
    Estimate rms_slope;         ///< h'_rms [1], > 0
    Estimate rms_curvature;     ///< h''_rms [1/m], > 0
    Estimate short_wavevector;  ///< q_s [1/m], > 0
};

/// Spectra compatible with stated moments.
struct AdmissibleSpectra {
    std::vector<SelfAffine> draws;
    double share = 1.0;  ///< share of the drawn sets of moments that have a self-affine spectrum
};

/// Draws self-affine spectra whose moments are compatible with the stated errors.
///
///   ln m_i = ln v_i − s_i²/2 + s_i z_i,   s_i² = ln(1 + (σ_i/v_i)²),   z_i standard normal, independent
///
/// Each moment is lognormal with mean v_i and standard deviation σ_i, so it is positive. A set is kept if a spectrum
/// with 0 < H < 1 and q_r < q_s has these moments (self_affine_with_moments()); other sets are inconsistent, because
/// the errors of three moments of one spectrum are not independent. Every quantity computed from a kept spectrum, such
/// as ∫ q² C_iso dq, is positive and is that of one surface.
/// count: >= 1. The same seed gives the same spectra; a larger count begins with the same spectra.
/// @throws InvalidArgument for moments that are not positive, count < 1, and if fewer than one set in a hundred is
/// admissible (contradictory moments).
[[nodiscard]] AdmissibleSpectra admissible_spectra(const StatedMoments& moments, int count, std::uint64_t seed);

}  // namespace setae::spectra
