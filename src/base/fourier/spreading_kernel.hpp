// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "setae/core/arrays.hpp"

namespace setae::fourier {

/// Kaiser–Bessel kernel ψ(z) = I0(β√(1−z²)), |z| <= 1, sixteen grid points wide, for grids twice as fine as needed.
/// Source: Fourmont, J. Fourier Anal. Appl. 9 (2003) 431; error about 4e-14 at this width.
class SpreadingKernel {
public:
    static constexpr Index width = 16;
    static constexpr double oversampling = 2.0;

    /// The only kernel, tabulated on first use.
    static const SpreadingKernel& instance();

    /// Grid points of a point at `position` (in grid steps): first … first + width − 1 with their values.
    struct Taps {
        Index first;
        std::array<double, width> values;
    };
    [[nodiscard]] Taps at(double position) const;

    /// ∫ of the kernel, as a function of the distance u in grid steps, times exp(−iku) du.
    [[nodiscard]] double transform(double k) const;

private:
    SpreadingKernel();

    static constexpr std::size_t degree = 21;
    /// value of tap i = sum_p coefficient[p][i] t^p, t in −1 … 1 the position between two grid points
    std::array<std::array<double, width>, degree + 1> coefficients_;
};

}  // namespace setae::fourier
