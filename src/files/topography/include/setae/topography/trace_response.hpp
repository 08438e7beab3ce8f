// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/arrays.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::topography {

/// What the smoothing spline of a trace does to waves.
///
///   K(q) = 1/(1 + (smoothing_length/step)⁴ (2 − 2 cos(q step))²)
///
/// wavevectors [1/m].
[[nodiscard]] Array1D smoothing_transfer(const TraceResponse& response, const ArrayView1D& wavevectors);

/// What a trace does to waves of the curve and what is undone: T(q) = K(q) exp(−(q blur)²/2), or 1 where the profile
/// has jumps: of C = T² C_curve + C_jumps neither part is known by itself.
[[nodiscard]] Array1D trace_transfer(const TraceResponse& response, const ArrayView1D& wavevectors);

/// Share of the power of a wave that a trace must keep (T²) to be corrected: below, the smallest error of blur decides.
inline constexpr double min_trace_power = 0.1;
/// The same of a profile with jumps, which stays as it is: C1D is low by less than a tenth.
inline constexpr double min_trace_power_with_jumps = 0.9;

/// Wavevector beyond which K² exp(−(q blur)²) is less, at most π/step [1/m].
[[nodiscard]] double trace_band_end(const TraceResponse& response);

}  // namespace setae::topography
