// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/arrays.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::topography {

/// Transfer function of the smoothing spline of a trace.
///
///   K(q) = 1/(1 + (smoothing_length/step)⁴ (2 − 2 cos(q step))²)
///
/// wavevectors [1/m].
[[nodiscard]] Array1D smoothing_transfer(const TraceResponse& response, const ArrayView1D& wavevectors);

/// Transfer function of a trace that is corrected: T(q) = K(q) exp(−(q blur)²/2), or 1 if the profile has jumps:
/// neither part of C = T² C_curve + C_jumps is known separately.
[[nodiscard]] Array1D trace_transfer(const TraceResponse& response, const ArrayView1D& wavevectors);

/// Minimum share T² of the power of a wave in the trace for a correction: below, the correction depends on the smallest
/// error of blur.
inline constexpr double min_trace_power = 0.1;
/// Minimum share of power for a profile with jumps, which is not corrected: C1D is low by less than a tenth.
inline constexpr double min_trace_power_with_jumps = 0.9;

/// Wavevector beyond which K² exp(−(q blur)²) is smaller than the minimum share, at most π/step [1/m].
[[nodiscard]] double trace_band_end(const TraceResponse& response);

}  // namespace setae::topography
