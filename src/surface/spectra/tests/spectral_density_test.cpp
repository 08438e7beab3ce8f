// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectra/spectral_density.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "samples.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace spectral_density_test {

using namespace setae;
using namespace setae::spectra;

TEST(SelfAffineDensity, EqualsThePowerSpectrumOfTheModel) {
    const SelfAffine model{3.0, 2.0, 0.6, 50.0};
    const auto C_iso = density(model);
    const auto q = tests::log_spaced(50, 0.1, 100.0);
    const auto expected = isotropic_power_spectrum(model, q);
    for (Index k = 0; k < q.size(); ++k) EXPECT_NEAR(C_iso(q[k]), expected[k], 1e-15 * expected[k]);
}

TEST(SelfAffineDensity, RefusesContradictoryParameters) {
    EXPECT_THROW((void)density(SelfAffine{1.0, 2.0, 0.8, 2.0}), InvalidArgument);
    EXPECT_THROW((void)density(SelfAffine{1.0, 2.0, 1.01, 4.0}), InvalidArgument);
    EXPECT_THROW((void)density(SelfAffine{1.0, 2.0, 0.0, 4.0}), InvalidArgument);
    EXPECT_THROW((void)density(SelfAffine{-1.0, 2.0, 0.8, 4.0}), InvalidArgument);
    EXPECT_THROW((void)density(SelfAffine{1.0, 0.0, 0.8, 4.0}), InvalidArgument);
    EXPECT_THROW((void)density(SelfAffine{undefined, 2.0, 0.8, 4.0}), InvalidArgument);
    try {
        (void)density(SelfAffine{1.0, 2.0, 0.8, 1.0});
        FAIL();
    } catch (const InvalidArgument& error) {
        EXPECT_NE(std::string(error.what()).find("q_s > q_r"), std::string::npos) << error.what();
    }
}

TEST(TabulatedDensity, IsAPowerLawBetweenNodesAndZeroAboveTheLast) {
    const auto C = tabulated_density(Array1D{{1.0, 10.0, 100.0, 200.0}}, Array1D{{8.0, 8e-3, 0.0, 0.0}});
    EXPECT_EQ(C(0.01), 8.0);
    EXPECT_EQ(C(1.0), 8.0);
    EXPECT_NEAR(C(std::sqrt(10.0)), 8.0 * std::pow(10.0, -1.5), 1e-14);
    EXPECT_NEAR(C(55.0), 4e-3, 1e-15);
    EXPECT_EQ(C(150.0), 0.0);
    EXPECT_EQ(C(201.0), 0.0);
}

TEST(TabulatedDensity, RefusesInvalidRows) {
    const Array1D q{{1.0, 2.0, 3.0}};
    EXPECT_THROW((void)tabulated_density(q, Array1D{{1.0, -1.0, 1.0}}), InvalidArgument);
    EXPECT_THROW((void)tabulated_density(q, Array1D{{1.0, undefined, 1.0}}), InvalidArgument);
    EXPECT_THROW((void)tabulated_density(q, Array1D{{1.0, INFINITY, 1.0}}), InvalidArgument);
    EXPECT_THROW((void)tabulated_density(q, Array1D{{1.0, 1.0}}), InvalidArgument);
    EXPECT_THROW((void)tabulated_density(Array1D{{1.0, 1.0, 3.0}}, q), InvalidArgument);
    EXPECT_THROW((void)tabulated_density(Array1D{{0.0, 1.0, 3.0}}, q), InvalidArgument);
    EXPECT_THROW((void)tabulated_density(Array1D::Ones(1), Array1D::Ones(1)), InvalidArgument);
}

TEST(ProfileDensity, IsTheAbelIntegralOfTheModel) {
    const SelfAffine model{1.0, 1.0, 0.8, 300.0};
    const auto C1D = profile_density(density(model), {0.01, 1e4});
    auto q = tests::log_spaced(400, 1e-5, 299.9);
    const auto expected = profile_power_spectrum(model, q);
    // power laws between nodes, error 1e-5 halfway between, also at the bend and close to the cutoff
    for (Index k = 0; k < q.size(); ++k) EXPECT_NEAR(C1D(q[k]) / expected[k], 1.0, 2e-5) << q[k];
    EXPECT_EQ(C1D(300.0), 0.0);
    EXPECT_EQ(C1D(301.0), 0.0);
}

TEST(ProfileDensity, RisesBelowABandThatStartsAtTheRolloff) {
    // C_iso is constant there, C1D is not: from q_r to 0 it grows by 60 %
    const SelfAffine model{1.0, 1.0, 0.8, 300.0};
    const auto C1D = profile_density(density(model), {1.0, 300.0});
    auto q = tests::log_spaced(100, 1e-6, 2.0);
    const auto expected = profile_power_spectrum(model, q);
    for (Index k = 0; k < q.size(); ++k) EXPECT_NEAR(C1D(q[k]) / expected[k], 1.0, 2e-5) << q[k];
    EXPECT_GT(C1D(1e-6) / C1D(1.0), 1.5);
    // only a plateau: C1D = sqrt(q_s^2 - q^2)/pi
    const auto flat = profile_density([](double wavevector) { return wavevector <= 5.0 ? 1.0 : 0.0; }, {2.0, 10.0});
    for (const double x : {0.0, 0.01, 1.0, 2.0, 3.0, 4.9, 4.9999})
        EXPECT_NEAR(flat(x), std::sqrt(25.0 - x * x) / pi, 1e-5 * flat(x)) << x;
}

TEST(ProfileDensity, ReproducesJumps) {
    // two plateaus: the sum of two semicircles
    const auto C1D = profile_density([](double q) { return q < 3.0 ? 2.0 : 0.5; }, {0.1, 7.0});
    for (const double q : {0.001, 0.5, 2.0, 2.9, 3.1, 6.0, 6.99}) {
        const double exact = (0.5 * std::sqrt(49.0 - q * q) + (q < 3.0 ? 1.5 * std::sqrt(9.0 - q * q) : 0.0)) / pi;
        EXPECT_NEAR(C1D(q) / exact, 1.0, 1e-4) << q;
    }
}

TEST(ProfileDensity, FollowsASpectrumThatFallsToZero) {
    // C = 1 up to 1, then 2 - q: elementary integrals of q/sqrt and q^2/sqrt
    const auto C1D =
        profile_density(tabulated_density(Array1D{{0.5, 1.0, 2.0, 3.0}}, Array1D{{1.0, 1.0, 0.0, 0.0}}), {0.5, 3.0});
    for (const double x : {0.01, 0.3, 0.9, 1.1, 1.5, 1.9}) {
        const auto antiderivative = [x](double q) {
            const double v = std::sqrt(q * q - x * x);
            return 2.0 * v - 0.5 * (q * v + x * x * std::log(q + v));
        };
        const double exact =
            (antiderivative(2.0) - antiderivative(std::max(1.0, x)) + (x < 1.0 ? std::sqrt(1.0 - x * x) : 0.0)) / pi;
        EXPECT_NEAR(C1D(x) / exact, 1.0, x < 1.8 ? 3e-5 : 3e-4) << x;
    }
}

TEST(ProfileDensity, RefusesBandsAndSpectraWithoutPower) {
    EXPECT_THROW((void)profile_density([](double) { return 1.0; }, {2.0, 1.0}), InvalidArgument);
    EXPECT_THROW((void)profile_density([](double) { return 0.0; }, {1.0, 2.0}), InvalidArgument);
    EXPECT_THROW((void)profile_density([](double q) { return q > 1.0 ? 0.0 : 1.0; }, {1.0, 2.0}), InvalidArgument);
}

TEST(SurfaceDensity, RecoversTheSurfaceOfTabulatedLines) {
    const SelfAffine model{3.0, 0.1, 0.8, 100.0};
    const Array1D nodes = tests::log_spaced(61, 1e-2, 100.0), q = nodes.head(60);
    const auto C1D = profile_density(density(model), {1e-3, 100.0});
    const auto C_iso = surface_density(q, q.unaryExpr(C1D));
    EXPECT_EQ(C_iso(101.0), 0.0);
    for (const double wavevector : {0.3, 1.0, 10.0, 50.0})
        EXPECT_NEAR(C_iso(wavevector) / density(model)(wavevector), 1.0, 0.02) << wavevector;
    EXPECT_THROW((void)surface_density(Array1D{{1.0}}, Array1D{{1.0}}), InvalidArgument);
}

TEST(MomentOfADensity, MatchesTheClosedFormOfTheModel) {
    // below the band the plateau contributes lower^(n+2)/(n+2); the band has ends of pieces at its kinks, a decade
    // apart
    const SelfAffine model{2.0, 1.0, 0.7, 1000.0};
    for (const double order : {0.0, 1.0, 2.0, 4.0}) {
        const double below = 2.0 * std::pow(0.1, order + 2.0) / (order + 2.0);
        EXPECT_NEAR((moment(density(model), order, {0.1, 1000.0}) + below) / moment(model, order), 1.0, 1e-12) << order;
    }
    EXPECT_THROW((void)moment(density(model), 0.0, {0.0, 1.0}), InvalidArgument);
}

}  // namespace spectral_density_test
