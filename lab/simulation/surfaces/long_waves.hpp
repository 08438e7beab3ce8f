// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/numerics/random_numbers.hpp"
#include "setae/simulation/known_surface.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::simulation {

/// A spectrum in two parts that add up to it: g C_iso and (1 − g) C_iso, g falling from 1 at q_c/√2 to 0 at √2 q_c as a
/// squared cosine in ln q.
struct SplitSpectrum {
    spectra::SpectralDensity longer, shorter;
};
[[nodiscard]] SplitSpectrum split_spectrum(const spectra::SpectralDensity& C_iso, double wavevector);

/// The long waves of a surface on a periodic patch of their own, much larger than the measurement, so that a window
/// contains parts of much longer waves, like a piece of a real surface.
///
/// Stored with at least eight points per wavelength and interpolated by eight points per direction: error 2e-4 of the
/// shortest wave's height, whose share is zero.
class LongWaves {
public:
    /// spectrum: of the long waves, zero from the wavevector `end` [1/m] on.  period_x, period_y: of the patch [m].
    struct Patch {
        double end = 0.0;
        double period_x = 0.0, period_y = 0.0;
    };
    LongWaves(const spectra::SpectralDensity& spectrum, const spectra::Anisotropy& anisotropy, const Patch& patch,
              numerics::RandomKey key);

    /// Position of a window on the patch, and its columns of the map.
    struct Window {
        double x = 0.0, y = 0.0;  ///< position of the map's first row and of first_column [m]
        Index first_column = 0, columns = 0;
    };
    void add_to(topography::HeightMap& map, const Window& window) const;

private:
    topography::HeightMap patch_;
};

}  // namespace setae::simulation
