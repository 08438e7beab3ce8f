// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "setae/parallel/for_each.hpp"
#include "setae/synthesis/random_numbers.hpp"
#include "setae/synthesis/spectral_density.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::synthesis {

struct MultiscaleOptions {
    RandomKey key;
    double longest_wavelength = 0.0;   ///< [m], at least 128 times the shortest; longer ones are left out
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
/// C_iso is cut into octaves. Octave b is a periodic patch of its own, 512 × 512 points over 128 of its shortest
/// wavelengths, turned by an angle of its own, so that the sum repeats nowhere although each octave does (a line crosses
/// about 10⁴ different places of a patch before it comes near the first). Modes have their expected |h_q|² and random
/// phases, so the surface as a whole has C_iso itself, not a sample of it.
/// Heights are a function of the point: windows agree wherever they overlap, and a coarse sampling aliases as an
/// instrument's does. Interpolation inside a patch: below 1e-6 of the rms of its octave.
/// Memory: 2 MiB an octave. Cost: about 0.1 µs a point and octave.
class MultiscaleSurface {
public:
    /// @throws InvalidArgument for wavelengths that contradict each other or a density that is negative or not finite.
    MultiscaleSurface(const SpectralDensity& C_iso, const MultiscaleOptions& options);
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
