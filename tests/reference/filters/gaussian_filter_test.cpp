// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "setae/processing/iso_filter.hpp"

namespace gaussian_filter_test {

using namespace setae;
using namespace setae::processing;
using topography::HeightMap;

/// The map of README.md: pixels of 1 x 0.5.
HeightMap map_of_the_table() {
    return {Array2D::NullaryExpr(120, 90,
                                 [](Index i, Index j) {
                                     const auto x = static_cast<double>(i), y = static_cast<double>(j);
                                     return std::sin(0.37 * x) * std::cos(0.23 * y) +
                                            0.01 * static_cast<double>((7 * i + 3 * j) % 11) + 0.002 * x;
                                 }),
            {120.0, 45.0},
            false,
            {}};
}

struct Expected {
    Index i, j;
    double height;
};

TEST(GaussianFilterOfScipy, AgreesUpToTheCorners) {
    const Array2D smooth = filtered(map_of_the_table(), GaussianFilter{.cutoff = 30.0}).heights;
    for (const auto& [i, j, height] : {Expected{0, 0, 0.0895478491053473},
                                       {119, 45, 0.28914141837756996},
                                       {60, 44, 0.17064648143851763},
                                       {30, 80, 0.09008611091466522}})
        EXPECT_NEAR(smooth(i, j), height, 1e-8) << i << ", " << j;
}

TEST(GaussianFilterOfScipy, AgreesAroundAHole) {
    HeightMap map = map_of_the_table();
    map.heights.block(50, 30, 20, 30).setConstant(std::numeric_limits<double>::quiet_NaN());
    const Array2D smooth = filtered(map, GaussianFilter{.cutoff = 30.0}).heights;
    for (const auto& [i, j, height] :
         {Expected{49, 44, 0.1605354300740514}, {60, 29, 0.16443122939809313}, {45, 62, 0.12638947065639453}})
        EXPECT_NEAR(smooth(i, j), height, 1e-8) << i << ", " << j;
}

}  // namespace gaussian_filter_test
