// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/loops/crack_speed_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "setae/core/errors.hpp"
#include "synthetic_loop.hpp"

namespace setae::loops::crack_speed_fit_test {
namespace {

constexpr contact::crack_speed::Law rubber{.threshold = 0.05, .reference_speed = 2e-7, .exponent = 0.6};

CrackSpeedPoints points_of(const contact::crack_speed::Law& law, double slowest = 1e-8, double fastest = 1e-4,
                           Index n = 40) {
    const Array1D speed = Array1D::LinSpaced(n, std::log(slowest), std::log(fastest)).exp();
    return {.speed = speed, .energy_release_rate = contact::crack_speed::energy_release_rate(speed, law)};
}

std::string reason(const CrackSpeedPoints& points, const CrackSpeedOptions& options = {}) {
    try {
        (void)fit_crack_speed(points, options);
    } catch (const UndefinedDataError& error) {
        return error.what();
    }
    return "";
}

TEST(CrackSpeedFit, RecoversTheLawFromNoiseFreePoints) {
    for (const double exponent : {0.15, 0.6, 1.0}) {
        const contact::crack_speed::Law law{.threshold = 0.05, .reference_speed = 2e-7, .exponent = exponent};
        const CrackSpeedFit fit = fit_crack_speed(points_of(law));
        EXPECT_TRUE(fit.converged);
        EXPECT_NEAR(fit.threshold.value / law.threshold, 1.0, 1e-8);
        EXPECT_NEAR(fit.reference_speed.value / law.reference_speed, 1.0, 1e-8);
        EXPECT_NEAR(fit.exponent.value / exponent, 1.0, 1e-8);
        const CrackSpeedFit held = fit_crack_speed(points_of(law), {.exponent = exponent});
        EXPECT_NEAR(held.threshold.value / law.threshold, 1.0, 1e-8);
        EXPECT_NEAR(held.reference_speed.value / law.reference_speed, 1.0, 1e-8);
        EXPECT_EQ(held.exponent.standard_error, 0.0);
        EXPECT_EQ(held.covariance(2, 2), 0.0);
    }
}

TEST(CrackSpeedFit, StandardErrorsAreTheScatterOfRepetitions) {
    std::mt19937_64 generator(11);
    constexpr int repetitions = 200;
    const CrackSpeedPoints exact = points_of(rubber);
    std::normal_distribution<double> normal;
    double mean = 0.0, square = 0.0, claimed = 0.0;
    for (int k = 0; k < repetitions; ++k) {
        CrackSpeedPoints noisy = exact;
        noisy.energy_release_rate_standard_error = 0.05 * exact.energy_release_rate;
        for (Index i = 0; i < exact.speed.size(); ++i) noisy.energy_release_rate[i] *= 1.0 + 0.05 * normal(generator);
        const CrackSpeedFit fit = fit_crack_speed(noisy);
        mean += fit.exponent.value / repetitions;
        square += fit.exponent.value * fit.exponent.value / repetitions;
        claimed += fit.exponent.standard_error / repetitions;
    }
    const double scatter = std::sqrt(square - mean * mean);
    EXPECT_NEAR(mean, 0.6, 4.0 * scatter / std::sqrt(repetitions));
    // the scatter of 200 is itself known to 5 %, the claims follow few residuals
    EXPECT_NEAR(claimed / scatter, 1.0, 0.2);
}

TEST(CrackSpeedFit, LeavesHealingEdgesOut) {
    CrackSpeedPoints points = points_of(rubber);
    points.speed[3] = -1e-8;
    points.speed[7] = 0.0;
    const CrackSpeedFit fit = fit_crack_speed(points);
    EXPECT_EQ(fit.left_out, 2);
    EXPECT_EQ(fit.n, 38);
    EXPECT_NEAR(fit.exponent.value, 0.6, 1e-8);
}

TEST(CrackSpeedFit, RefusesWhatHoldsNoLaw) {
    EXPECT_NE(reason(points_of(rubber, 1e-6, 2e-6)).find("a factor 2"), std::string::npos);
    CrackSpeedPoints falling = points_of(rubber);
    falling.energy_release_rate = falling.energy_release_rate.reverse().eval();
    EXPECT_NE(reason(falling).find("does not rise"), std::string::npos);
    // a pure power of speed has no threshold
    CrackSpeedPoints power = points_of(rubber);
    power.energy_release_rate = power.speed.pow(0.6);
    EXPECT_NE(reason(power).find("G0"), std::string::npos);
    EXPECT_NE(reason({.speed = Array1D::Constant(9, -1e-6), .energy_release_rate = Array1D::Ones(9)}).find("0 of 9"),
              std::string::npos);
    EXPECT_THROW((void)fit_crack_speed({.speed = Array1D::Ones(3), .energy_release_rate = Array1D::Ones(4)}),
                 InvalidArgument);
    EXPECT_THROW((void)fit_crack_speed(points_of(rubber), {.exponent = -1.0}), InvalidArgument);
}

TEST(EdgeSpeeds, OfAParabolaAreExactAtAnySpacing) {
    Array1D time(30);
    for (Index i = 0; i < 30; ++i) time[i] = 0.1 * static_cast<double>(i) + 0.03 * std::sin(static_cast<double>(i));
    const Array1D radius = 1e-4 - 1e-6 * time - 3e-6 * time.square();
    const EdgeSpeeds edge = speeds_of_edge(time, radius, 7);
    EXPECT_LT((edge.speed - (1e-6 + 6e-6 * time)).abs().maxCoeff(), 1e-16);
    EXPECT_EQ(edge.window, 7);
}

TEST(EdgeSpeeds, StandardErrorIsThatOfTheWindow) {
    std::mt19937_64 generator(2);
    const Array1D time = Array1D::LinSpaced(400, 0.0, 40.0);
    const Array1D radius = tests::with_noise(Array1D(2e-4 - 1e-6 * time), 1e-8, generator);
    const EdgeSpeeds edge = speeds_of_edge(time, radius, 9);
    EXPECT_NEAR(edge.contact_radius_noise / 1e-8, 1.0, 0.1);
    // of a straight line through 9 even samples: σ/(Δt √60)
    const double step = 40.0 / 399.0;
    EXPECT_NEAR(edge.standard_error[200] / (1e-8 / (step * std::sqrt(60.0))), 1.0, 0.1);
    const Array1D pull = (edge.speed - 1e-6) / edge.standard_error;
    EXPECT_NEAR(std::sqrt(pull.square().mean()), 1.0, 0.15);  // neighbours share samples: some 45 independent ones
    EXPECT_THROW((void)speeds_of_edge(time, radius, 8), InvalidArgument);
    EXPECT_THROW((void)speeds_of_edge(time.reverse().eval(), radius), InvalidArgument);
    EXPECT_THROW((void)speeds_of_edge(time.head(4), radius.head(4)), UndefinedDataError);
}

TEST(CrackSpeedFit, FindsTheLawOfAContactThatFollowsIt) {
    // an edge that recedes so that G rises as the law says: da/dt = −v(G(a))
    const contact::crack_speed::Law slow{.threshold = 0.05, .reference_speed = 2e-9, .exponent = 0.6};
    const Array1D time = Array1D::LinSpaced(400, 0.0, 60.0);
    Array1D radius(400), rate(400);
    double a = 1.5e-4;
    for (Index i = 0; i < 400; ++i) {
        rate[i] = 0.055 * std::exp(time[i] / 20.0);
        radius[i] = a;
        constexpr int steps = 200;
        for (int k = 0; k < steps && i < 399; ++k) {
            const double t = time[i] + (time[i + 1] - time[i]) * (k + 0.5) / steps;
            a -= contact::crack_speed::speed(0.055 * std::exp(t / 20.0), slow) * (time[i + 1] - time[i]) / steps;
        }
    }
    ASSERT_GT(a, 0.0);
    const CrackSpeedFit fit = fit_crack_speed(crack_speed_points(time, radius, rate));
    // parabolas over 9 samples, 2 % of the time in which speeds rise 20-fold
    EXPECT_NEAR(fit.exponent.value, 0.6, 0.01);
    EXPECT_NEAR(fit.threshold.value / 0.05, 1.0, 0.02);
}

}  // namespace
}  // namespace setae::loops::crack_speed_fit_test
