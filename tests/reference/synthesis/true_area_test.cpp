// SPDX-License-Identifier: GPL-3.0-or-later
// Fig. S7B of the paper: the area of Fourier-filtered self-affine maps against the Gaussian formula (9), h' that of the
// triangles. SETAE_MAP_POINTS=4096 repeats it at the paper's size.
#include <cmath>
#include <cstdlib>
#include <tuple>

#include <gtest/gtest.h>

#include "setae/core/constants.hpp"
#include "setae/roughness/true_area.hpp"
#include "setae/synthesis/random_surface.hpp"

namespace {

using namespace setae;

Index points_a_side() {
    const char* given = std::getenv("SETAE_MAP_POINTS");
    return given ? std::atol(given) : 1024;
}

/// Wavelengths from a sixteenth of the size to `pixels` pixels.
topography::HeightMap self_affine_map(double hurst, Index n, double pixels) {
    const double pixel = 1e-9, size = pixel * static_cast<double>(n);
    const synthesis::SelfAffine model{1e-30, 2.0 * pi / (size / 16.0), hurst, 2.0 * pi / (pixels * pixel)};
    return synthesis::random_surface(synthesis::density(model), {n, n, size, size}, {.key = {2019, 0}});
}

class FigureS7 : public testing::TestWithParam<std::tuple<double, double>> {};

TEST_P(FigureS7, TriangulatedAreaIsThatOfGaussianSlopes) {
    const auto [hurst, pixels] = GetParam();
    auto map = self_affine_map(hurst, points_a_side(), pixels);
    map.heights /= roughness::triangulated_area(map).rms_slope;
    for (const double slope : {0.01, 0.1, 1.0, 10.0}) {
        auto scaled = map;
        scaled.heights *= slope;
        const auto area = roughness::triangulated_area(scaled);
        const double expected = roughness::gaussian_area_ratio(area.rms_slope);
        EXPECT_NEAR(area.rms_slope / slope, 1.0, 1e-9);
        // of the excess: at h' = 0.01 one per cent of the ratio would be no test
        EXPECT_NEAR((area.area_ratio - 1.0) / (expected - 1.0), 1.0, 0.01);
    }
}

INSTANTIATE_TEST_SUITE_P(HurstExponentsAndCutoffs, FigureS7, testing::Combine(testing::Values(0.3, 0.8), testing::Values(2.0, 16.0)));

}  // namespace
