// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/scales/half_derivative.hpp"

#include <gtest/gtest.h>

#include "brute_force.hpp"
#include "samples.hpp"
#include "setae/core/errors.hpp"
#include "setae/scales/autocorrelation.hpp"

namespace setae::scales {
namespace {

using namespace setae::tests;
using topography::HeightMap;
using topography::LineScan;

HeightMap wave(Index nx, Index ny, double k, double m, double amplitude = 0.2) {
    HeightMap map{Array2D(nx, ny), {3.0, 2.0}, true, {}};
    for (Index i = 0; i < nx; ++i)
        for (Index j = 0; j < ny; ++j)
            map.heights(i, j) = amplitude * std::cos(2.0 * pi *
                                                     (k * static_cast<double>(i) / static_cast<double>(nx) +
                                                      m * static_cast<double>(j) / static_cast<double>(ny)));
    return map;
}

TEST(HalfDerivative, OfACosineStoresAnEighthOfQTimesSquaredAmplitude) {
    const double modulus = 1e6;
    for (const auto& [nx, ny] : {std::pair<Index, Index>{32, 32}, {33, 27}})
        for (const auto& [k, m] : {std::pair{3.0, 0.0}, {0.0, 4.0}, {3.0, 2.0}, {-3.0, 2.0}}) {
            const double q = 2.0 * pi * std::hypot(k / 3.0, m / 2.0);
            const auto half = half_derivative_variance(wave(nx, ny, k, m));
            EXPECT_NEAR(half.energy_per_area(modulus) / (modulus * q * 0.04 / 8.0), 1.0, 1e-12);
            EXPECT_EQ(half.assumption, "none");
        }
}

TEST(HalfDerivative, OfAProductOfCosinesStoresASixteenth) {
    auto map = wave(32, 32, 3.0, 2.0);
    map.heights = 0.5 * (map.heights + wave(32, 32, 3.0, -2.0).heights);  // cos a cos b
    const double q = 2.0 * pi * std::hypot(1.0, 1.0);
    EXPECT_NEAR(half_derivative_variance(map).energy_per_area(1.0) / (q * 0.04 / 16.0), 1.0, 1e-12);
}

TEST(HalfDerivative, OfACheckerboardAtNyquistCountsOnce) {
    HeightMap map{Array2D(16, 16), {1.6, 1.6}, true, {}};
    for (Index i = 0; i < 16; ++i)
        for (Index j = 0; j < 16; ++j) map.heights(i, j) = (i + j) % 2 == 0 ? 1.0 : -1.0;
    EXPECT_NEAR(half_derivative_variance(map).variance / (pi / 0.1 * std::sqrt(2.0)), 1.0, 1e-12);
}

TEST(HalfDerivative, OfALineSaysWhatItIsTakenFor) {
    const HeightMap map = wave(64, 8, 5.0, 0.0);
    const LineScan line{map.heights.col(0), 3.0, true, {}};
    const auto grating = half_derivative_variance(line, SurfaceKind::grating),
               isotropic = half_derivative_variance(line, SurfaceKind::isotropic);
    EXPECT_NEAR(grating.variance / half_derivative_variance(map).variance, 1.0, 1e-12);
    EXPECT_NEAR(isotropic.variance / grating.variance, 0.5 * pi, 1e-12);
    EXPECT_EQ(grating.assumption, "grating");
    EXPECT_EQ(isotropic.assumption, "isotropic");
}

TEST(HalfDerivative, SeesNeitherOffsetNorTilt) {
    HeightMap map{random_map(48, 40), {4.8, 4.0}, false, {}};
    const double as_is = half_derivative_variance(map).variance;
    for (Index i = 0; i < 48; ++i)
        for (Index j = 0; j < 40; ++j)
            map.heights(i, j) += 10.0 + 3.0 * 0.1 * static_cast<double>(i) - 0.1 * static_cast<double>(j);
    EXPECT_NEAR(half_derivative_variance(map).variance / as_is, 1.0, 1e-11);
    LineScan line{random_heights(100), 10.0, false, {}};
    const double of_line = half_derivative_variance(line, SurfaceKind::isotropic).variance;
    line.heights += 10.0 + Array1D::LinSpaced(100, 0.0, 50.0);
    EXPECT_NEAR(half_derivative_variance(line, SurfaceKind::isotropic).variance / of_line, 1.0, 1e-11);
}

TEST(HalfDerivative, RefusesUndefinedHeights) {
    EXPECT_THROW((void)half_derivative_variance(tests::with_holes({random_map(12, 12), {1.0, 1.0}, true, {}})),
                 UndefinedDataError);
}

/// A(r) of one cosine along x and of its angular mean, in closed form.
FunctionOfScale closed_form(const std::string& quantity, double (*one_minus)(double)) {
    FunctionOfScale A;
    A.quantity = quantity;
    A.distance = log_spaced(4000, 1e-4, 3e3);
    A.value = A.distance.unaryExpr([&](double r) { return 0.5 * one_minus(r); });
    A.count = A.standard_error = Array1D::Zero(4000);
    return A;
}

TEST(HalfDerivative, FromAClosedAutocorrelationIsTheWavevector) {
    // h = cos x, q = 1: variance of the half derivative q h0²/2
    const auto lines = closed_form("autocorrelation", [](double r) { return 1.0 - std::cos(r); });
    EXPECT_NEAR(half_derivative_from_autocorrelation(lines, std::sqrt(0.5), SurfaceKind::grating).variance, 0.5, 0.002);
    EXPECT_NEAR(half_derivative_from_autocorrelation(lines, std::sqrt(0.5), SurfaceKind::isotropic).variance, 0.25 * pi,
                0.003);
    const auto area = closed_form("autocorrelation_of_area", [](double r) { return 1.0 - std::cyl_bessel_j(0.0, r); });
    EXPECT_NEAR(half_derivative_from_autocorrelation(area, std::sqrt(0.5), SurfaceKind::grating).variance, 0.5, 0.002);
}

TEST(HalfDerivative, FromTheAutocorrelationOfAMapIsThatOfItsTransform) {
    // long waves, so that neither pixels nor the size cut much: sums of a few cosines in all directions
    HeightMap map{Array2D::Zero(256, 256), {1.0, 1.0}, true, {}};
    double expected = 0.0, variance = 0.0;
    for (const auto& [k, m] : {std::pair{12.0, 0.0}, {0.0, 12.0}, {8.0, 9.0}, {9.0, -8.0}, {5.0, 11.0}, {11.0, -5.0}}) {
        HeightMap part = wave(256, 256, k, m, 0.01);
        map.heights += part.heights;
        expected += 2.0 * pi * std::hypot(k, m) * 0.5e-4;
        variance += 0.5e-4;
    }
    EXPECT_NEAR(half_derivative_variance(map).variance / expected, 1.0, 1e-10);
    const auto area = autocorrelation_of_area(map, {20});
    EXPECT_NEAR(
        half_derivative_from_autocorrelation(area, std::sqrt(variance), SurfaceKind::isotropic).variance / expected,
        1.0, 0.03);
}

TEST(HalfDerivative, FromSomethingElseIsAnError) {
    FunctionOfScale slope;
    slope.quantity = "rms_slope";
    EXPECT_THROW((void)half_derivative_from_autocorrelation(slope, 1.0, SurfaceKind::isotropic), InvalidArgument);
    slope.quantity = "autocorrelation";
    EXPECT_THROW((void)half_derivative_from_autocorrelation(slope, 1.0, SurfaceKind::isotropic), InvalidArgument);
}

}  // namespace
}  // namespace setae::scales
