// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <random>

#include "setae/core/constants.hpp"
#include "setae/roughness/slope_distribution.hpp"
#include "setae/roughness/true_area.hpp"

namespace setae {
namespace {

/// A Gaussian self-affine map as a sum of plane waves of random direction and phase: slow, but needs no transform and so
/// shares no code with what it tests. Wavevectors are whole periods of the square.
topography::HeightMap self_affine_map(double hurst, Index n, int longest_mode, int shortest_mode, unsigned seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> phase(0.0, 2.0 * pi);
    topography::HeightMap map{Array2D::Zero(n, n), {1.0, 1.0}, true};
    const Array1D x = Array1D::LinSpaced(n, 0.0, 2.0 * pi * static_cast<double>(n - 1) / static_cast<double>(n));
    for (int kx = 0; kx <= shortest_mode; ++kx)
        for (int ky = -shortest_mode; ky <= shortest_mode; ++ky) {
            const double k = std::hypot(kx, ky);
            if (k < longest_mode || k > shortest_mode || (kx == 0 && ky <= 0)) continue;
            const double shift = phase(random);
            const Array1D cx = (kx * x + shift).cos(), sx = (kx * x + shift).sin(), cy = (ky * x).cos(), sy = (ky * x).sin();
            map.heights += std::pow(k, -1.0 - hurst) * (cx.matrix() * cy.matrix().transpose() - sx.matrix() * sy.matrix().transpose()).array();
        }
    return map;
}

TEST(TrueArea, OfSelfAffineMapsFollowsTheGaussianFormula) {
    // Fig. S7B: slopes up to order 10, h' that of the triangles
    for (const double hurst : {0.3, 0.8}) {
        auto map = self_affine_map(hurst, 256, 2, 24, 7);
        const double slope = roughness::triangulated_area(map).rms_slope;
        map.heights /= slope;
        for (const double target : {0.1, 0.5, 1.0, 3.0, 10.0}) {
            auto scaled = map;
            scaled.heights *= target;
            const auto area = roughness::triangulated_area(scaled);
            EXPECT_NEAR(area.rms_slope, target, 1e-9 * target);
            EXPECT_NEAR(area.area_ratio / roughness::gaussian_area_ratio(target), 1.0, 0.02) << hurst << " " << target;
        }
    }
}

TEST(SlopeDistribution, OfASelfAffineMapIsFoundGaussianAndIsotropic) {
    const auto distribution = roughness::slope_distribution(self_affine_map(0.5, 256, 2, 32, 3));
    EXPECT_GT(distribution.gaussian_p_value, 0.01);
    EXPECT_LT(distribution.isotropy_ratio, 1.1);
    EXPECT_TRUE(distribution.alerts.empty());
}

}  // namespace
}  // namespace setae
