// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "setae/core/arrays.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/spectra/spectral_density.hpp"
#include "setae/spectral_fit/probe.hpp"

namespace setae::spectral_fit {

struct TipSimulation {
    Probe probe;                      ///< a tip, or a foil in projection
    double step = 0.0;                ///< of the simulated patch [m]; sufficiently small values: simulation_step()
    Index points = 1024;              ///< of the patch across the measured lines
    Index length = 1024;              ///< along them
    int repetitions = 2;              ///< patches with different random numbers
    bool size_response = true;        ///< whether ∂ ln T/∂ ln(size of the probe) is computed; otherwise it is 0
    double skewness = 0.0;            ///< of the heights of the surface, log-normal; 0: Gaussian
    bool skewness_response = false;   ///< whether ∂ ln T/∂ skewness is computed; otherwise it is 0
    double correlation_length = 0.0;  ///< of the heights [m]: lines at this distance are independent in the smoothing
    std::uint64_t seed = 1;
    parallel::Threads threads;
};

/// The coarser of shortest_step and the finer of median_wavelength/50 and R/20 [m]; for foils the coarser of half of
/// shortest_step, since peaks are between points, and the step of a patch four times as wide as the thickness of the
/// foil. Half of ∫ q C_iso dq is below 2π/median_wavelength.
[[nodiscard]] double simulation_step(const Probe& probe, double median_wavelength, double shortest_step, Index points);

/// Effect of a probe on a measured surface, with its derivatives.
///
///   H_read(q⃗) = a(|q⃗|) H(q⃗) + H_added,   T = [Abel integral of a² C_iso + C_added]/C1D
///
/// The tip follows long waves and cannot enter short ones; jumps from peak to peak add power, equally to lines of all
/// long waves and independent of the surface there. A foil shows the highest of all lines over its thickness: T is then
/// the ratio of the line spectra, a is 1 and nothing is added.
struct TipResponse {
    Array1D wavevector;         ///< centres of bins, eight per decade [1/m], increasing; three decades beyond the patch
    Array1D log_transfer;       ///< ln T, along lines
    Array1D log_followed;       ///< ln a², of waves of any direction
    Array1D log_added;          ///< ln C_added, along lines [m³]
    Array1D followed_response;  ///< ∂ ln a²/∂ ln A for C_iso ∝ A
    Array1D added_response;     ///< ∂ ln C_added/∂ ln A
    Array1D size_response;      ///< ∂ ln T/∂ ln(size of the probe)
    Array1D skewness_response;  ///< ∂ ln T/∂ skewness
    Array2D added_errors;       ///< errors of ln C_added in bands of ln q, one row each: standard errors from
                                ///< repetitions, independent of each other
    Array2D simulation_errors;  ///< one row per repetition: deviation of the followed part from the mean, as ln T and
                                ///< over √(n(n − 1)); the sum of the outer products of the rows is the resulting
                                ///< covariance. Empty for one repetition.
};

/// Simulates the probe on periodic random patches of the given spectrum, their heights transformed to the given
/// skewness: 2-D dilation or silhouettes, measured along x, the same surface with and without tip. a is the regression
/// of the measured heights on the surface, bin by bin, C_added the rest; both are smoothed over ln q and constant
/// beyond the longest wave of the patch, where C1D is that of the spectrum: T is not constant there. The random numbers
/// are the same for every spectrum, so T changes smoothly with it.
/// @throws InvalidArgument for a radius, step or correlation length that is not positive, or a spectrum without power.
/// Source: dilation, Villarrubia 1997; its use as a transfer factor derived here.
[[nodiscard]] TipResponse tip_response(const spectra::SpectralDensity& C_iso, const TipSimulation& simulation);

/// Only T, for a spectrum slightly changed since the simulation of `before` with the same step; the derivatives are
/// those of `before`.
[[nodiscard]] TipResponse tip_response(const spectra::SpectralDensity& C_iso, const TipSimulation& simulation,
                                       const TipResponse& before);

/// Skewness of heights measured by a tip, minus that of the heights: a sphere touches peaks. One patch, four times as
/// wide as those of tip_response() and as much coarser, since a skewness needs many of the longest waves.
/// @throws as tip_response.
[[nodiscard]] double added_skewness(const spectra::SpectralDensity& C_iso, const TipSimulation& simulation);

/// ln T at wavevectors for points a pixel_size apart: T averaged over aliases with their C1D,
///   T = Σ_m T(|q + 2πm/Δ|) C1D(|q + 2πm/Δ|)/Σ_m C1D(|q + 2πm/Δ|),
/// and the ratio of added power to that of the surface, averaged in the same way. C1D: density of lines [m³], 0 beyond
/// its ends. Derivatives and errors of T are averaged weighted with T C1D, those of the added power with C1D.
struct SampledResponse {
    Array1D log_transfer, added_share, added_response, size_response, skewness_response;
    Array2D added_errors;       ///< one row per band
    Array2D simulation_errors;  ///< one row per repetition
};
[[nodiscard]] SampledResponse sampled(const TipResponse& response, const spectra::SpectralDensity& C1D,
                                      double pixel_size, const ArrayView1D& wavevectors);

/// ln a² and its response to the amplitude, at wavevectors.
struct FollowedShare {
    Array1D log_square, response;
};
[[nodiscard]] FollowedShare followed_at(const TipResponse& response, const ArrayView1D& wavevectors);

}  // namespace setae::spectral_fit
