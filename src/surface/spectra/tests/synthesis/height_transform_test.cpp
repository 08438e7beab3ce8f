// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/synthesis/height_transform.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/numerics/random_numbers.hpp"

namespace height_transform_test {

using namespace setae;
using namespace setae::synthesis;

TEST(JohnsonHeights, HaveTheRequestedSkewnessAndKurtosis) {
    // the log-normal curve has kurtosis 3, 3.16, 4.83 and 15.9 at these skewnesses
    const HeightShape shapes[] = {{0.0, 1.8},  {0.0, 2.5},  {0.0, 3.01}, {0.0, 12.0}, {0.3, 2.0}, {0.3, 3.15},
                                  {0.3, 3.2},  {0.3, 6.0},  {1.0, 3.2},  {1.0, 4.5},  {1.0, 5.0}, {-1.0, 5.0},
                                  {-1.0, 4.0}, {2.5, 12.0}, {2.5, 30.0}, {3.0, 3.0e3}};
    for (const auto& shape : shapes) {
        const auto transform = johnson_heights(shape);
        const auto found = shape_of(transform);
        EXPECT_NEAR(found.skewness, shape.skewness, 2e-6 * (1.0 + std::abs(shape.skewness)))
            << shape.skewness << " " << shape.kurtosis;
        EXPECT_NEAR(found.kurtosis / shape.kurtosis, 1.0, 5e-6) << shape.skewness << " " << shape.kurtosis;
        for (double z = -8.0; z < 8.0; z += 0.5) EXPECT_LE(transform(z), transform(z + 0.5));
    }
}

TEST(JohnsonHeights, OfGaussianShapeAreTheIdentity) {
    const auto transform = johnson_heights({0.0, 3.0});
    for (const double z : {-3.0, 0.0, 1.7}) EXPECT_EQ(transform(z), z);
}

TEST(JohnsonHeights, OnTheLognormalLineAreLognormal) {
    // σ = ½: w = e^¼, skewness (w + 2)√(w − 1), kurtosis w⁴ + 2w³ + 3w² − 3
    const double w = std::exp(0.25), skewness = (w + 2.0) * std::sqrt(w - 1.0);
    const auto transform = johnson_heights({skewness, w * w * w * w + 2.0 * w * w * w + 3.0 * w * w - 3.0});
    for (const double z : {-3.0, 0.0, 2.0})
        EXPECT_NEAR(transform(z), (std::exp(0.5 * z - 0.125) - 1.0) / std::sqrt(w - 1.0), 1e-12);
}

TEST(JohnsonHeights, OfRandomNumbersHaveMeanZeroAndUnitVariance) {
    constexpr Index n = 100000;
    const auto transform = johnson_heights({0.8, 3.5});
    const Array1D values = numerics::normal_numbers({3, 0}, 0, n).unaryExpr([&](double z) { return transform(z); });
    EXPECT_LT(std::abs(values.mean()), 4.0 / std::sqrt(n));
    EXPECT_LT(std::abs(values.square().mean() - 1.0), 4.0 * std::sqrt(2.5 / n));
}

TEST(LognormalHeights, HaveTheRequestedSkewnessAndItsKurtosis) {
    for (const double skewness : {-2.0, 0.4, 1.0}) {
        const auto found = shape_of(lognormal_heights(skewness));
        EXPECT_NEAR(found.skewness, skewness, 1e-8 * std::abs(skewness));
    }
    EXPECT_NEAR(shape_of(lognormal_heights(1.75018965)).kurtosis, 8.89844567, 1e-6);  // σ = ½, closed form
}

TEST(TransformCorrelation, OfLognormalHeightsMatchesTheClosedForm) {
    const double w = std::exp(0.25), skewness = (w + 2.0) * std::sqrt(w - 1.0);
    const TransformCorrelation correlation(lognormal_heights(skewness));
    for (const double rho : {-1.0, -0.5, 0.0, 0.3, 0.99, 1.0}) {
        EXPECT_NEAR(correlation.transformed(rho), std::expm1(0.25 * rho) / (w - 1.0), 1e-12) << rho;
        EXPECT_NEAR(correlation.slope(rho), 0.25 * std::exp(0.25 * rho) / (w - 1.0), 1e-12) << rho;
        EXPECT_NEAR(correlation.parent(correlation.transformed(rho)), rho, 1e-12) << rho;
    }
    EXPECT_EQ(correlation.parent(-0.99), -1.0);
    EXPECT_EQ(correlation.parent(1.0), 1.0);
}

TEST(TransformCorrelation, OfUniformHeightsIsTheArcsine) {
    // y = Φ(z): ρ_g = (6/π) arcsin(ρ/2), Pearson 1907; the series converges like n^-5/2 at ρ = 1
    const TransformCorrelation correlation([](double z) { return std::sqrt(3.0) * std::erf(z / std::sqrt(2.0)); });
    for (const double rho : {-0.9, -0.2, 0.5, 0.95})
        EXPECT_NEAR(correlation.transformed(rho), 6.0 / pi * std::asin(0.5 * rho), 1e-12);
}

TEST(HeightTransforms, RefuseImpossibleShapes) {
    EXPECT_THROW((void)johnson_heights({1.0, 1.9}), InvalidArgument);  // below skewness² + 1
    EXPECT_THROW((void)johnson_heights({5.0, 60.0}), InvalidArgument);
    EXPECT_THROW((void)johnson_heights({0.0, 1e9}), InvalidArgument);
    EXPECT_THROW((void)johnson_heights({0.0, NAN}), InvalidArgument);
    EXPECT_THROW((void)lognormal_heights(INFINITY), InvalidArgument);
    EXPECT_THROW(TransformCorrelation([](double z) { return -z; }), InvalidArgument);
}

}  // namespace height_transform_test
