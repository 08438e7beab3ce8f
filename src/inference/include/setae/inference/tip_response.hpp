// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "setae/core/arrays.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/synthesis/spectral_density.hpp"

namespace setae::inference {

struct TipSimulation {
    double tip_radius = 0.0;         ///< R of the sphere [m]
    double shortest_step = 2e-10;    ///< [m]; no finer than this
    Index points = 1024;             ///< of a side of the simulated patch
    int repetitions = 2;             ///< patches, each of its own random numbers
    std::uint64_t seed = 1;
    parallel::Threads threads;
};

/// What a spherical tip does to C1D: T(q) = C1D read by the tip over C1D of the surface, with its derivatives.
struct TipResponse {
    Array1D wavevector;          ///< centres of bins, eight a decade [1/m], increasing
    Array1D log_transfer;        ///< ln T, smoothed over ln q
    Array1D amplitude_response;  ///< ∂ ln T/∂ ln A for C_iso ∝ A
    Array1D radius_response;     ///< ∂ ln T/∂ ln R
    Array1D standard_error;      ///< of ln T between repetitions
    double step = 0.0;           ///< of the simulated patch [m]
};

/// Simulates the tip on periodic random patches of the given spectrum: 2-D dilation, read along x, the same surface with and
/// without tip. The step is a fiftieth of the wavelength half of the mean square height lies below, a twentieth of the tip's own
/// wavelength at most R/20 of it, and not below shortest_step. T is constant below the lowest and above the highest bin.
/// Same random numbers for every spectrum, so that T changes smoothly with it.
/// @throws InvalidArgument for a radius that is not positive or a spectrum without power.
/// Source: dilation, Villarrubia 1997; its use as a transfer factor derived here.
[[nodiscard]] TipResponse tip_response(const synthesis::SpectralDensity& C_iso, double median_wavelength, const TipSimulation& simulation);

/// ln T at wavevectors for points a pixel_size apart: T averaged over aliases with their C1D,
///   T = Σ_m T(|q + 2πm/Δ|) C1D(|q + 2πm/Δ|)/Σ_m C1D(|q + 2πm/Δ|).
/// C1D: density of lines [m³]; values: any of the curves of a TipResponse (ln T, or a derivative weighted by T).
struct SampledResponse {
    Array1D log_transfer, amplitude_response, radius_response, standard_error;
};
[[nodiscard]] SampledResponse sampled(const TipResponse& response, const synthesis::SpectralDensity& C1D, double pixel_size,
                                      const ArrayView1D& wavevectors);

}  // namespace setae::inference
