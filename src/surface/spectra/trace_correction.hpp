// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/spectra/power_spectrum.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::spectra {

/// Corrects the spectrum of a traced curve for the effects of tracing, C1D = (C_traced − R K² N)/T², ends its band
/// where noise or blur of the trace dominate, and adds the warning TRACE_NOISE.
///
/// R: share of the noise of the samples in C_traced, 1 if the spectrum has been divided by segment_response. Beyond the
/// band T² is at least min_trace_power, which limits the correction. Negative values are kept: clipping would raise the
/// mean. spectrum: increasing wavevectors.
void correct_for_trace(MeasuredSpectrum& spectrum, const topography::TraceResponse& response,
                       const ArrayView1D& kept_by_segments);

}  // namespace setae::spectra
