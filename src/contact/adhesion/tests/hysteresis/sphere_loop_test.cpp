// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/hysteresis/sphere_loop.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/hysteresis/loop_course.hpp"

namespace setae::hysteresis {
namespace {

constexpr HystereticSphere smooth{
    .radius = 1.25e-3, .contact_modulus = 0.92e6, .work_approach = 0.04, .work_retraction = 0.04};

/// ∮ F dδ by trapezoids.
double area_of(const Table& course) {
    const auto &x = course.at("displacement"), &force = course.at("force");
    double area = 0.0;
    for (Index i = 1; i < x.size(); ++i) area += 0.5 * (force[i] + force[i - 1]) * (x[i] - x[i - 1]);
    return area;
}

TEST(SphereLoop, OfASmoothSphereUnderFixedGripsHasMaugisLoss) {
    const auto loop = sphere_loop(smooth, {.maximum_force = 1e-3});
    EXPECT_EQ(loop.edge_loss, 0.0);
    const auto units = contact::jkr::maugis_units(smooth.approach());
    EXPECT_NEAR(loop.energy_loss() / units.energy, 1.2749410291, 1e-9);
}

TEST(SphereLoop, EdgeLossIsWorkDifferenceTimesLargestContactArea) {
    auto rough = smooth;
    rough.work_retraction = 0.12;
    const auto loop = sphere_loop(rough, {.maximum_force = 1e-3});
    EXPECT_DOUBLE_EQ(loop.edge_loss, 0.08 * loop.largest_contact_area());
    EXPECT_NEAR(loop.smallest_force, -1.5 * pi * rough.radius * 0.12, 1e-12);
}

TEST(SphereLoop, CourseEnclosesTheLoss) {
    auto rough = smooth;
    rough.work_retraction = 0.12;
    for (const double stiffness : {30.0, std::numeric_limits<double>::infinity()}) {
        const Pressing pressing{.maximum_force = 1e-3, .machine_stiffness = stiffness};
        const double loss = sphere_loop(rough, pressing).energy_loss();
        const double coarse = area_of(loop_course(rough, pressing, {}, 100)) / loss - 1.0;
        const double fine = area_of(loop_course(rough, pressing, {}, 400)) / loss - 1.0;
        EXPECT_LT(std::abs(fine), 2e-5) << stiffness;
        EXPECT_NEAR(coarse / fine, 16.0, 1.0) << "second order of the trapezoids";
    }
}

TEST(SphereLoop, WorkForALossGivesThatLoss) {
    for (const double stiffness : {50.0, std::numeric_limits<double>::infinity()})
        for (const double loss : {1.2e-9, 3e-9, 50e-9}) {
            const Pressing pressing{.maximum_force = 1e-3, .machine_stiffness = stiffness};
            auto rough = smooth;
            rough.work_retraction = work_retraction_for_loss(smooth, pressing, loss);
            EXPECT_NEAR(sphere_loop(rough, pressing).energy_loss() / loss, 1.0, 1e-12) << stiffness;
        }
    try {
        (void)work_retraction_for_loss(smooth, {.maximum_force = 1e-3}, 1e-12);
        FAIL();
    } catch (const InvalidArgument& error) {
        EXPECT_NE(std::string(error.what()).find("loses at least"), std::string::npos) << error.what();
    }
}

TEST(SphereLoop, RefusesInvalidInput) {
    auto repelled = smooth;
    repelled.work_retraction = 0.03;
    EXPECT_THROW((void)sphere_loop(repelled, {.maximum_force = 1e-3}), InvalidArgument);
    EXPECT_THROW((void)sphere_loop(smooth, {.maximum_force = -1.0}), InvalidArgument);
    EXPECT_THROW((void)sphere_loop(smooth, {.maximum_force = 1e-3, .machine_stiffness = 0.0}), InvalidArgument);
    EXPECT_THROW((void)loop_course(smooth, {.maximum_force = 1e-3}, {}, 2), InvalidArgument);
}

}  // namespace
}  // namespace setae::hysteresis
