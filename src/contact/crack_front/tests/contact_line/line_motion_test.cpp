// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/contact_line/line_motion.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "lines.hpp"
#include "setae/core/errors.hpp"

namespace setae::contact_line::line_motion_test {
namespace {

TEST(Passage, AtConstantSpeedHasThatSpeedEverywhere) {
    const auto line =
        line_of(Array1D::LinSpaced(41, 0.0, 4.0), 16, [](double, double time) { return 10.0 - 2.0 * time; });
    for (const double width : {0.1, 0.3, 1.0}) {
        const auto found = passage(line, Direction::receding, width);
        EXPECT_NEAR(found.mean_speed, 2.0, 1e-12);
        EXPECT_NEAR((relative_speeds(found) - 1.0).abs().maxCoeff(), 0.0, 1e-9);
        EXPECT_NEAR(found.ring[0], 10.0 - 0.5 * width, 1e-12);
    }
    EXPECT_NEAR(passage(line, Direction::receding).width, 0.2, 1e-12);  // what it moves between frames
    EXPECT_THROW((void)passage(line, Direction::advancing, 0.1), UndefinedDataError);
}

// speed 3 in rings beyond 8, then 1: cells on either side have theirs, the mean is distance over time
TEST(Passage, SpeedsOfRingsAreIndependent) {
    const auto line = line_of(Array1D::LinSpaced(3001, 0.0, 6.0), 16, [](double, double time) {
        return time < 2.0 / 3.0 ? 10.0 - 3.0 * time : 8.0 - (time - 2.0 / 3.0);
    });
    const auto found = passage(line, Direction::receding, 0.5);
    EXPECT_NEAR(found.speed(3, 1), 3.0, 1e-9);
    EXPECT_NEAR(found.speed(3, 7), 1.0, 1e-9);
    const double distance = 10.0 - line.radius.minCoeff(), rings = std::floor(distance / 0.5);
    EXPECT_NEAR(found.mean_speed, rings * 0.5 / (2.0 / 3.0 + rings * 0.5 - 2.0), 1e-9);
}

TEST(Passage, CountsForwardAndBackwardMotionOnce) {
    const auto still =
        line_of(Array1D::LinSpaced(201, 0.0, 20.0), 16, [](double, double time) { return 10.0 + 0.1 * time; });
    const auto restless = line_of(still.time, 16, [](double, double time) {
        return 10.0 + 0.1 * time + 0.04 * std::cos(pi * std::round(10.0 * time));
    });
    EXPECT_NEAR(passage(restless, Direction::advancing, 0.2).mean_speed, 0.1, 0.001);
    EXPECT_NEAR(passage(still, Direction::advancing, 0.2).mean_speed, 0.1, 1e-9);
}

TEST(Passage, RefusesInvalidOptions) {
    const auto line = line_of(Array1D::LinSpaced(3, 0.0, 1.0), 16, [](double, double time) { return 2.0 - time; });
    EXPECT_THROW((void)passage(line, Direction::receding, -1.0), InvalidArgument);
    EXPECT_THROW((void)passage(line, Direction::receding, 1e-9), InvalidArgument);
    EXPECT_THROW((void)passage(line_of(Array1D::Zero(1), 16, [](double, double) { return 1.0; }), Direction::receding),
                 InvalidArgument);
    EXPECT_THROW((void)passage(line_of(Array1D::LinSpaced(3, 0.0, 1.0), 16, [](double, double) { return 1.0; }),
                               Direction::receding),
                 UndefinedDataError);
}

/// 64 angles, 20 rings of 0.1 from 10 inwards at speed 1, but 100 in one field of cells and 0.01 in another.
Passage known_passage() {
    Passage p;
    p.width = 0.1;
    p.ring = 10.0 - 0.1 * Array1D::LinSpaced(20, 0.5, 19.5);
    p.speed = Array2D::Constant(64, 20, 1.0);
    p.mean_speed = 1.0;
    for (const Index j : {62, 63, 0, 1, 2})  // across the first angle
        for (Index k = 4; k < 8; ++k) p.speed(j, k) = 100.0;
    p.speed(20, 19) = p.speed(21, 18) = 100.0;  // touch at a corner alone
    for (Index j = 30; j < 40; ++j) p.speed(j, 3) = 0.01;
    return p;
}

TEST(Clusters, RecoverTrueClusters) {
    const auto jumps = clusters(known_passage(), ClusterKind::jumps);
    ASSERT_EQ(jumps.size(), 3u);
    const double step = 2.0 * pi / 64.0;
    EXPECT_EQ(jumps[0].cells, 20);
    EXPECT_NEAR(jumps[0].area, 5.0 * step * 0.5 * (9.6 * 9.6 - 9.2 * 9.2), 1e-12);
    EXPECT_NEAR(jumps[0].across, 0.4, 1e-12);
    EXPECT_NEAR(jumps[0].along, 5.0 * step * jumps[0].radius, 1e-12);
    EXPECT_NEAR(jumps[0].angle, 0.0, 1e-12);
    EXPECT_NEAR(jumps[0].radius, 9.4, 0.01);
    EXPECT_EQ(jumps[1].cells, 1);
    const auto arrests = clusters(known_passage(), ClusterKind::arrests);
    ASSERT_EQ(arrests.size(), 1u);
    EXPECT_EQ(arrests[0].cells, 10);
    EXPECT_NEAR(arrests[0].angle, std::remainder(34.5 * step, 2.0 * pi), 1e-12);
    EXPECT_TRUE(clusters(known_passage(), ClusterKind::jumps, 200.0).empty());
    EXPECT_THROW((void)clusters(known_passage(), ClusterKind::jumps, 1.0), InvalidArgument);
}

TEST(Clusters, AroundTheWholeLineAreOneCluster) {
    auto p = known_passage();
    p.speed.setConstant(1.0);
    p.speed.col(5).setConstant(50.0);
    const auto jumps = clusters(p, ClusterKind::jumps);
    ASSERT_EQ(jumps.size(), 1u);
    EXPECT_EQ(jumps[0].cells, 64);
    EXPECT_NEAR(jumps[0].along, 2.0 * pi * p.ring[5], 1e-9);
}

/// 1 + numbers below a knee of 1, a power law above it, half and half.
Array1D with_tail(Index count, double exponent, std::uint64_t seed) {
    Array1D values(count);
    for (Index i = 0; i < count; ++i) {
        const double u = numerics::uniform_number({seed}, static_cast<std::uint64_t>(i));
        values[i] = i % 2 == 0 ? u : std::pow(u, -1.0 / (exponent - 1.0));
    }
    return values;
}

TEST(PowerLawTail, RecoversTrueExponents) {
    for (const double exponent : {1.5, 2.55}) {
        double deviates = 0.0, mean = 0.0;
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            const auto tail = power_law_tail(with_tail(4000, exponent, seed));
            mean += tail.exponent.value / 20;
            deviates += std::pow((tail.exponent.value - exponent) / tail.exponent.standard_error, 2) / 20;
            EXPECT_LT(tail.distance, 1.36 / std::sqrt(static_cast<double>(tail.count)));
            EXPECT_GT(tail.smallest, 0.8);
        }
        EXPECT_NEAR(mean, exponent, 0.03 * exponent);
        EXPECT_LT(std::sqrt(deviates), 2.0);  // the choice of the start scatters, too
    }
}

TEST(PowerLawTail, OfTooFewOrEqualNumbersIsRefused) {
    EXPECT_THROW((void)power_law_tail(Array1D::LinSpaced(49, 1.0, 2.0)), UndefinedDataError);
    EXPECT_THROW((void)power_law_tail(Array1D::Constant(100, 3.0)), UndefinedDataError);
    EXPECT_THROW((void)power_law_tail(Array1D::Constant(100, -1.0)), UndefinedDataError);
    EXPECT_THROW((void)power_law_tail(Array1D::Constant(100, 3.0), 2), InvalidArgument);
}

}  // namespace
}  // namespace setae::contact_line::line_motion_test
