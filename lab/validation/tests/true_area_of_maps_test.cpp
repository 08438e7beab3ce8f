// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/validation/true_area_of_maps.hpp"

#include <gtest/gtest.h>

#include "setae/core/errors.hpp"
#include "setae/roughness/true_area.hpp"

namespace setae::validation::true_area_of_maps_test {
namespace {

TEST(TrueAreaOfMaps, MatchesGaussianSlopesForAnyNumberOfThreads) {
    const auto one = true_area_of_maps({.points = 128, .threads = {1}}),
               two = true_area_of_maps({.points = 128, .threads = {2}});
    ASSERT_EQ(one.size(), 60u);
    for (std::size_t i = 0; i < one.size(); ++i) EXPECT_EQ(one[i].area_ratio, two[i].area_ratio) << i;
    const auto rows = means(one);
    ASSERT_EQ(rows.size(), 20u);
    // small slopes: h'²/2, to h'⁴
    EXPECT_NEAR(rows[0].excess_area, 0.5e-4, 1e-8);
    EXPECT_NEAR(rows[9].rms_slope, 10.0, 1e-12);
    // maps of 128² scatter by some 0.2 %
    EXPECT_NEAR(rows[9].excess_area, roughness::gaussian_area_ratio(10.0) - 1.0, 0.05);
    EXPECT_THROW((void)true_area_of_maps({.points = 100}), InvalidArgument);
}

}  // namespace
}  // namespace setae::validation::true_area_of_maps_test
