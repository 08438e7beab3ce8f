// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <functional>

#include "setae/contact_line/contact_line.hpp"
#include "setae/core/units.hpp"
#include "setae/numerics/random_numbers.hpp"

namespace setae::contact_line {

/// r(θ, t) at so many equal angles.
inline ContactLine line_of(const Array1D& time, Index angles,
                           const std::function<double(double angle, double time)>& radius) {
    ContactLine line{time, Array2D(time.size(), angles)};
    for (Index i = 0; i < time.size(); ++i)
        for (Index j = 0; j < angles; ++j)
            line.radius(i, j) = radius(2.0 * pi * static_cast<double>(j) / static_cast<double>(angles), time[i]);
    return line;
}

/// Independent Gaussian lines of radius 1 with ⟨|r_n|²⟩ = amplitude n^−(1 + 2ζ), n = 1 … N/2 − 1, and noise at every
/// place.
inline ContactLine rough_lines(Index frames, Index angles, double exponent, double amplitude, double noise,
                               std::uint64_t seed) {
    ContactLine line{Array1D::LinSpaced(frames, 0.0, static_cast<double>(frames - 1)),
                     Array2D::Constant(frames, angles, 1.0), noise};
    for (Index i = 0; i < frames; ++i) {
        const auto key = numerics::substream({seed}, static_cast<std::uint64_t>(i));
        const Array1D numbers = numerics::normal_numbers(key, 0, 2 * angles);
        for (Index n = 1; 2 * n < angles; ++n) {
            // r_n and its conjugate: 2 Re(r_n e^{inθ}), real and imaginary parts of variance P/2
            const double deviation =
                std::sqrt(2.0 * amplitude * std::pow(static_cast<double>(n), -1.0 - 2.0 * exponent));
            for (Index j = 0; j < angles; ++j) {
                const double phase = 2.0 * pi * static_cast<double>((n * j) % angles) / static_cast<double>(angles);
                line.radius(i, j) +=
                    deviation * (numbers[2 * n] * std::cos(phase) + numbers[2 * n + 1] * std::sin(phase));
            }
        }
        line.radius.row(i) += noise * numbers.tail(angles).transpose();
    }
    return line;
}

}  // namespace setae::contact_line
