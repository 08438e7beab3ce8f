// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "setae/core/quantity.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/spectra/spectrum.hpp"
#include "setae/spectral_fit/log_spline.hpp"
#include "setae/spectral_fit/probe.hpp"
#include "setae/topography/detrend.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::spectral_fit {

/// Calibration factor of all heights, or of all lengths along the surface, of measurements.
struct SharedFactor {
    std::string input;            ///< name of the input; measurements with the same input have the same error. Empty:
                                  ///< none
    double relative_error = 0.0;  ///< relative standard error, >= 0
};

/// A measurement and the processing applied to it, which its expected periodogram must include.
struct ObservedSurface {
    topography::Measurement measurement;
    topography::Trend trend = topography::Trend::mean;
    int trend_degree = 0;  ///< degree of the polynomial along x that was additionally removed from maps and scans
    Band untouched{0.0, std::numeric_limits<double>::infinity()};  ///< unchanged waves [1/m]
    double direction = 0.0;           ///< direction of its lines (x of a map) on the surface, relative to the same axis
                                      ///< for all [rad]
    std::optional<Probe> probe = {};  ///< probe of the measurement; default: a sphere with the tip radius of its
                                      ///< instrument
    std::optional<OpticalTransfer> optics = {};
    std::string probe_input = {};  ///< name of the size of the probe; default: by instrument and probe
    SharedFactor height = {};      ///< calibration of its heights, which have been multiplied by the factor
    SharedFactor lateral = {};     ///< calibration of lengths along the surface, which have been multiplied by the
                                   ///< factor
};

struct LikelihoodOptions {
    double shortest_wavelength = 4e-10;  ///< 2π/q_s [m]: the surface has no shorter waves
    double bend = 0.25;         ///< prior standard deviation of the second difference of ln C_iso per 0.1 decade
    bool tip_factor = true;     ///< simulate tips; false: T = 1
    bool tip_band = true;       ///< use tip-based data only below 2π/l_c
    double min_transfer = 0.4;  ///< use tip-based data only for larger T
    int rounds = 5;             ///< maximum number of simulations of each tip; they end when T converges
    Index tip_points = 1024;    ///< size of the simulated patch across the measured lines …
    Index tip_length = 2048;    ///< … and along them
    std::uint64_t seed = 1;
    parallel::Threads threads;
};

/// Agreement of the periodograms of one instrument with the fit within one decade.
///
///   χ² = Σ 2ν (r − 1 − ln r)/(1 + 1/6ν),  r = P/E
///
/// over groups of modes: the deviance of gamma variates, each divided by its mean (to 1 % for ν >= 1), ν the number of
/// values in a group.
struct Agreement {
    std::string instrument;
    int decade = 0;               ///< 10^decade … 10^(decade+1) 1/m
    double ratio = 1.0;           ///< mean of P/E, weighted by ν
    double standard_error = 0.0;  ///< standard error of the ratio if the instrument agrees: √(Σ ν²/ν_own)/Σ ν, ν_own
                                  ///< the independent values of a group
    double chi_squared = 0.0;
    int groups = 0;
    double probability = 1.0;  ///< of a χ² as large, with the number of groups as degrees of freedom
};

/// Effect of a tip.
struct TipFactor {
    std::string instrument;
    std::string probe;   ///< such as "sphere, 10 nm"
    double size = 0.0;   ///< radius of its apex, or thickness of a foil [m]
    Array1D wavevector;  ///< [1/m]
    Array1D transfer;    ///< T
};

/// A surface whose features are longer along one direction, if maps or lines along several directions show it.
struct SurfaceStretch {
    double wavevector = 0.0;  ///< wavevector of the values [1/m]; the vector below is interpolated between wavevectors
    Estimate ratio;           ///< s: length of features along the long axis over that across
    Estimate direction;       ///< of the long axis against the x of lines [rad]
};

/// Response of the fit to an input shared by many measurements.
struct InputResponse {
    std::string input;      ///< name of the input
    Eigen::VectorXd theta;  ///< d theta for one standard error of the input
    Band log_band;          ///< change of ln of the ends of the band
};

/// INSTRUMENTS_DISAGREE below this probability of the χ² of an agreement: neighbouring groups share the window, so the
/// scatter of χ² is larger than that of its distribution.
inline constexpr double improbable_agreement = 1e-6;

/// One C_iso fitted to all measurements simultaneously.
struct LikelihoodSpectrum {
    /// Forty nodes per decade up to q_s; the band is from the lowest to the highest wavevector with data; the prior
    /// continues beyond it.
    spectra::Spectrum C_iso;
    Array1D log_standard_error;  ///< of ln C_iso, inputs included
    Eigen::MatrixXd design;  ///< ∂ ln C_iso/∂theta; ln C_iso = design · theta for surfaces that are not stretched
    Eigen::VectorXd theta;
    Eigen::MatrixXd covariance;  ///< of theta without the inputs below: scatter of the data and between measurements,
                                 ///< response of the tips, uncertain skewness, noise of the simulation
    std::vector<InputResponse> inputs;  ///< uncertain sizes of probes and calibrations, independent of each other and
                                        ///< of all else
    std::vector<Agreement> agreement;
    std::vector<TipFactor> tips;
    std::vector<SurfaceStretch>
        stretch;                ///< empty: isotropic within the errors; otherwise C_iso is the mean over directions
    Array1D C_along, C_across;  ///< of a stretched surface: C_iso for lines along and across its long direction
    int rounds = 0;
    int iterations = 0;         ///< of the last fit
    bool converged = false;     ///< otherwise the numbers are those of the last step
    std::vector<Alert> alerts;  ///< INSTRUMENTS_DISAGREE, MEASUREMENTS_SCATTER, ROLLOFF_NOT_SEEN

    /// Covariance of theta including every input: covariance + Σ θ_i θ_iᵀ.
    [[nodiscard]] Eigen::MatrixXd total_covariance() const;
};

/// Fits ln C_iso of an isotropic surface to the expected periodograms of all measurements: window, detrending, sampling
/// and aliases of scans and maps, the points of contours, noise of each instrument, and tips simulated on the current
/// estimate.
///
/// A tilt is removed from each line of maps and scans (a parabola or a higher polynomial if that was removed before).
/// Maps count with their number of independent lines. Gaps of lines are interpolated, and the expectation includes the
/// effect; lines with less than half of the points defined are left out. Same bytes for any number of threads.
/// @throws InvalidArgument if no measurement has a mode inside its band; exceptions of the kernels.
/// Source: Sykulski et al., Biometrika 106 (2019) 251; Guillaumin et al., J. R. Stat. Soc. B 84 (2022) 1539; trends,
/// contours and tips derived here.
[[nodiscard]] LikelihoodSpectrum likelihood_spectrum(std::span<const ObservedSurface> observed,
                                                     const LikelihoodOptions& options = {});

/// Spectra drawn from the normal distribution of theta without the errors of its inputs: row r is C_iso [m⁴] at the
/// wavevectors of the spectrum.
[[nodiscard]] Array2D drawn_spectra(const LikelihoodSpectrum& spectrum, Index count, std::uint64_t seed);

}  // namespace setae::spectral_fit
