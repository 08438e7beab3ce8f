// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "setae/core/arrays.hpp"

namespace setae::spectra {

/// Window applied to heights before a transform, scaled to sum w² = n (for polylines ∫w² dx = L), which keeps the mean
/// square of the heights on average.
enum class Window {
    automatic,  ///< hann for non-periodic data, none for periodic data
    none,
    hann,             ///< 1 − cos t, t = 2πx/L; for maps the product of both directions
    blackman_harris,  ///< four cosine terms, side lobes at −92 dB, for spectra that fall over many decades
    radial_hann,      ///< maps only: 1 + cos(2πr/min(L_x, L_y)) within the largest circle, 0 outside
};

/// Coefficients a_m of the window as sum_m a_m cos(m t), scaled to a_0² + ½ sum_{m>0} a_m² = 1.
/// @throws InvalidArgument for radial_hann, which is no function of one coordinate, and for automatic.
/// Source: Harris, Proc. IEEE 66 (1978) 51, Table 1 (0.35875, −0.48829, 0.14128, −0.01168).
[[nodiscard]] std::span<const double> cosine_coefficients(Window window);

/// Values at t = 2πj/n, j = 0 … n−1, with sum w² = n exactly.
[[nodiscard]] Array1D window_values(Window window, Index n);

/// Replaces `automatic` by the resulting window.
[[nodiscard]] Window resolved(Window window, bool periodic);

/// "automatic", "none", "hann", "blackman_harris", "radial_hann". @throws InvalidArgument that lists them.
[[nodiscard]] Window window_from_name(const std::string& name);
[[nodiscard]] std::string name(Window window);

}  // namespace setae::spectra
