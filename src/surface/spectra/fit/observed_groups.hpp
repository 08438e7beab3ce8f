// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "gap_factor.hpp"
#include "setae/spectral_fit/likelihood_spectrum.hpp"
#include "setae/spectral_fit/tip_response.hpp"
#include "whittle_fit.hpp"

namespace setae::spectral_fit {

/// Measurements of one shape by one instrument: what the fit sees of them and what they were.
struct ObservedGroup {
    PeriodogramClass data;
    std::optional<Probe> probe;  ///< none: heights as they are
    std::string probe_input;     ///< name of its size
    SharedFactor height, lateral;
    double pixel_size = 0.0;  ///< [m]; of curves the mean step
    double pitch = 0.0;       ///< between lines [m]
    Index lines = 1;          ///< of one measurement
    int trend_degree = 1;     ///< of the polynomial that each line loses
    double direction = 0.0;   ///< of its lines [rad]
    int measurements = 0;
    std::vector<Array1D> periodograms;             ///< of each measurement [m³]
    std::vector<double> skewness;                  ///< of the heights of each measurement with a tip
    double band_begin = 0.0;                       ///< highest of the measurements' untouched bands' begins [1/m]
    double band_end = 0.0;                         ///< geometric mean of the reliable bands' ends [1/m]
    Array1D mode_counts;                           ///< modes in each group of modes
    Array1D independent_share;                     ///< ω of each group of modes
    const topography::Profile* contour = nullptr;  ///< where it is a curve
    std::optional<OpticalTransfer> optics;
    Array1D end_response;  ///< of scans: what their last node's response grows by where the spectrum goes on one node
                           ///< further; empty of curves
    std::vector<GappedLines> gaps;  ///< of each measurement that has some
    Array1D gap_factor;             ///< that response and noise_response hold; empty: none yet
    SampledResponse tip;
};

/// From the lowest wavevector of the spectrum to q_s [1/m].
struct SpectrumRange {
    double lowest = 0.0;
    double shortest = 0.0;
};

/// @throws InvalidArgument without measurements or for a shortest wavelength that is not positive.
[[nodiscard]] SpectrumRange spectrum_range(std::span<const ObservedSurface> observed, const LikelihoodOptions& options);

/// Periodograms with their kernels, measurements of one shape averaged; freedoms are left to the fit. Curves stand
/// alone, are pointed to, and have the ω of equal steps until their spectrum is known. Gaps are bridged, and what that
/// does is left to the fit, too. Curves that no picture shows (any instrument but TEM) have a noise from point to
/// point.
[[nodiscard]] std::vector<ObservedGroup> observed_groups(std::span<const ObservedSurface> observed,
                                                         const SpectrumRange& range, const LikelihoodOptions& options);

}  // namespace setae::spectral_fit
