// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "setae/parallel/for_each.hpp"
#include "setae/synthesis/random_numbers.hpp"
#include "setae/synthesis/spectral_density.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::synthesis {

/// Points and extent of a periodic surface; pixels size/n.
struct SurfaceGrid {
    Index nx = 0;
    Index ny = 0;
    double size_x = 0.0;  ///< [m]
    double size_y = 0.0;  ///< [m]
};

/// How large a mode of the surface is.
enum class Amplitudes {
    gaussian,  ///< complex normal about C: a sample of the ensemble, its rms height scatters
    exact,     ///< |h_q|² at its expectation and random phases: every surface has the ensemble's spectrum and rms
};

struct SurfaceOptions {
    RandomKey key;
    Amplitudes amplitudes = Amplitudes::gaussian;
    std::optional<double> exact_rms_height;  ///< [m]; all heights are scaled to it
    std::optional<Anisotropy> anisotropy;
    parallel::Threads threads;
};

/// A periodic surface of zero mean with the given power spectrum.
///
///   h(x, y) = Σ_q h_q exp(i q·r),  q = 2π (k_x/size_x, k_y/size_y),  ⟨|h_q|²⟩ = C_iso(|q|)/(size_x size_y)
///
/// so that ⟨|h̃_q|²⟩ = C_iso A with h̃ = A h_q. The random number of a mode belongs to its (k_x, k_y): a finer grid of the
/// same size and key shows the same surface with more modes, and the bytes are those of any number of threads. C_iso is
/// interpolated to a relative 1e-8; features narrower than 0.1 % in q can be missed. Modes up to the Nyquist wavevector of
/// each axis (the corners of the spectrum are filled); O(nx ny log(nx ny)), no memory but the result.
/// @throws InvalidArgument for an empty grid, a density that is negative or not finite at a mode (with q), a spectrum
/// without any mode on this grid, or an rms height that is not positive.
[[nodiscard]] topography::HeightMap random_surface(const SpectralDensity& C_iso, const SurfaceGrid& grid,
                                                   const SurfaceOptions& options = {});

/// What random_surface aims at on this grid: sums over its modes.
struct ExpectedRoughness {
    double rms_height = 0.0;  ///< √(Σ C/A) [m]
    double rms_slope = 0.0;   ///< √(Σ q² C/A)
};
/// @throws InvalidArgument as random_surface does.
[[nodiscard]] ExpectedRoughness expected_roughness(const SpectralDensity& C_iso, const SurfaceGrid& grid,
                                                   const SurfaceOptions& options = {});

/// The nx × ny heights from pixel (first_x, first_y) on, no longer periodic; heights are left as they are.
/// @throws InvalidArgument for a window that is empty or reaches beyond the surface.
struct CutWindow {
    Index first_x = 0;
    Index first_y = 0;
    Index nx = 0;
    Index ny = 0;
};
[[nodiscard]] topography::HeightMap cut(const topography::HeightMap& map, const CutWindow& window);

/// A periodic line of zero mean with ⟨|h̃_q|²⟩ = C1D(q) size: n points over size [m]; as random_surface otherwise
/// (anisotropy has no meaning and is refused).
[[nodiscard]] topography::LineScan random_line(const SpectralDensity& C1D, Index points, double size,
                                               const SurfaceOptions& options = {});

}  // namespace setae::synthesis
