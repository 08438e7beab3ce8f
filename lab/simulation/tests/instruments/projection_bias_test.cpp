// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/simulation/projection_bias.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace projection_bias_test {

using namespace setae;
using namespace setae::simulation;
using synthesis::SurfaceGrid;

constexpr spectra::SelfAffine rough{1e-37, 2.0 * pi / 40e-9, 0.8, 2.0 * pi / 1e-9};

ProjectionOptions foils(double thickness) {
    ProjectionOptions options;
    options.thickness = thickness;
    options.grid = {256, 256, 102.4e-9, 102.4e-9};
    options.surfaces = 8;
    options.key = {2, 0};
    options.threads = {2};
    return options;
}

TEST(ProjectionBias, IsOneForAFoilWithoutThickness) {
    const auto bias = projection_bias(density(rough), foils(0.0));
    EXPECT_TRUE((bias.C1D == 1.0).all());
    EXPECT_TRUE((bias.C1D_standard_error == 0.0).all());
    EXPECT_EQ(bias.rms_height.value, 1.0);
    EXPECT_EQ(bias.rms_slope.value, 1.0);
    EXPECT_EQ(bias.mean_height_shift, 0.0);
    EXPECT_TRUE(projection_alerts(bias, "contour").empty());
}

TEST(ProjectionBias, KeepsWavesLongerThanTheFoilAndAddsPowerAtTheShortEnd) {
    const auto bias = projection_bias(density(rough), foils(2e-9));
    const auto last = bias.C1D.size() - 1;
    EXPECT_NEAR(bias.C1D[0], 1.0, 0.03);  // 100 nm against 2 nm
    EXPECT_LT(bias.C1D.minCoeff(), 0.9);  // between: valleys behind ridges
    EXPECT_GT(bias.C1D[last], 1.5);       // where lines have no power left, ridges taking over from ridges do
    EXPECT_GT(bias.mean_height_shift, 0.1);
    EXPECT_LT(bias.rms_slope.value, 1.0);
    const auto alerts = projection_alerts(bias, "contour 3");
    ASSERT_EQ(alerts.size(), 1U);
    EXPECT_EQ(alerts[0].code, "FOIL_PROJECTION");
    EXPECT_EQ(alerts[0].subject, "contour 3");
    EXPECT_NE(alerts[0].message.find("2 nm thick"), std::string::npos) << alerts[0].message;
}

TEST(ProjectionBias, DoesNotDependOnTheScaleOfHeights) {
    auto higher = rough;
    higher.plateau *= 400.0;
    const auto low = projection_bias(density(rough), foils(3e-9)), high = projection_bias(density(higher), foils(3e-9));
    EXPECT_LT((low.C1D - high.C1D).abs().maxCoeff(), 1e-9);
    EXPECT_NEAR(low.rms_slope.value, high.rms_slope.value, 1e-9);
}

TEST(ProjectionBias, GrowsWithThickness) {
    double slope = 1.0;
    for (const double thickness : {0.8e-9, 3.2e-9, 12.8e-9, 51.2e-9}) {
        const auto bias = projection_bias(density(rough), foils(thickness));
        EXPECT_LT(bias.rms_slope.value, slope) << thickness;
        slope = bias.rms_slope.value;
    }
}

TEST(ProjectionBias, CorrectsSilhouettesOfOtherSurfacesToLineScans) {
    const auto known = projection_bias(density(rough), foils(5e-9));
    auto options = foils(5e-9);
    options.key = {3, 0};
    const auto other = projection_bias(density(rough), options);
    const Array1D corrected = other.C1D / known.C1D;
    const Array1D error = (known.C1D_standard_error.square() + other.C1D_standard_error.square()).sqrt() / known.C1D;
    // twelve bins at four standard errors, which eight surfaces determine to a quarter
    for (Index b = 0; b < corrected.size(); ++b) EXPECT_NEAR(corrected[b], 1.0, 5.0 * error[b]) << b;
}

TEST(ProjectionBias, RecoversTheCorrelationLengthOfAGaussianSpectrum) {
    // C_iso = π ℓ² h² exp(−q²ℓ²/4) has the autocorrelation h² exp(−x²/ℓ²)
    const double length = 3e-9, height = 1e-9;
    const auto gaussian = [=](double q) {
        return pi * length * length * height * height * std::exp(-0.25 * q * q * length * length);
    };
    const auto bias = projection_bias(gaussian, foils(0.0));
    // eight maps of (102.4/3)²/π patches each determine h² to 1.5 %, the length to about 1 %
    EXPECT_NEAR(bias.correlation_length, length, 0.04 * length);
}

TEST(ProjectionBias, IsTheSameForAnyNumberOfThreads) {
    auto options = foils(5e-9);
    const auto two = projection_bias(density(rough), options);
    options.threads = {1};
    const auto one = projection_bias(density(rough), options);
    EXPECT_TRUE((one.C1D == two.C1D).all());
    EXPECT_EQ(one.rms_slope.value, two.rms_slope.value);
}

TEST(ProjectionBias, RefusesFoilsWiderThanTheSurface) {
    EXPECT_THROW((void)projection_bias(density(rough), foils(102.4e-9)), InvalidArgument);
    EXPECT_THROW((void)projection_bias(density(rough), foils(-1e-9)), InvalidArgument);
    auto options = foils(0.0);
    options.surfaces = 1;
    EXPECT_THROW((void)projection_bias(density(rough), options), InvalidArgument);
}

}  // namespace projection_bias_test
