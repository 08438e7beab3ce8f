// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/spectra/options.hpp"
#include "setae/spectra/spectrum.hpp"
#include "setae/topography/measurement.hpp"
#include "setae/topography/tiled_map.hpp"

namespace setae::spectra {

/// C1D of heights along x of a line scan.
///
///   C1D(q) = |h̃(q)|²/L,  h̃(q) = ∫ w h exp(−iqx) dx
///
/// For n equidistant points the modes are q_k = 2πk/L, k = 1 … n/2 (k = 0 is left out). If the last one is at the
/// Nyquist wavevector π/Δ (even n) it includes both signs, so Parseval's relation is
///   mean(w²h²) − (mean wh)² = (2/L) sum_k g_k C_k,  g = ½ for that mode, 1 otherwise.
/// The count is the number of lines. C1D of a map is the mean of n independent lines, n from the coherence of the map
/// along y (LineCoherence); its standard error is C1D/√n and, for Gaussian heights, 2n C1D/χ²_2n are the ends of its
/// interval. One line has no standard error.
/// @throws UndefinedDataError if a height is undefined, InvalidArgument as validate().
/// Source: [J17].
[[nodiscard]] MeasuredSpectrum power_spectrum(const topography::LineScan& scan, const SpectrumOptions& options = {});

/// C1D of a map as line scans along the fast axis x: the mean over the ny lines, one measurement. The trend is removed
/// from the map as a whole, then the mean from every line unless `trend` is none.
[[nodiscard]] MeasuredSpectrum power_spectrum(const topography::HeightMap& map, const SpectrumOptions& options = {});

/// C1D of a map larger than memory, in bands of `lines_together` scan lines; equal up to rounding. A trend other than
/// the mean needs an additional pass, a tip radius in the metadata another.
/// @throws as for a map, and as reliable_band of a tiled map.
[[nodiscard]] MeasuredSpectrum power_spectrum(const topography::TiledMap& map, Index lines_together,
                                              const SpectrumOptions& options = {});

/// C1D of a traced profile: polyline_power_spectrum, divided by segment_response if options.contour requires it, with
/// the size of the correction in the warning CONTOUR_STEPS. The reliable band ends at π/(mean step).
///
/// If the profile has the response of its trace and options.trace_response is set, C1D = (C_traced − K² N)/T²
/// (topography::TraceResponse), which may be negative for single modes but is correct on average. The band then ends
/// where the mean of C1D over neighbouring modes falls below twice its noise floor N (K/T)² or T² < 0.1; the warning
/// TRACE_NOISE gives this wavevector and both corrections there.
[[nodiscard]] MeasuredSpectrum power_spectrum(const topography::Profile& profile, const SpectrumOptions& options = {});

/// C1D of any measurement, by its kind.
[[nodiscard]] MeasuredSpectrum power_spectrum(const topography::Measurement& measurement,
                                              const SpectrumOptions& options = {});

/// Only the modes inside the reliable band, which then begins half a step below the first mode, where its cell begins.
[[nodiscard]] MeasuredSpectrum within_band(MeasuredSpectrum spectrum);

}  // namespace setae::spectra
