// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/core/arrays.hpp"

namespace setae::imaging {

/// Transfer function of a smoothing spline for a wave q [1/px]: K(q) = 1/(1 + ℓ⁴ (2 − 2 cos q)²), ℓ: its length [px].
[[nodiscard]] double spline_transfer(double wavevector, double length);

/// Mean of K over all waves, (1/π) ∫_0^π K dq: the share of its own noise in a smoothed place.
[[nodiscard]] double mean_spline_transfer(double length);

/// Spectrum of places along a contour, a pixel apart.
struct PlaceSpectrum {
    std::vector<double> wavevector;  ///< 0.08 … π, 24 bins of equal ratio [1/px]
    std::vector<double> density;     ///< C1D [px³]
    std::vector<double> width;       ///< of the bins [1/px]
};

/// By Hann's window, 12 modes a bin. O(300 n).
[[nodiscard]] PlaceSpectrum place_spectrum(Array1D heights);

/// Expected squared error [px²] of places with noise of density N [px³], smoothed over ℓ:
///   (1/π) ∫ [(1 − K)² S + K² N] dq,   S = max(0, density − N)
[[nodiscard]] double expected_squares(const PlaceSpectrum& places, double noise, double length);

/// ℓ in 0.2 … 12 px, by steps of 7 %, with the least expected squared error.
[[nodiscard]] double best_smoothing(const PlaceSpectrum& places, double noise);

/// Variance times the correlation length of neighbours, over 8 lags with Bartlett's weights: the spectral density of
/// the longest waves of a series. Source: Newey, West, Econometrica 55 (1987) 703.
[[nodiscard]] double long_run_variance(const Array1D& series);

}  // namespace setae::imaging
