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
/// Of n equidistant points the modes are q_k = 2πk/L, k = 1 … n/2 (k = 0 is left out). Where the last one lies at the
/// Nyquist wavevector π/Δ (even n) it stands for both signs, so that Parseval reads
///   mean(w²h²) − (mean wh)² = (2/L) sum_k g_k C_k,  g = ½ for that mode, 1 otherwise.
/// The count is that of lines. C1D of a map is the mean of n independent lines, n from the map's own coherence along y
/// (LineCoherence); its standard error is C1D/√n and, for Gaussian heights, 2n C1D/χ²_2n are the ends of its interval.
/// One line has no standard error of its own.
/// @throws UndefinedDataError if a height is undefined, InvalidArgument if validate() does.
/// Source: [J17].
[[nodiscard]] MeasuredSpectrum power_spectrum(const topography::LineScan& scan, const SpectrumOptions& options = {});

/// Of a map as line scans along the fast axis x: the mean over the ny lines, ONE measurement.
/// The trend is removed from the map as a whole, then the mean from every line where `trend` is not none.
[[nodiscard]] MeasuredSpectrum power_spectrum(const topography::HeightMap& map, const SpectrumOptions& options = {});

/// The same of a map larger than memory, by bands of `lines_together` scan lines; equal to the above up to rounding. A
/// trend other than the mean takes a pass of its own, a tip radius in the metadata another.
/// @throws as of a map, and as reliable_band of a tiled map.
[[nodiscard]] MeasuredSpectrum power_spectrum(const topography::TiledMap& map, Index lines_together,
                                              const SpectrumOptions& options = {});

/// Of a traced profile: polyline_power_spectrum, divided by segment_response where options.contour asks for it, with
/// the alert CONTOUR_STEPS that says how large the correction is. The reliable band ends at π/(mean step).
///
/// Where the profile knows the response of its trace and options.trace_response asks for it, then C1D = (C_traced − K²
/// N)/T² (topography::TraceResponse), which may be negative for single modes but is right on average. The band then
/// ends where the mean of C1D over neighbouring modes is no longer twice its noise floor N (K/T)² or T² < 0.1; the
/// alert TRACE_NOISE tells where and how large both corrections are there.
[[nodiscard]] MeasuredSpectrum power_spectrum(const topography::Profile& profile, const SpectrumOptions& options = {});

/// Of any measurement, by its kind.
[[nodiscard]] MeasuredSpectrum power_spectrum(const topography::Measurement& measurement,
                                              const SpectrumOptions& options = {});

/// Only the modes inside the reliable band, which then begins half a step below the first: where its cell does.
[[nodiscard]] MeasuredSpectrum within_band(MeasuredSpectrum spectrum);

}  // namespace setae::spectra
