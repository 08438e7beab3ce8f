// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <random>

#include "setae/core/constants.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::tests {

/// A Gaussian self-affine map as a sum of plane waves of random direction and phase: slow, but needs no transform and
/// so shares no code with what it tests. Wavevectors are whole periods of the square.
inline topography::HeightMap self_affine_map(double hurst, Index n, int longest_mode, int shortest_mode,
                                             unsigned seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> phase(0.0, 2.0 * pi);
    topography::HeightMap map{Array2D::Zero(n, n), {1.0, 1.0}, true};
    const Array1D x = Array1D::LinSpaced(n, 0.0, 2.0 * pi * static_cast<double>(n - 1) / static_cast<double>(n));
    for (int kx = 0; kx <= shortest_mode; ++kx)
        for (int ky = -shortest_mode; ky <= shortest_mode; ++ky) {
            const double k = std::hypot(kx, ky);
            if (k < longest_mode || k > shortest_mode || (kx == 0 && ky <= 0)) continue;
            const double shift = phase(random);
            const Array1D cx = (kx * x + shift).cos(), sx = (kx * x + shift).sin(), cy = (ky * x).cos(),
                          sy = (ky * x).sin();
            map.heights += std::pow(k, -1.0 - hurst) *
                           (cx.matrix() * cy.matrix().transpose() - sx.matrix() * sy.matrix().transpose()).array();
        }
    return map;
}

}  // namespace setae::tests
