// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/spectra/spectrum.hpp"

namespace setae::spectra {

/// Ends of an interval at each wavevector, in the unit of the density.
struct SpectrumInterval {
    Array1D lower, upper;
};

/// Interval of C1D of one measurement, for Gaussian heights.
///
///   2n C1D/χ²_2n((1 + level)/2) … 2n C1D/χ²_2n((1 − level)/2)
///
/// n: independent lines of each mode. One line, n = 1, determines C1D of a mode to a factor of 40 in either direction.
/// NaN if a correction leads to C1D <= 0. level: in (0, 1). @throws InvalidArgument outside it, and for a spectrum
/// without independent lines. Source: Brillinger, Time Series (2001) ch. 5; coverage in docs/validation/spectra.md.
[[nodiscard]] SpectrumInterval interval_of(const MeasuredSpectrum& spectrum, double level = 0.95);

}  // namespace setae::spectra
