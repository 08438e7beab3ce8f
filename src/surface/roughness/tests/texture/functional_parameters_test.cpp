// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/texture/functional_parameters.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "samples.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/statistics.hpp"

namespace setae::texture::functional_parameters_test {
namespace {

using topography::HeightMap;
using topography::LineScan;
using topography::Profile;

/// A map whose lines along x all are one line.
HeightMap ruled(const Array1D& line, Index lines = 3) {
    return {line.replicate(1, lines), {static_cast<double>(line.size()), static_cast<double>(lines)}};
}

Array1D sine_line(Index n, double amplitude) {
    return (Array1D::LinSpaced(n, 0.0, static_cast<double>(n - 1)) * (2.0 * pi / static_cast<double>(n - 1))).sin() *
           amplitude;
}

TEST(FunctionalParameters, OfARampMatchAStraightCurve) {
    const auto result = functional_parameters(ruled(Array1D::LinSpaced(101, -1.0, 1.0)));
    EXPECT_NEAR(result.Sk, 2.0, 1e-10);
    EXPECT_NEAR(result.Smrk1, 0.0, 1e-9);
    EXPECT_NEAR(result.Smrk2, 1.0, 1e-9);
    EXPECT_NEAR(result.Spk, 0.0, 1e-9);
    EXPECT_NEAR(result.Svk, 0.0, 1e-9);
    EXPECT_NEAR(result.Vmp, 0.01, 1e-12);  // ∫ of a triangle: p²·2/2
    EXPECT_NEAR(result.Vmc, 0.63, 1e-12);  // 0.8² − 0.1²
    EXPECT_NEAR(result.Vvv, 0.04, 1e-12);  // 0.2²
    EXPECT_NEAR(result.Vvc, 0.77, 1e-12);  // 0.9² − 0.2²
    EXPECT_NEAR(result.Sxp, 0.95, 1e-12);
    EXPECT_NEAR(result.Sdc, 1.92, 1e-12);
}

TEST(FunctionalParameters, OfASineFollowFromItsArccosine) {
    // H(p) = A cos(π p); the flattest secant of 40 % begins at 0 (or, mirrored, ends at 1)
    const double A = 3.0, w = 0.4;
    const auto result = functional_parameters(ruled(sine_line(20001, A)));
    const double mean = A * std::sin(pi * w) / (pi * w);
    // ∫_0^w (p − w/2) cos(π p) dp by parts
    const double moment = A * ((w / 2.0) * std::sin(pi * w) / pi + (std::cos(pi * w) - 1.0) / (pi * pi));
    const double slope = 12.0 * moment / (w * w * w), c1 = mean - slope * w / 2.0, c2 = c1 + slope;
    EXPECT_NEAR(result.Sk, -slope, 1e-6 * A);
    EXPECT_NEAR(result.Smrk1, c1 >= A ? 0.0 : std::acos(c1 / A) / pi, 1e-6);
    EXPECT_NEAR(result.Smrk2, c2 <= -A ? 1.0 : std::acos(c2 / A) / pi, 1e-6);
    EXPECT_NEAR(result.Vmp, A * (std::sin(0.1 * pi) / pi - 0.1 * std::cos(0.1 * pi)), 1e-6 * A);
    EXPECT_NEAR(result.Vmc + result.Vmp, A * (std::sin(0.8 * pi) / pi - 0.8 * std::cos(0.8 * pi)), 1e-6 * A);
    EXPECT_NEAR(result.Vvv, A * (std::sin(0.8 * pi) / pi + 0.2 * std::cos(0.8 * pi)), 1e-6 * A);
    EXPECT_NEAR(result.Vvc + result.Vvv, A * (std::sin(0.1 * pi) / pi + 0.9 * std::cos(0.1 * pi)), 1e-6 * A);
    EXPECT_NEAR(result.Sxp, A * std::cos(0.025 * pi), 1e-6 * A);
}

TEST(FunctionalParameters, OfGaussianHeightsAreKnownMultiplesOfTheirRms) {
    constexpr Index n = 400001;
    const double rms = 0.7;
    LineScan scan{Array1D(n), 1.0};
    for (Index k = 0; k < n; ++k) scan.heights[k] = rms * normal_quantile((static_cast<double>(k) + 0.5) / n);
    const auto result = functional_parameters(scan, {}, Between::nothing);
    const auto density = [](double x) { return std::exp(-0.5 * x * x) / std::sqrt(2.0 * pi); };
    // the core is about p = 1/2; with p = Φ(−z) and x = Φ⁻¹(0.7): Sk/rms = 24/0.4³ ∫_0^x (Φ(z) − 1/2) z φ(z) dz, by
    // parts
    const double x = normal_quantile(0.7);
    const double moment = (normal_probability(x * std::sqrt(2.0)) - 0.5) / (2.0 * std::sqrt(pi)) - 0.2 * density(x);
    EXPECT_NEAR(result.Sk / rms, 24.0 / 0.064 * moment, 2e-4);
    const double c = 0.5 * result.Sk / rms;
    EXPECT_NEAR(result.Smrk1, 1.0 - normal_probability(c), 1e-4);
    EXPECT_NEAR(result.Smrk2, normal_probability(c), 1e-4);
    EXPECT_NEAR(result.Spk / rms, 2.0 * (density(c) / (1.0 - normal_probability(c)) - c), 1e-3);
    EXPECT_NEAR(result.Svk, result.Spk, 1e-4);
    const auto volume = [&](double p) {
        const double z = normal_quantile(1.0 - p);
        return rms * (density(z) - p * z);
    };
    EXPECT_NEAR(result.Vmp, volume(0.1), 1e-5);
    EXPECT_NEAR(result.Vmc, volume(0.8) - volume(0.1), 1e-5);
    EXPECT_NEAR(result.Vvv, volume(0.2), 1e-5);
    EXPECT_NEAR(result.Vvc, volume(0.9) - volume(0.2), 1e-5);
    const auto spacing = [&](double p) {
        return rms / (static_cast<double>(n) * density(normal_quantile(p)));
    };  // of the points there
    EXPECT_NEAR(result.Sxp, rms * normal_quantile(0.975), spacing(0.975));
    EXPECT_NEAR(result.Sdc, 2.0 * rms * normal_quantile(0.98), 2.0 * spacing(0.98));
}

TEST(FunctionalParameters, OfAPlateauWithFewHolesHaveAFlatCore) {
    // 4 of 5 at height 0, one tenth up to 1, one tenth down to −1, as polyline
    Profile profile{Array1D(6), Array1D(6), {}};
    profile.positions << 0.0, 1.0, 2.0, 10.0, 11.0, 12.0;
    profile.heights << 0.0, 1.0, 0.0, 0.0, -1.0, 0.0;
    const auto result = functional_parameters(profile);
    EXPECT_NEAR(result.Sk, 0.0, 1e-6);
    EXPECT_NEAR(result.Spkx, 1.0, 1e-6);
    EXPECT_NEAR(result.Svkx, 1.0, 1e-6);
    EXPECT_NEAR(result.Sak1, 1.0 / 12.0, 1e-6);  // a triangle of base 2 of 12 and height 1
    EXPECT_NEAR(result.Sak2, 1.0 / 12.0, 1e-6);
}

TEST(FunctionalParameters, GiveRatioAtAHeightAndHeightAtARatio) {
    const HeightMap map{tests::random_map(60, 50), {1.0, 1.0}};
    const double height = 0.3;
    const auto found = functional_parameters(map, {.inverse = 0.37, .height = height});
    EXPECT_NEAR(found.Smr, bearing_area(map, Array1D::Constant(1, height))[0], 1e-12);
    EXPECT_NEAR(found.Smc, heights_at_ratio(map, Array1D::Constant(1, 0.37))[0], 1e-13);
    EXPECT_TRUE(std::isnan(functional_parameters(map).Smr));
    EXPECT_THROW((void)functional_parameters(map, {.height = undefined}), InvalidArgument);
}

TEST(FunctionalParameters, DoNotDependOnOffsetAndScaleWithHeight) {
    HeightMap map{tests::random_map(60, 50), {1.0, 1.0}};
    const auto plain = functional_parameters(map);
    map.heights = map.heights * 1e-9 + 1e-2;
    const auto lifted = functional_parameters(map);
    EXPECT_NEAR(lifted.Sk / plain.Sk, 1e-9, 1e-14);
    EXPECT_NEAR(lifted.Spk / plain.Spk, 1e-9, 1e-14);
    EXPECT_NEAR(lifted.Svk / plain.Svk, 1e-9, 1e-14);
    EXPECT_NEAR(lifted.Vmc / plain.Vmc, 1e-9, 1e-14);
    EXPECT_NEAR(lifted.Smrk1, plain.Smrk1, 1e-6);
}

TEST(FunctionalParameters, CoreIsUnaffectedByOneSpike) {
    HeightMap map{tests::random_map(80, 80), {1.0, 1.0}};
    const auto plain = functional_parameters(map);
    map.heights(40, 40) = 1e5;
    EXPECT_NEAR(functional_parameters(map).Sk, plain.Sk, 0.01);
}

TEST(FunctionalParameters, OfAConstantSurfaceVanish) {
    const auto result = functional_parameters(HeightMap{Array2D::Constant(4, 5, 0.1), {1.0, 1.0}});
    EXPECT_EQ(result.Sk, 0.0);
    EXPECT_EQ(result.Vmc, 0.0);
    EXPECT_EQ(result.Smrk2, 1.0);
    EXPECT_THROW((void)functional_parameters(HeightMap{Array2D::Constant(4, 5, 0.1), {1.0, 1.0}}, {.peaks = 1.5}),
                 InvalidArgument);
}

}  // namespace
}  // namespace setae::texture::functional_parameters_test
