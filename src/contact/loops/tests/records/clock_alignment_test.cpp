// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/loops/clock_alignment.hpp"

#include <gtest/gtest.h>

#include "pulls.hpp"
#include "setae/core/errors.hpp"
#include "synthetic_loop.hpp"

namespace setae::loops::tests::clock_alignment_test {
namespace {

/// Frames every `step` seconds of a camera that began `offset` before the time it thinks it is: t_force = t_camera +
/// offset.
CameraRecord filmed(const Loop& loop, double step, double offset) {
    std::vector<double> times, radii;
    Index at = 0;
    for (double t = loop.time[0] + 0.37 * step; t < loop.time[loop.time.size() - 1]; t += step) {
        while (loop.time[at] < t) ++at;
        times.push_back(t - offset);
        radii.push_back(loop.contact_radius[at - 1]);
    }
    return {detail::Series::array(times), detail::Series::array(radii)};
}

Loop without_radius(Loop loop) {
    loop.contact_radius = Array1D();
    return loop;
}

SyntheticLoop with_hysteresis() { return {.retraction_work = 0.120, .samples = 1500}; }

TEST(ClockAlignment, RecoversTrueOffsetsToHalfAFrame) {
    const auto loop = with_hysteresis().make();
    const double frame = 40 * (loop.time[1] - loop.time[0]);
    for (const double frames : {0.0, 0.31, -0.77, 12.4, -40.15, 55.5}) {
        const auto found = align_clocks(without_radius(loop), filmed(loop, frame, frames * frame));
        EXPECT_NEAR(found.offset.value, frames * frame, 0.5 * frame) << frames;
        EXPECT_EQ(found.doubt, "") << frames;
        ASSERT_TRUE(found.by_onset) << frames;
        EXPECT_NEAR(found.by_onset->value, frames * frame, 0.6 * frame) << frames;
    }
}

TEST(ClockAlignment, WithNoiseHasACorrectStandardError) {
    const auto loop = with_hysteresis().make();
    const double frame = 40 * (loop.time[1] - loop.time[0]);
    const double force_noise = 0.02 * loop.force.maxCoeff(), radius_noise = 0.01 * loop.contact_radius.maxCoeff();
    int covered = 0;
    setae::tests::Pulls pulls;
    constexpr int seeds = 20;
    for (int seed = 0; seed < seeds; ++seed) {
        std::mt19937_64 generator(static_cast<unsigned>(seed));
        const double offset = (7.0 + 0.31 * seed) * frame;
        auto noisy = without_radius(loop);
        noisy.force = with_noise(loop.force, force_noise, generator);
        auto camera = filmed(loop, (1.0 + 0.003 * seed) * frame, offset);
        camera.contact_radius = with_noise(camera.contact_radius, radius_noise, generator);
        camera.contact_radius[40] = std::nan("");
        const auto found = align_clocks(noisy, camera);
        EXPECT_NEAR(found.offset.value, offset, 0.5 * frame) << seed;
        covered += std::abs(found.offset.value - offset) < 3.0 * found.offset.standard_error ? 1 : 0;
        pulls.add(found.offset, offset);
    }
    expect_honest(pulls);
    EXPECT_GE(covered, 19);  // 3 standard errors: 1 in 370 misses
}

TEST(ClockAlignment, WorksWithoutDisplacement) {
    for (const double work : {0.040, 0.120}) {
        const auto loop = SyntheticLoop{.retraction_work = work, .samples = 1500}.make();
        const double frame = 40 * (loop.time[1] - loop.time[0]);
        auto force = without_radius(loop);
        force.displacement = Array1D();
        const auto found = align_clocks(force, filmed(loop, frame, 9.6 * frame));
        EXPECT_EQ(found.method, "F, a");
        EXPECT_NEAR(found.offset.value, 9.6 * frame, 0.5 * frame) << work;
    }
}

TEST(ClockAlignment, WarnsIfNoiseHidesTheJumpOfTheForce) {
    auto loop = with_hysteresis().make();
    const double frame = 40 * (loop.time[1] - loop.time[0]);
    const auto camera = filmed(loop, frame, 3.0 * frame);
    std::mt19937_64 generator(5);
    loop.force = with_noise(loop.force, 0.2 * loop.force.maxCoeff(), generator);
    loop.displacement = Array1D();
    const auto found = align_clocks(without_radius(loop), camera);
    EXPECT_FALSE(found.by_onset);
    EXPECT_NE(found.doubt, "");
}

TEST(ClockAlignment, WarnsOfUnrelatedRecords) {
    const auto loop = with_hysteresis().make();
    const double frame = 40 * (loop.time[1] - loop.time[0]);
    std::mt19937_64 generator(3);
    auto camera = filmed(loop, frame, 0.0);
    camera.contact_radius = with_noise(Array1D::Constant(camera.time.size(), 1e-4), 3e-5, generator);
    EXPECT_NE(align_clocks(without_radius(loop), camera).doubt, "");
}

TEST(ClockAlignment, RefusesRecordsThatCannotBeAligned) {
    const auto loop = with_hysteresis().make();
    const double frame = 40 * (loop.time[1] - loop.time[0]);
    const auto camera = filmed(loop, frame, 0.0);
    auto backwards = camera;
    std::swap(backwards.time[3], backwards.time[4]);
    EXPECT_THROW((void)align_clocks(loop, backwards), InvalidArgument);
    auto shorter = camera;
    shorter.time.conservativeResize(5);
    EXPECT_THROW((void)align_clocks(loop, shorter), InvalidArgument);
    auto constant = camera;
    constant.contact_radius.setConstant(1e-4);
    EXPECT_THROW((void)align_clocks(loop, constant), UndefinedDataError);
    auto blind = camera;
    blind.contact_radius.setConstant(std::nan(""));
    EXPECT_THROW((void)align_clocks(loop, blind), UndefinedDataError);
    EXPECT_THROW((void)align_clocks(loop, camera, {.smallest_offset = 1.0, .largest_offset = 0.0}), InvalidArgument);
}

}  // namespace
}  // namespace setae::loops::tests::clock_alignment_test
