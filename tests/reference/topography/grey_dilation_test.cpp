// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "setae/topography/dilation.hpp"

namespace setae::topography::grey_dilation_test {
namespace {

HeightMap surface(bool periodic) {
    HeightMap map{Array2D(12, 10), {12.0, 10.0}, periodic};
    for (Index i = 0; i < 12; ++i)
        for (Index j = 0; j < 10; ++j)
            map.heights(i, j) =
                static_cast<double>((37 * i * i + 11 * i * j + 23 * j * j * j + 5 * i) % 101) / 100.0 * 3.0;
    return map;
}

ArrayTip lopsided_tip() {
    ArrayTip tip{Array2D(5, 5), {1.0, 1.0}, 2, 2};
    for (Index u = -2; u <= 2; ++u)
        for (Index v = -2; v <= 2; ++v)
            tip.heights(u + 2, v + 2) =
                0.15 * static_cast<double>(u * u + v * v) + 0.1 * std::abs(static_cast<double>(u + 2 * v));
    return tip;
}

struct Expected {
    Index x, y;
    double dilated, eroded;
};

void expect_as_scipy(bool periodic, double sum_dilated, double sum_eroded, const std::vector<Expected>& points) {
    const auto image = dilated(surface(periodic), lopsided_tip());
    const auto back = eroded(image, lopsided_tip());
    EXPECT_NEAR(image.heights.sum(), sum_dilated, 1e-12 * sum_dilated);
    EXPECT_NEAR(back.heights.sum(), sum_eroded, 1e-12 * sum_eroded);
    for (const auto& point : points) {
        EXPECT_NEAR(image.heights(point.x, point.y), point.dilated, 1e-12) << point.x << ' ' << point.y;
        EXPECT_NEAR(back.heights(point.x, point.y), point.eroded, 1e-12) << point.x << ' ' << point.y;
    }
}

TEST(GreyDilation, OfANonPeriodicSurfaceMatchesScipy) {
    expect_as_scipy(false, 279.07, 271.3,
                    {{0, 0, 1.68, 1.68},
                     {11, 9, 2.6, 2.6},
                     {0, 9, 2.27, 2.27},
                     {11, 0, 2.64, 2.64},
                     {5, 4, 1.99, 1.99},
                     {6, 8, 2.75, 2.75},
                     {2, 3, 2.45, 2.39}});
}

TEST(GreyDilation, OfAPeriodicSurfaceMatchesScipy) {
    expect_as_scipy(true, 284.35, 276.75,
                    {{0, 0, 2.39, 2.18},
                     {11, 9, 2.6, 2.52},
                     {0, 9, 2.27, 2.27},
                     {11, 0, 2.64, 2.64},
                     {5, 4, 1.99, 1.99},
                     {6, 8, 2.75, 2.75},
                     {2, 3, 2.45, 2.39}});
}

}  // namespace
}  // namespace setae::topography::grey_dilation_test
