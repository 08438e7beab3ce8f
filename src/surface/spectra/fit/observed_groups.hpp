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

/// Measurements of one shape by one instrument: input of the fit and its origin.
struct ObservedGroup {
    PeriodogramClass data;
    std::optional<Probe> probe;  ///< none: unmodified heights
    std::string probe_input;     ///< name of the size of the probe
    SharedFactor height, lateral;
    double pixel_size = 0.0;  ///< [m]; for curves the mean step
    double pitch = 0.0;       ///< between lines [m]
    Index lines = 1;          ///< of one measurement
    int trend_degree = 1;     ///< degree of the polynomial removed from each line
    double direction = 0.0;   ///< of its lines [rad]
    int measurements = 0;
    std::vector<Array1D> periodograms;             ///< of each measurement [m³]
    std::vector<double> skewness;                  ///< of the heights of each measurement with a tip
    double band_begin = 0.0;                       ///< highest beginning of the untouched bands of the measurements
                                                   ///< [1/m]
    double band_end = 0.0;                         ///< geometric mean of the ends of the reliable bands [1/m]
    Array1D mode_counts;                           ///< modes in each group of modes
    Array1D independent_share;                     ///< ω of each group of modes
    const topography::Profile* contour = nullptr;  ///< if it is a curve
    std::optional<OpticalTransfer> optics;
    Array1D end_response;  ///< for scans: increase of the response of the last node if the spectrum continues by one
                           ///< node; empty for curves
    std::vector<GappedLines> gaps;  ///< of each measurement with gaps
    Array1D gap_factor;             ///< included in response and noise_response; empty: not yet
    SampledResponse tip;
};

/// From the lowest wavevector of the spectrum to q_s [1/m].
struct SpectrumRange {
    double lowest = 0.0;
    double shortest = 0.0;
};

/// @throws InvalidArgument without measurements or for a shortest wavelength that is not positive.
[[nodiscard]] SpectrumRange spectrum_range(std::span<const ObservedSurface> observed, const LikelihoodOptions& options);

/// Periodograms with their kernels, with measurements of one shape averaged; the fit sets the freedoms. Curves are
/// separate groups, are referenced, and have the ω of equal steps until their spectrum is known. Gaps are interpolated;
/// the fit accounts for the effect. Curves without a picture (any instrument except TEM) have point-to-point noise.
[[nodiscard]] std::vector<ObservedGroup> observed_groups(std::span<const ObservedSurface> observed,
                                                         const SpectrumRange& range, const LikelihoodOptions& options);

}  // namespace setae::spectral_fit
