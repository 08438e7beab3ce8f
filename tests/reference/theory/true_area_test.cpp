// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "self_affine_map.hpp"
#include "setae/roughness/slope_distribution.hpp"
#include "setae/roughness/true_area.hpp"

namespace setae::true_area_test {
namespace {

TEST(TrueArea, OfSelfAffineMapsFollowsTheGaussianFormula) {
    // Fig. S7B: slopes up to order 10, h' that of the triangles
    for (const double hurst : {0.3, 0.8}) {
        auto map = tests::self_affine_map(hurst, 256, 2, 24, 7);
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

TEST(SlopeDistribution, OfASelfAffineMapIsGaussianAndIsotropic) {
    const auto distribution = roughness::slope_distribution(tests::self_affine_map(0.5, 256, 2, 32, 3));
    EXPECT_GT(distribution.gaussian_p_value, 0.01);
    EXPECT_LT(distribution.isotropy_ratio, 1.1);
    EXPECT_TRUE(distribution.alerts.empty());
}

}  // namespace
}  // namespace setae::true_area_test
