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

/// One surface over the whole plane with all its scales, evaluated in windows of any size and pixel without being
/// stored.
///
///   h(r) = Σ_b h_b(r),  h_b from the modes with 2^(b−1) < q <= 2^b rad/m,  ⟨|h_q|²⟩ = ∫ C_iso d²q/4π² over the mode's
///   cell
///
/// Octave b is a separate periodic patch, 128 of its shortest wavelengths wide, rotated by its own angle; the last one
/// contains all longer wavelengths, and its period is at least the longest. No two octaves have a common period, and a
/// line crosses thousands of different places of a patch before it returns near one. Modes have their expected |h_q|
/// and random phases, so the surface as a whole has the spectrum C_iso, and windows scatter as for any surface.
/// Limitation: in a window with more than 128² of the shortest wavelengths of an octave, that octave has only its 10⁴
/// independent modes.
///
/// The numbers of an octave depend on key and b: other limits of wavelengths do not change it. Heights are a function
/// of the point: overlapping windows agree to the rounding of positions (10⁷ wavelengths from the origin: 1e-8 of the
/// rms of the octave), and steps longer than a wavelength cause aliasing as with an instrument. Interpolation error
/// inside a patch: 2e-7 of the rms of the octave. The spectrum is smeared by the cell of a mode, 1/64 to 1/128 of q.
/// Same bytes for any number of threads. Memory: 2 MiB per octave. Cost: 10 ms per octave, then 0.1 to 0.2 µs per point
/// and octave.
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

    /// For the whole surface: √(Σ C/A) over all modes [m], and √(Σ q² C/A).
    [[nodiscard]] double rms_height() const;
    [[nodiscard]] double rms_slope() const;

private:
    struct Octaves;
    std::unique_ptr<const Octaves> octaves_;
    parallel::Threads threads_;
};

}  // namespace setae::synthesis
