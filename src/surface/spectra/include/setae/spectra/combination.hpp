// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "setae/core/quantity.hpp"
#include "setae/spectra/log_grid.hpp"
#include "setae/spectra/power_spectrum.hpp"

namespace setae::spectra {

/// Weights of measurements in the same bin.
enum class Weighting {
    equal,             ///< arithmetic mean over measurements ([D19])
    per_instrument,    ///< arithmetic mean over instruments of the means of their measurements
    inverse_variance,  ///< by 1/(relative variance), from the number of modes and lines of a measurement in the bin
};

/// Multiplicity of each measurement: 1, or the number of times it was drawn in a resample.
using Multiplicity = std::vector<int>;

struct CombinationOptions {
    LogGrid grid;
    Weighting weighting = Weighting::equal;
    bool slope_correction = true;  ///< refer every value to the centre of the bin, see binned()
};

/// The measurements, each averaged in the bins of one grid: input of combine() and bootstrap().
struct BinnedSpectra {
    LogGrid grid;
    Index first_bin = 0;        ///< column 0 of the matrices
    Array1D wavevector;         ///< geometric centres of the bins [1/m]
    Array2D C1D;                ///< (measurement, bin) [m³]; NaN without a mode in its reliable band
    Array2D relative_variance;  ///< of each entry, from independent lines and modes, window included; NaN without a
                                ///< mode
    std::vector<std::string> instruments;  ///< of each measurement: type, otherwise name, otherwise "unknown"
};

/// Averages each measurement's C1D inside its reliable band over the bins.
///
/// For a steep spectrum the mean over a bin differs from C at its centre, most if a measurement has one mode in the bin
/// (up to 10^(0.05·slope)). With slope_correction each C_k is first multiplied by (q_k/q_c)^(−p), p = dlnC/dlnq the
/// local slope of the uncorrected combination, from a line through its logarithm over half a decade on either side, in
/// four rounds: within 1e-3 for a power law. p is limited to −6 … 2.
/// @throws InvalidArgument if no mode is in any band.
[[nodiscard]] BinnedSpectra binned(std::span<const MeasuredSpectrum> spectra, const CombinationOptions& options = {});

/// One C1D from many, at the geometric centres of the bins that are not empty. The band is from the lowest to the
/// highest wavevector used (of BinnedSpectra: edge of a bin); the standard error is that between measurements, NaN for
/// one; the count is the number of measurements.
struct CombinedSpectrum : Spectrum {
    Array1D instrument_count = {};  ///< number of different instruments in the bin
    LogGrid grid = {};
    std::vector<Alert> alerts = {};  ///< COVERAGE_GAP, SINGLE_INSTRUMENT_DECADE, SINGLE_MEASUREMENT_DECADE, DISAGREE
};

/// Mean over the measurements in each bin; a map is one measurement.
///
///   C = Σ w_i C_i/Σ w_i;   SE² = n/(n−1) Σ w_i² (C_i − C)²/(Σ w_i)²
///
/// The order of the measurements does not matter beyond rounding.
/// @throws InvalidArgument if no mode is in any band.
/// Source: [D19] (equal weights).
[[nodiscard]] CombinedSpectrum combine(std::span<const MeasuredSpectrum> spectra,
                                       const CombinationOptions& options = {});
[[nodiscard]] CombinedSpectrum combine(const BinnedSpectra& spectra, Weighting weighting = Weighting::equal);

}  // namespace setae::spectra
