// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <complex>

#include "setae/synthesis/amplitude_table.hpp"
#include "setae/synthesis/random_surface.hpp"

namespace setae::synthesis {

/// The modes c_q of a random surface, line by line of equal ky.
class SurfaceModes {
public:
    /// @throws InvalidArgument as random_surface.
    SurfaceModes(const spectra::SpectralDensity& C_iso, const SurfaceGrid& grid, const SurfaceOptions& options);

    /// modes[k] = c(kx, ky) for kx = 0 … nx/2, then the negative ones; ky = 0 … ny/2. Lines with conjugate pairs
    /// satisfy c(−kx, ky) = conj c(kx, ky).
    void line(Index ky, std::complex<double>* modes) const;

    /// Sums of ⟨|c|²⟩ and of q² ⟨|c|²⟩ over all modes of the lines ±ky.
    struct LineSums {
        double height_square = 0.0, slope_square = 0.0;
    };
    [[nodiscard]] LineSums sums(Index ky) const;

private:
    [[nodiscard]] double stretched_square(Index kx, Index ky) const;
    [[nodiscard]] double amplitude(Index kx, Index ky) const;
    [[nodiscard]] bool is_own_pair(Index ky) const { return ky == 0 || 2 * ky == grid_.ny; }

    SurfaceGrid grid_;
    numerics::RandomKey key_;
    Amplitudes amplitudes_;
    double xx_ = 0.0, xy_ = 0.0, yy_ = 0.0;  ///< the stretched q² as a quadratic form of (kx, ky)
    double factor_ = 0.0;                    ///< √(stretch/A)
    AmplitudeTable table_;
};

}  // namespace setae::synthesis
