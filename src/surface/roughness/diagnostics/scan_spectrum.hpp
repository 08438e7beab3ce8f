// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/parallel/for_each.hpp"
#include "setae/spectra/power_spectrum.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::diagnostics {

/// C1D of the scan lines of a level map without undefined heights, modes 1 … n/2, Hann window unless it is periodic.
[[nodiscard]] spectra::MeasuredSpectrum scan_spectrum(const topography::HeightMap& map, parallel::Threads threads);

/// Expectation of a mode k under the window for C1D ∝ k^−exponent, over k^−exponent: the Hann window mixes each mode
/// with adjacent ones.
[[nodiscard]] double window_gain(double mode, double exponent, bool hann);

}  // namespace setae::diagnostics
