// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "setae/numerics/random_numbers.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/spectra/spectral_density.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::synthesis {

struct MultiscaleOptions {
    numerics::RandomKey key;
    double longest_wavelength = 0.0;   ///< [m]; longer ones are left out
    double shortest_wavelength = 0.0;  ///< [m]; shorter ones are left out
    parallel::Threads threads;
};

/// nx × ny points from (x, y) on, pixel_size apart along the axes.
struct Window {
    double x = 0.0;  ///< [m]
    double y = 0.0;  ///< [m]
    Index nx = 0;
    Index ny = 0;
    double pixel_size = 0.0;  ///< [m]
};

/// Points (x, y) + i step (cos direction, sin direction), i = 0 … points − 1.
struct LinePath {
    double x = 0.0;          ///< [m]
    double y = 0.0;          ///< [m]
    double direction = 0.0;  ///< angle to the x axis [rad]
    Index points = 0;
    double step = 0.0;  ///< [m]
};

/// One surface over the whole plane with all its scales, seen through windows of any size and pixel without being held.
///
///   h(r) = Σ_b h_b(r),  h_b from the modes with 2^(b−1) < q <= 2^b rad/m,  ⟨|h_q|²⟩ = ∫ C_iso d²q/4π² over the mode's
///   cell
///
/// Octave b is a periodic patch of its own, 128 of its shortest wavelengths wide, turned by an angle of its own; the
/// last one holds all longer wavelengths, its period is at least the longest. No two octaves repeat together, and a
/// line meets thousands of different places of a patch before it comes back near one. Modes have their expected |h_q|
/// and random phases, so the surface as a whole has the spectrum C_iso itself, and what a window shows scatters as for
/// any surface. What this costs: in a window with more than 128² of an octave's shortest wavelengths that octave has no
/// more than its 10⁴ independent modes.
///
/// The numbers of an octave belong to key and b: other limits of wavelengths leave it as it is. Heights are a function
/// of the point: windows agree wherever they overlap, to the rounding of positions (10⁷ wavelengths from the origin:
/// 1e-8 of the octave's rms), and steps longer than a wavelength alias as an instrument's do. Interpolation inside a
/// patch: 2e-7 of the octave's rms. Spectrum smeared by a mode's cell, 1/64 to 1/128 of q. Same bytes for any number of
/// threads. Memory: 2 MiB an octave. Cost: 10 ms an octave, then 0.1 to 0.2 µs a point and octave.
class MultiscaleSurface {
public:
    /// @throws InvalidArgument unless 0 < shortest < longest, or for a C_iso that is negative, not finite or zero
    /// throughout.
    MultiscaleSurface(const spectra::SpectralDensity& C_iso, const MultiscaleOptions& options);
    ~MultiscaleSurface();
    MultiscaleSurface(MultiscaleSurface&&) noexcept;
    MultiscaleSurface& operator=(MultiscaleSurface&&) noexcept;

    /// Not periodic; the mean is that of the window. @throws InvalidArgument for a window without points or pixel size.
    [[nodiscard]] topography::HeightMap window(const Window& window) const;
    [[nodiscard]] topography::LineScan line(const LinePath& path) const;
    /// @throws InvalidArgument for sizes that differ or positions that are not finite.
    [[nodiscard]] Array1D heights_at(const ArrayView1D& x, const ArrayView1D& y) const;

    /// Of the whole surface: √(Σ C/A) over all modes [m], and √(Σ q² C/A).
    [[nodiscard]] double rms_height() const;
    [[nodiscard]] double rms_slope() const;

private:
    struct Octaves;
    std::unique_ptr<const Octaves> octaves_;
    parallel::Threads threads_;
};

}  // namespace setae::synthesis
