// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/contact_line/contact_line.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "lines.hpp"
#include "setae/contact/jkr.hpp"
#include "setae/contact_line/local_release_rate.hpp"
#include "setae/core/errors.hpp"

namespace setae::contact_line::contact_line_test {
namespace {

const Array1D once = Array1D::Zero(1);

TEST(LineShape, OfACircleMatchesTheCircle) {
    const auto shape = line_shape(line_of(once, 1024, [](double, double) { return 3.0; }));
    EXPECT_NEAR(shape.mean_radius[0], 3.0, 1e-14);
    EXPECT_NEAR(shape.area[0], 9.0 * pi, 1e-12);
    EXPECT_NEAR(shape.perimeter[0] / (6.0 * pi), 1.0 - std::pow(pi / 1024, 2) / 6.0, 1e-11);  // of a polygon
    EXPECT_NEAR(shape.deviation[0], 0.0, 1e-7);
}

// ½ ∫ (a + b cos 5θ)² dθ = π (a² + b²/2); a shifted centre and an ellipse are no deviation
TEST(LineShape, DeviationExcludesCentreAndEllipse) {
    const auto shape = line_shape(line_of(once, 64, [](double angle, double) {
        return 3.0 + 0.3 * std::cos(angle + 0.4) + 0.2 * std::sin(2.0 * angle) + 0.01 * std::cos(5.0 * angle);
    }));
    EXPECT_NEAR(shape.deviation[0], 0.01 / std::sqrt(2.0), 1e-12);
    EXPECT_NEAR(shape.area[0], pi * (9.0 + 0.5 * (0.09 + 0.04 + 0.0001)), 1e-12);
}

TEST(ContactLine, AtFewerAnglesKeepsResolvedModes) {
    const auto wavy = [](double angle, double) {
        return 3.0 + 0.2 * std::cos(angle) + 0.05 * std::sin(7.0 * angle) + 0.04 * std::cos(15.0 * angle);
    };
    const auto fine = line_of(once, 96, wavy), coarse = line_of(once, 32, wavy);
    const auto thinned = at_fewer_angles(fine, 32);
    EXPECT_LT((thinned.radius - coarse.radius).abs().maxCoeff(), 1e-14);
    EXPECT_LT((at_fewer_angles(fine, 96).radius - fine.radius).abs().maxCoeff(), 1e-14);
    // waves that they cannot hold are left out, not folded
    const auto finer =
        line_of(once, 96, [&](double angle, double t) { return wavy(angle, t) + 0.1 * std::cos(20.0 * angle); });
    EXPECT_LT((at_fewer_angles(finer, 32).radius - coarse.radius).abs().maxCoeff(), 1e-14);
    EXPECT_THROW((void)at_fewer_angles(fine, 97), InvalidArgument);
    EXPECT_THROW((void)at_fewer_angles(fine, 15), InvalidArgument);
}

TEST(ContactLine, AtOtherTimesIsInterpolated) {
    const Array1D times{{1.0, 2.0, 4.0}};
    const auto line = line_of(times, 16, [](double angle, double t) { return 5.0 + t * t + std::cos(angle); });
    const Array1D wanted{{1.0, 1.5, 3.0, 4.0}};
    const auto found = at_times(line, wanted);
    EXPECT_NEAR(found.radius(0, 0), 7.0, 1e-14);
    EXPECT_NEAR(found.radius(1, 0), 8.5, 1e-14);
    EXPECT_NEAR(found.radius(2, 0), 16.0, 1e-14);
    EXPECT_NEAR(found.radius(3, 0), 22.0, 1e-14);
    EXPECT_THROW((void)at_times(line, Array1D{{4.1}}), InvalidArgument);
}

TEST(ContactLine, WhenInvalidIsRefusedWithTheFrame) {
    auto line = line_of(Array1D::LinSpaced(3, 0.0, 2.0), 16, [](double, double) { return 1.0; });
    EXPECT_NO_THROW(require_valid(line));
    line.radius(1, 4) = std::nan("");
    try {
        require_valid(line);
        FAIL();
    } catch (const InvalidArgument& e) {
        EXPECT_NE(std::string(e.what()).find("frame 2"), std::string::npos) << e.what();
        EXPECT_NE(std::string(e.what()).find("angle 5 of 16"), std::string::npos) << e.what();
    }
    line.radius(1, 4) = 1.0;
    line.time[2] = 1.0;
    EXPECT_THROW(require_valid(line), InvalidArgument);
    line.time = Array1D::LinSpaced(2, 0.0, 1.0);
    EXPECT_THROW(require_valid(line), InvalidArgument);
    EXPECT_THROW(require_valid(line_of(once, 15, [](double, double) { return 1.0; })), InvalidArgument);
}

constexpr contact::SphereOnFlat sphere{1e-3, 1e6};
constexpr contact::AdhesiveContact sticky{1e-3, 1e6, 0.04};

TEST(LocalReleaseRate, OfACircleInEquilibriumEqualsTheWorkOfAdhesion) {
    const double a = 1e-4;
    const auto line = line_of(once, 32, [&](double, double) { return a; });
    const auto rate = local_release_rate(line, Array1D::Constant(1, contact::jkr::displacement(a, sticky)), sphere);
    EXPECT_NEAR(rate.minCoeff(), 0.04, 1e-15);
    EXPECT_NEAR(rate.maxCoeff(), 0.04, 1e-15);
}

// A line of mode n that a field w (1 + κ cos nθ) holds: G is the field. To first order of the amplitude ε:
// κ = ε (n + a G'/G), G' = ∂G_J/∂a at fixed δ
TEST(LocalReleaseRate, OfAWavyLineRecoversTheWorkField) {
    const double a = 1e-4, epsilon = 1e-6, delta = contact::jkr::displacement(a, sticky);
    const auto G = [&](double r) { return contact::jkr::energy_release_rate_at_displacement(r, delta, sphere); };
    const double stiffness = a * (G(a * 1.0001) - G(a * 0.9999)) / (0.0002 * a) / G(a);
    for (const int n : {1, 3, 16}) {
        const auto line =
            line_of(once, 64, [&](double angle, double) { return a * (1.0 + epsilon * std::cos(n * angle)); });
        const auto rate = local_release_rate(line, Array1D::Constant(1, delta), sphere);
        for (Index j = 0; j < 64; ++j) {
            const double field = epsilon * (n + stiffness) * std::cos(2.0 * pi * n * static_cast<double>(j) / 64);
            EXPECT_NEAR(rate(0, j) / 0.04 - 1.0, field, 1e-5 * epsilon * (n + std::abs(stiffness)));
        }
    }
}

TEST(LocalReleaseRate, ExcludesNoisyModes) {
    const double a = 1e-4;
    const auto line =
        line_of(once, 64, [&](double angle, double) { return a * (1.0 + 1e-6 * std::cos(20.0 * angle)); });
    const auto rate = local_release_rate(line, Array1D::Constant(1, contact::jkr::displacement(a, sticky)), sphere, 10);
    EXPECT_LT((rate / 0.04 - 1.0).abs().maxCoeff(), 1e-5);  // of G_J(r) alone, 20 times less
    EXPECT_THROW((void)local_release_rate(line, Array1D::Zero(2), sphere), InvalidArgument);
}

}  // namespace
}  // namespace setae::contact_line::contact_line_test
