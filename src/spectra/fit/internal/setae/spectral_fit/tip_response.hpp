// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "setae/core/arrays.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/spectra/spectral_density.hpp"

namespace setae::spectral_fit {

struct TipSimulation {
    double tip_radius = 0.0;         ///< R of the sphere [m]
    double step = 0.0;               ///< of the simulated patch [m]; simulation_step() says which is fine enough
    Index points = 1024;             ///< of a side of the patch
    int repetitions = 2;             ///< patches, each of its own random numbers
    bool radius_response = true;     ///< whether ∂ ln T/∂ ln R is wanted; else it is 0
    double skewness = 0.0;           ///< of the surface's heights, log-normal; 0: Gaussian
    bool skewness_response = false;  ///< whether ∂ ln T/∂ skewness is wanted; else it is 0
    double correlation_length =
        0.0;  ///< of the heights [m]: lines that far apart count as independent in the smoothing
    std::uint64_t seed = 1;
    parallel::Threads threads;
};

/// The coarser of shortest_step and the finer of median_wavelength/50 and R/20 [m].
/// Half of ∫ q C_iso dq lies below 2π/median_wavelength.
[[nodiscard]] double simulation_step(double tip_radius, double median_wavelength, double shortest_step);

/// What a spherical tip does to C1D: T(q) = C1D read by the tip over C1D of the surface, with its derivatives.
struct TipResponse {
    Array1D wavevector;          ///< centres of bins, eight a decade [1/m], increasing
    Array1D log_transfer;        ///< ln T, smoothed over ln q
    Array1D amplitude_response;  ///< ∂ ln T/∂ ln A for C_iso ∝ A
    Array1D radius_response;     ///< ∂ ln T/∂ ln R
    Array1D skewness_response;   ///< ∂ ln T/∂ skewness
    Array2D simulation_errors;  ///< a row a repetition: how its ln T departs from the mean, over √(n(n − 1)); the outer
                                ///< products of its rows sum up to the covariance of ln T that the simulation leaves.
                                ///< None for one repetition.
};

/// Simulates the tip on periodic random patches of the given spectrum, their heights transformed to the skewness asked
/// for: 2-D dilation, read along x, the same surface with and without tip. T is constant below the lowest and above the
/// highest bin. Same random numbers for every spectrum, so that T changes smoothly with it.
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
///   T = Σ_m T(|q + 2πm/Δ|) C1D(|q + 2πm/Δ|)/Σ_m C1D(|q + 2πm/Δ|).
/// C1D: density of lines [m³]. Derivatives and errors are averaged likewise, weighted with T C1D.
struct SampledResponse {
    Array1D log_transfer, amplitude_response, radius_response, skewness_response;
    Array2D simulation_errors;  ///< a row a repetition
};
[[nodiscard]] SampledResponse sampled(const TipResponse& response, const spectra::SpectralDensity& C1D,
                                      double pixel_size, const ArrayView1D& wavevectors);

}  // namespace setae::spectral_fit
