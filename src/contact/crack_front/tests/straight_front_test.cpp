// SPDX-License-Identifier: GPL-3.0-or-later
#include "straight_front.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/numerics/random_numbers.hpp"

namespace straight_front_test {

using namespace setae;
using namespace setae::crack_front;

WorkField noise(Index lines, Index points, double rms) {
    WorkField field{.works = Array2D(lines, points), .points = {points, 0.0, 1.0}, .mean_work = 1.0};
    for (Index j = 0; j < lines; ++j)
        field.works.row(j) = (1.0 + rms * numerics::normal_numbers({0}, j * points, points)).transpose();
    return field;
}

TEST(StraightFront, WithoutPinningFollowsTheDrive) {
    StraightFront front(noise(16, 32, 0.0), {.width = 16.0});
    for (const double drive : {3.0, 7.5, -2.0}) {
        const auto state = front.drive_to(drive);
        EXPECT_NEAR(state.position, drive, 1e-8);
        EXPECT_NEAR(state.apparent_work, 1.0, 1e-8);
        EXPECT_LT(state.roughness, 1e-10);
    }
}

// w depends on z alone: W |q| x̃ = w̃, wave by wave, and a mean the spring holds
TEST(StraightFront, BendsByWorkAmplitudeOverWavevector) {
    const double width = 40.0, q = 2.0 * pi * 3.0 / width, restoring = 0.05, share = 0.1;
    WorkField field{.works = Array2D(64, 8), .points = {8, 0.0, 1.0}, .mean_work = 2.0};
    for (Index j = 0; j < 64; ++j)
        field.works.row(j).setConstant(2.0 * (1.0 + share * std::cos(q * width * static_cast<double>(j) / 64.0)));
    StraightFront front(field, {.width = width, .restoring = restoring});
    front.drive_to(5.0);
    for (Index j = 0; j < 64; ++j)
        EXPECT_NEAR(front.front()[j],
                    5.0 + share / (q + restoring) * std::cos(q * width * static_cast<double>(j) / 64.0), 1e-7);
}

// 256 points, independent normal works, a spring of wavelength L/16: hysteresis, the same by both methods
TEST(StraightFront, BothMethodsAgreeForwardAndBack) {
    const auto field = noise(256, 256, 1.0);
    const StraightFrontOptions options{.width = 256.0, .restoring = 2.0 * pi / 16.0, .tolerance = 1e-10};
    auto slow = options, one_way = options;
    slow.largest_move = 0.01;
    one_way.method = EquilibriumMethod::rosso_krauth;
    StraightFront one(field, slow), other(field, one_way);
    std::vector<double> there;
    for (int k = 0; k <= 60; ++k) {
        const double drive = k <= 30 ? k / 3.0 : (60 - k) / 3.0;
        const auto state = one.drive_to(drive), expected = other.drive_to(drive);
        ASSERT_TRUE(state.converged && expected.converged) << k;
        // both leave the straight line each in its own way, and meet once every point has moved
        if (k > 6) {
            EXPECT_NEAR(state.apparent_work, expected.apparent_work, 1e-8) << k;
        }
        if (k <= 30) there.push_back(state.apparent_work);
        if (k > 36 && k < 54) {
            EXPECT_GT(state.apparent_work, there[static_cast<std::size_t>(60 - k)]) << k;
        }
    }
}

// no passing: where the front goes does not depend on the steps
TEST(StraightFront, OneWayMotionDoesNotDependOnSteps) {
    const auto field = noise(64, 64, 0.8);
    const StraightFrontOptions options{
        .width = 64.0, .restoring = 0.2, .method = EquilibriumMethod::rosso_krauth, .tolerance = 1e-10};
    StraightFront one(field, options), many(field, options);
    one.drive_to(0.0);
    many.drive_to(0.0);
    for (int k = 1; k <= 40; ++k) many.drive_to(0.25 * k);
    one.drive_to(10.0);
    EXPECT_LT((one.front() - many.front()).abs().maxCoeff(), 1e-8);
}

TEST(StraightFront, RequiresAWidth) {
    EXPECT_THROW(StraightFront(noise(4, 4, 0.0), {}), InvalidArgument);
    EXPECT_THROW((void)straight_front_works(noise(4, 4, 0.0), {.width = 4.0}, 0.0), InvalidArgument);
}

}  // namespace straight_front_test
