// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/spectra/power_spectrum.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::spectra {

/// Frees the spectrum of a traced curve of what tracing did, C1D = (C_traced − R K² N)/T², ends its band where the
/// trace's noise or its blur takes over, and says so by the alert TRACE_NOISE.
///
/// R: what C_traced itself keeps of the samples' noise, 1 where the spectrum has been divided by segment_response.
/// Beyond the band T² counts as min_trace_power, so that no number runs away. Negative values stay: clipped ones
/// would lift the mean. spectrum: increasing wavevectors.
void correct_for_trace(MeasuredSpectrum& spectrum, const topography::TraceResponse& response,
                       const ArrayView1D& kept_by_segments);

}  // namespace setae::spectra
