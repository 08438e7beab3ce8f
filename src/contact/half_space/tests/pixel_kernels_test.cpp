// SPDX-License-Identifier: GPL-3.0-or-later
#include "pixel_kernels.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "setae/core/constants.hpp"

namespace setae::half_space::pixel_kernels_test {
namespace {

TEST(RectangleDisplacement, HasThirteenDigitsNearAndFar) {
    // the closed form with 60 digits (mpmath 1.3)
    struct Reference {
        double x, y, a, b, displacement;
    };
    for (const auto& [x, y, a, b, displacement] : {Reference{0, 0, 0.5, 0.5, 1.1221997046783603},
                                                   {0.5, 0.5, 0.5, 0.5, 0.56109985233918013},
                                                   {1, 0, 0.5, 0.5, 0.33042149328895688},
                                                   {3, 2, 0.5, 0.5, 0.08857253191956765},
                                                   {0, 4, 0.5, 0.5, 0.079783563625848894},
                                                   {4, 4, 0.5, 0.5, 0.056343843432159374},
                                                   {5, 0, 0.5, 0.5, 0.063767707534653556},
                                                   {29, 3, 0.5, 0.5, 0.01091847417301266},
                                                   {100, 77, 0.5, 0.5, 0.0025220692506981451},
                                                   {250, 1, 0.5, 0.5, 0.001273230207745838},
                                                   {1999, 10, 0.5, 0.5, 0.00015923256964583637},
                                                   {2001, 10, 0.5, 0.5, 0.00015907342062611128},
                                                   {16384, 16384, 0.5, 0.5, 1.3737736758834531e-5},
                                                   {1e6, 1, 0.5, 0.5, 3.1830988618364478e-7},
                                                   {3, 2, 0.5, 0.05, 0.0088587033911343202},
                                                   {0, 0.1, 0.5, 0.05, 0.15014219450920786},
                                                   {7, 7, 0.5, 0.05, 0.0032161041809645531}}) {
        EXPECT_NEAR(rectangle_displacement(x, y, {a, b}) / displacement, 1.0, 1e-13) << x << ' ' << y;
        EXPECT_NEAR(rectangle_displacement(-y, x, {b, a}) / displacement, 1.0, 1e-13) << x << ' ' << y;
    }
    EXPECT_NEAR(rectangle_displacement(0.0, 0.0, {0.5, 0.5}), 4.0 * std::log1p(std::sqrt(2.0)) / pi, 1e-15);
}

TEST(StripDisplacement, IsTheIntegralOfTheBesselFunction) {
    // 2/π ∫ K_0(q|y'|) dy' by quadrature with 30 digits (mpmath 1.3)
    struct Reference {
        double q, y, displacement;
    };
    for (const auto& [q, y, displacement] : {Reference{0.01, 0, 4.0834466125669913},
                                             {1, 0, 1.1804235916731979},
                                             {3.1, 0, 0.57703797089598015},
                                             {0.01, 1, 3.0344368762933672},
                                             {1, 1, 0.2976069747727466},
                                             {3, 4, 2.0472975601332443e-6},
                                             {0.01, 100, 0.26803519546606351}})
        EXPECT_NEAR(strip_displacement(q, y, 0.5, 1.0) / displacement, 1.0, 1e-13) << q << ' ' << y;
}

TEST(StripDisplacement, OfUniformPressureIsTheSumOverRepeats) {
    constexpr double repeat = 3.0, b = 0.5;
    for (const double y : {0.0, 1.0, 7.0}) {
        double sum = rectangle_displacement(0.0, y, {0.5 * repeat, b});
        constexpr int last = 20000;
        for (int n = last; n >= 1; --n)
            sum += 2.0 * (rectangle_displacement(n * repeat, y, {0.5 * repeat, b}) - 2.0 * b / (pi * n));
        // what is left of the sum falls as 1/n³
        EXPECT_NEAR(strip_displacement(0.0, y, b, repeat), sum, 1e-8) << y;
    }
    // far away ln|y'| averages over the strip to ln y − b²/(6y²) − b⁴/(20y⁴)
    EXPECT_NEAR(strip_displacement(0.0, 100.0, b, repeat),
                -2.0 / pi * (std::log(100.0 / 6.0) + 0.57721566490153286 - 0.25 / 6e4 - 0.0625 / 20e8), 1e-14);
}

}  // namespace
}  // namespace setae::half_space::pixel_kernels_test
