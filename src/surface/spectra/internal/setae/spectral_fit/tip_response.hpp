// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "setae/core/arrays.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/spectra/spectral_density.hpp"
#include "setae/spectral_fit/probe.hpp"

namespace setae::spectral_fit {

struct TipSimulation {
    Probe probe;                     ///< a tip, or a foil seen from its side
    double step = 0.0;               ///< of the simulated patch [m]; simulation_step() says which is fine enough
    Index points = 1024;             ///< of the patch across the lines that are read
    Index length = 1024;             ///< along them
    int repetitions = 2;             ///< patches, each of its own random numbers
    bool size_response = true;       ///< whether ∂ ln T/∂ ln(size of the probe) is wanted; else it is 0
    double skewness = 0.0;           ///< of the surface's heights, log-normal; 0: Gaussian
    bool skewness_response = false;  ///< whether ∂ ln T/∂ skewness is wanted; else it is 0
    double correlation_length =
        0.0;  ///< of the heights [m]: lines that far apart count as independent in the smoothing
    std::uint64_t seed = 1;
    parallel::Threads threads;
};

/// The coarser of shortest_step and the finer of median_wavelength/50 and R/20 [m]; of foils the coarser of
/// half of shortest_step, since peaks lie between points, and what makes a patch four times as wide as the foil is
/// thick.
/// Half of ∫ q C_iso dq lies below 2π/median_wavelength.
[[nodiscard]] double simulation_step(const Probe& probe, double median_wavelength, double shortest_step, Index points);

/// What a probe does to a surface, with its derivatives.
///
///   H_read(q⃗) = a(|q⃗|) H(q⃗) + H_added,   T = [Abel integral of a² C_iso + C_added]/C1D
///
/// The tip follows long waves and cannot enter short ones; where it hops from peak to peak it adds power of its own, to
/// lines of all long waves alike, whatever the surface has there. A foil shows the highest of all lines over its
/// thickness: T is then the ratio of what lines have, a is 1 and nothing is added.
struct TipResponse {
    Array1D wavevector;         ///< centres of bins, eight a decade [1/m], increasing; three decades beyond the patch
    Array1D log_transfer;       ///< ln T, along lines
    Array1D log_followed;       ///< ln a², of waves of any direction
    Array1D log_added;          ///< ln C_added, along lines [m³]
    Array1D followed_response;  ///< ∂ ln a²/∂ ln A for C_iso ∝ A
    Array1D added_response;     ///< ∂ ln C_added/∂ ln A
    Array1D size_response;      ///< ∂ ln T/∂ ln(size of the probe)
    Array1D skewness_response;  ///< ∂ ln T/∂ skewness
    Array2D added_errors;       ///< what ln C_added is wrong by in bands of ln q, a row each: standard errors that
                                ///< repetitions tell, independent of each other
    Array2D simulation_errors;  ///< a row a repetition: how what it follows departs from the mean, as ln T and over
                                ///< √(n(n − 1)); the outer products of its rows sum up to the covariance that this
                                ///< leaves. None for one repetition.
};

/// Simulates the probe on periodic random patches of the given spectrum, their heights transformed to the skewness
/// asked for: 2-D dilation or silhouettes, read along x, the same surface with and without tip. a is the regression of
/// what is read on the surface, bin by bin, C_added what is left; both are smoothed over ln q and constant beyond the
/// patch's longest wave, where C1D is the spectrum's own: T is not constant there. Same random numbers for every
/// spectrum, so that T changes smoothly with it.
/// @throws InvalidArgument for a radius, step or correlation length that is not positive, or a spectrum without power.
/// Source: dilation, Villarrubia 1997; its use as a transfer factor derived here.
[[nodiscard]] TipResponse tip_response(const spectra::SpectralDensity& C_iso, const TipSimulation& simulation);

/// T alone, on a spectrum changed a little since `before` was simulated with the same step; the derivatives stay those
/// of `before`.
[[nodiscard]] TipResponse tip_response(const spectra::SpectralDensity& C_iso, const TipSimulation& simulation,
                                       const TipResponse& before);

/// Skewness of heights as a tip reads them, less that of the same heights: a ball rests on peaks. One patch, four times
/// as wide as those of tip_response() and as much coarser, since a skewness needs many of the longest waves.
/// @throws as tip_response.
[[nodiscard]] double added_skewness(const spectra::SpectralDensity& C_iso, const TipSimulation& simulation);

/// ln T at wavevectors for points a pixel_size apart: T averaged over aliases with their C1D,
///   T = Σ_m T(|q + 2πm/Δ|) C1D(|q + 2πm/Δ|)/Σ_m C1D(|q + 2πm/Δ|),
/// and what is added over what the surface has there, likewise. C1D: density of lines [m³], 0 beyond its ends.
/// Derivatives and errors of T are averaged weighted with T C1D, those of what is added with it.
struct SampledResponse {
    Array1D log_transfer, added_share, added_response, size_response, skewness_response;
    Array2D added_errors;       ///< a row a band
    Array2D simulation_errors;  ///< a row a repetition
};
[[nodiscard]] SampledResponse sampled(const TipResponse& response, const spectra::SpectralDensity& C1D,
                                      double pixel_size, const ArrayView1D& wavevectors);

/// ln a² and its answer to the amplitude at wavevectors.
struct FollowedShare {
    Array1D log_square, response;
};
[[nodiscard]] FollowedShare followed_at(const TipResponse& response, const ArrayView1D& wavevectors);

}  // namespace setae::spectral_fit
