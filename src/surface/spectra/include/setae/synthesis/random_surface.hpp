// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "setae/numerics/random_numbers.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/spectra/spectral_density.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::synthesis {

/// Points and size of a surface: x_i = i · size_x/nx.
struct SurfaceGrid {
    Index nx = 0, ny = 0;               ///< points along x and y, >= 2
    double size_x = 0.0, size_y = 0.0;  ///< extent [m], > 0
};

/// Points and size of a line.
struct LineGrid {
    Index points = 0;   ///< >= 2
    double size = 0.0;  ///< [m], > 0
};

/// Scatter of the amplitudes of modes about the spectrum.
enum class Amplitudes {
    gaussian,  ///< complex normal: a Gaussian random surface, whose rms height scatters from seed to seed
    exact,     ///< |h̃_q|² is its expectation, phases are random: rms height and slope are those of the spectrum
};

struct SurfaceOptions {
    numerics::RandomKey key;  ///< the seed
    Amplitudes amplitudes = Amplitudes::gaussian;
    spectra::Anisotropy anisotropy;          ///< surfaces only
    std::optional<double> exact_rms_height;  ///< scale the heights to this rms height [m], > 0
    parallel::Threads threads;
};

/// A periodic random surface of zero mean with the given spectrum.
///
///   h(x) = Σ_q c_q exp(iqx),  ⟨|c_q|²⟩ = C_iso(q)/A,  q = 2π (kx/size_x, ky/size_y),  so ⟨|h̃_q|²⟩ = C_iso(q) A
///
/// The random numbers of a mode depend only on seed and mode numbers (kx, ky): a finer grid of the same size and seed
/// has the same surface with more modes (the highest mode of an even number of points is real and specific to its
/// grid). Same bytes for any number of threads. C_iso is interpolated in tables of q² to 1e-6 of √C_iso, and evaluated
/// directly at jumps and bends. Modes beyond the highest are left out, without aliasing. Memory: the map and one block
/// per thread; O(n log n); 4096² in 0.2 s on two cores.
/// @throws InvalidArgument for a grid or anisotropy outside its domain, a spectrum that is negative, infinite or NaN,
/// or an exact rms height without a mode with power.
[[nodiscard]] topography::HeightMap random_surface(const spectra::SpectralDensity& C_iso, const SurfaceGrid& grid,
                                                   const SurfaceOptions& options = {});

/// A periodic random line of zero mean: h(x) = Σ_q c_q exp(iqx), ⟨|c_q|²⟩ = C1D(q)/L. Lines on an isotropic surface:
/// C1D = profile_density(C_iso, …). Modes, seeds and errors as random_surface.
[[nodiscard]] topography::LineScan random_line(const spectra::SpectralDensity& C1D, const LineGrid& grid,
                                               const SurfaceOptions& options = {});

/// Expected roughness of a surface on this grid: sums over its modes.
struct ExpectedRoughness {
    double rms_height = 0.0;  ///< √(Σ C/A) [m]
    double rms_slope = 0.0;   ///< √(Σ q² C/A), Fourier derivative; for a line √⟨h'²⟩
};
[[nodiscard]] ExpectedRoughness expected_roughness(const spectra::SpectralDensity& C_iso, const SurfaceGrid& grid,
                                                   const SurfaceOptions& options = {});
[[nodiscard]] ExpectedRoughness expected_roughness(const spectra::SpectralDensity& C1D, const LineGrid& grid);

/// nx x ny points of a map from grid point (x0, y0) on, as a map that is not periodic; on a periodic map the window may
/// cross its ends. Heights are unchanged: no trend is removed.
/// @throws InvalidArgument for a window of fewer than 2 x 2 points or larger than the map, or one that extends beyond a
/// map that is not periodic.
[[nodiscard]] topography::HeightMap cut(const topography::HeightMap& map, Index x0, Index y0, Index nx, Index ny);

}  // namespace setae::synthesis
