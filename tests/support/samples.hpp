// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <random>

#include "setae/core/arrays.hpp"
#include "setae/core/constants.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::tests {

inline Array1D random_heights(Index n, unsigned seed = 1) {
    std::mt19937_64 engine(seed);
    std::normal_distribution<double> number;
    return Array1D::NullaryExpr(n, [&] { return number(engine); });
}

inline Array2D random_map(Index nx, Index ny, unsigned seed = 1) {
    const Array1D heights = random_heights(nx * ny, seed);
    return Eigen::Map<const Array2D>(heights.data(), nx, ny);
}

/// Steps between 1 ± spread times the mean step, heights a random walk.
inline topography::Profile random_profile(Index n, double step = 1.0, double spread = 0.8, unsigned seed = 1) {
    std::mt19937_64 engine(seed);
    std::uniform_real_distribution<double> stretch(1.0 - spread, 1.0 + spread);
    std::normal_distribution<double> number;
    topography::Profile profile{Array1D(n), Array1D(n), {}};
    double x = 0.0, h = 0.0;
    for (Index k = 0; k < n; ++k) {
        profile.positions[k] = x;
        profile.heights[k] = h;
        x += step * stretch(engine);
        h += step * number(engine);
    }
    return profile;
}

inline Array1D log_spaced(Index n, double lower, double upper) {
    return Array1D::LinSpaced(n, std::log(lower), std::log(upper)).exp();
}

}  // namespace setae::tests
