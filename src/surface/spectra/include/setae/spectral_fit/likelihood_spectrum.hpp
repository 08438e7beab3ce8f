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

/// A factor that all heights, or all lengths along the surface, of measurements are known to: their calibration.
struct SharedFactor {
    std::string input;            ///< name of the input; measurements that share it are wrong together. Empty: none
    double relative_error = 0.0;  ///< its standard error over its value, >= 0
};

/// A measurement and what was already taken from it, which its expected periodogram must know.
struct ObservedSurface {
    topography::Measurement measurement;
    topography::Trend trend = topography::Trend::mean;
    int trend_degree = 0;  ///< of the polynomial along x that maps and scans have lost besides
    Band untouched{0.0, std::numeric_limits<double>::infinity()};  ///< waves that are as they were [1/m]
    double direction = 0.0;           ///< of its lines (x of a map) on the surface, against the same axis for all [rad]
    std::optional<Probe> probe = {};  ///< that it was read with; without it a sphere of its instrument's tip radius
    std::optional<OpticalTransfer> optics = {};
    std::string probe_input = {};  ///< name of the probe's size; empty: by instrument and probe
    SharedFactor height = {};      ///< of its heights, which have been multiplied with its value
    SharedFactor lateral = {};     ///< of lengths along the surface, likewise
};

struct LikelihoodOptions {
    double shortest_wavelength = 4e-10;  ///< 2π/q_s [m]: the surface has no shorter waves
    double bend = 0.25;         ///< prior standard deviation of the second difference of ln C_iso per 0.1 decade
    bool tip_factor = true;     ///< simulate tips; false: T = 1
    bool tip_band = true;       ///< use tip-based data below 2π/l_c alone
    double min_transfer = 0.4;  ///< use tip-based data where T is larger
    int rounds = 5;             ///< most simulations of each tip; they end when T settles
    Index tip_points = 1024;    ///< of the simulated patch across the lines that are read …
    Index tip_length = 2048;    ///< … and along them
    std::uint64_t seed = 1;
    parallel::Threads threads;
};

/// How well one instrument's periodograms agree with the fit within one decade.
///
///   χ² = Σ 2ν (r − 1 − ln r)/(1 + 1/6ν),  r = P/E
///
/// over groups of modes: the deviance of gamma variates, each divided by its mean (to 1 % for ν >= 1), ν the values
/// behind a group.
struct Agreement {
    std::string instrument;
    int decade = 0;      ///< 10^decade … 10^(decade+1) 1/m
    double ratio = 1.0;  ///< mean of P/E, weighted by ν
    double standard_error =
        0.0;  ///< of the ratio where the instrument agrees: √(Σ ν²/ν_own)/Σ ν, ν_own the independent values of a group
    double chi_squared = 0.0;
    int groups = 0;
    double probability = 1.0;  ///< of a χ² as large with as many degrees of freedom as groups
};

/// What a tip was found to do.
struct TipFactor {
    std::string instrument;
    std::string probe;   ///< what it is, such as "sphere, 10 nm"
    double size = 0.0;   ///< radius of its apex, or a foil's thickness [m]
    Array1D wavevector;  ///< [1/m]
    Array1D transfer;    ///< T
};

/// A surface whose features are longer along one direction, where maps or lines along several directions show one.
struct SurfaceStretch {
    double wavevector = 0.0;  ///< where it holds [1/m]; between such places the vector below is interpolated
    Estimate ratio;           ///< s: length of features along over across
    Estimate direction;       ///< of the long axis against the x of lines [rad]
};

/// How the fit moves with an input that many measurements share.
struct InputResponse {
    std::string input;      ///< its name
    Eigen::VectorXd theta;  ///< d theta for one standard error of the input
    Band log_band;          ///< what ln of the band's ends moves by
};

/// INSTRUMENTS_DISAGREE below this probability of an agreement's χ²: neighbouring groups share the window, so that
/// chance goes further than χ² says.
inline constexpr double improbable_agreement = 1e-6;

/// One C_iso fitted to all measurements at once.
struct LikelihoodSpectrum {
    /// Forty nodes a decade up to q_s; its band is from the lowest to the highest wavevector that data speak of, beyond
    /// it the prior continues.
    spectra::Spectrum C_iso;
    Array1D log_standard_error;  ///< of ln C_iso, inputs in it
    Eigen::MatrixXd design;  ///< ∂ ln C_iso/∂theta; ln C_iso = design · theta of surfaces that are not stretched
    Eigen::VectorXd theta;
    Eigen::MatrixXd covariance;  ///< of theta without the inputs below: scatter of the data and between measurements,
                                 ///< response of the tips, uncertain skewness, noise of the simulation
    std::vector<InputResponse> inputs;  ///< uncertain sizes of probes and calibrations, each independent of all else
    std::vector<Agreement> agreement;
    std::vector<TipFactor> tips;
    std::vector<SurfaceStretch>
        stretch;                ///< empty: isotropic as far as is seen; C_iso is the mean over directions else
    Array1D C_along, C_across;  ///< of a stretched surface: C_iso that lines along and across its long direction show
    int rounds = 0;
    int iterations = 0;         ///< of the last fit
    bool converged = false;     ///< else the numbers are those of the step it stopped at
    std::vector<Alert> alerts;  ///< INSTRUMENTS_DISAGREE, MEASUREMENTS_SCATTER, ROLLOFF_NOT_SEEN

    /// Of theta, with what every input does: covariance + Σ θ_i θ_iᵀ.
    [[nodiscard]] Eigen::MatrixXd total_covariance() const;
};

/// Fits ln C_iso of an isotropic surface to the expected periodograms of all measurements: window, detrending, sampling
/// and aliases of scans and maps, the points of contours, noise of each instrument, and tips simulated on the estimate
/// itself.
///
/// Maps and scans lose a tilt (a parabola or more where that was taken from them) line by line. Maps count as many
/// lines as are independent. Gaps of lines are bridged, and what that does to a line of this spectrum is expected;
/// lines of which less than half is defined are left out. Same bytes for any number of threads.
/// @throws InvalidArgument where no measurement has a mode inside its band; what the kernels throw.
/// Source: Sykulski et al., Biometrika 106 (2019) 251; Guillaumin et al., J. R. Stat. Soc. B 84 (2022) 1539; trends,
/// contours and tips derived here.
[[nodiscard]] LikelihoodSpectrum likelihood_spectrum(std::span<const ObservedSurface> observed,
                                                     const LikelihoodOptions& options = {});

/// Spectra drawn from the normal distribution of theta without its inputs' errors: row r is C_iso [m⁴] at the
/// spectrum's wavevectors.
[[nodiscard]] Array2D drawn_spectra(const LikelihoodSpectrum& spectrum, Index count, std::uint64_t seed);

}  // namespace setae::spectral_fit
