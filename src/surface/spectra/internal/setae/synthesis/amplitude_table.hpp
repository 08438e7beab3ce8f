// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "setae/spectra/spectral_density.hpp"

namespace setae::synthesis {

/// √C as a function of q², by parabolas in 128 cells per octave of q².
///
/// The cells are those of the floating-point numbers, so a wavevector has the same amplitude in tables of any range. A
/// cell whose parabola differs from √C by more than 1e-6 at two points between (jumps, kinks, steep falls) evaluates C
/// directly.
class AmplitudeTable {
public:
    /// lowest, highest: range of q² [1/m²], 0 < lowest <= highest.
    /// @throws InvalidArgument if C is negative or not finite, here or in later calls.
    AmplitudeTable(const spectra::SpectralDensity& density, double lowest, double highest);

    /// √C at q² within the range. Any number of threads may call it.
    [[nodiscard]] double operator()(double squared_wavevector) const;

private:
    struct Cell {
        double value, linear, square;  ///< NaN, 0, 0: C is evaluated directly
    };

    [[nodiscard]] double exact(double squared_wavevector) const;

    spectra::SpectralDensity density_;
    std::uint64_t first_ = 0;
    std::vector<Cell> cells_;
};

}  // namespace setae::synthesis
