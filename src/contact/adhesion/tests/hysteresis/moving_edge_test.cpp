// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/hysteresis/moving_edge.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/hysteresis/loop_course.hpp"

namespace setae::hysteresis::moving_edge_test {
namespace {

constexpr double fixed_grips = std::numeric_limits<double>::infinity();
constexpr HystereticSphere sphere{
    .radius = 1.25e-3, .contact_modulus = 0.92e6, .work_approach = 0.04, .work_retraction = 0.06};
constexpr MovingEdge rubber{
    .law = {.reference_speed = 1e-6, .exponent = 0.6}, .motor_speed = 60e-9, .reading_time = 3.0};

/// The same edge by Runge and Kutta's method in time, under fixed grips.
EdgeRetraction by_time(const HystereticSphere& of, const Pressing& pressing, const MovingEdge& edge) {
    const auto loop = sphere_loop(of, pressing);
    const double R = of.radius, E = of.contact_modulus;
    const auto rate = [&](double a, double depth) {
        const double flat = a * a / R - depth;
        return E * flat * flat / (2.0 * pi * a);
    };
    const auto receding = [&](double a, double depth) {
        const double excess = rate(a, depth) / of.work_retraction - 1.0;
        return excess > 0.0 ? edge.law.reference_speed * std::pow(excess, 1.0 / edge.law.exponent) : 0.0;
    };
    double a = loop.turning_point.contact_radius, depth = loop.unpinned.displacement;
    const double gone = 1e-3 * a, step = 1e-3;
    EdgeRetraction result;
    while (a > gone) {
        // the edge runs at last: no more than a thousandth of the contact in a step
        const double h = std::min(step, 1e-3 * a / std::max(1e-12, receding(a, depth)));
        const double half = depth - 0.5 * h * edge.motor_speed, end = depth - h * edge.motor_speed;
        const double k1 = receding(a, depth), k2 = receding(a - 0.5 * h * k1, half),
                     k3 = receding(a - 0.5 * h * k2, half), k4 = receding(std::max(gone, a - h * k3), end);
        const double next = a - h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
        result.edge_work += 0.5 * (2.0 * pi * a * rate(a, depth) + 2.0 * pi * next * rate(next, end)) * (a - next);
        a = next;
        depth = end;
        result.smallest_force = std::min(result.smallest_force, 2.0 * a * E * (depth - a * a / (3.0 * R)));
    }
    result.edge_work += E * depth * depth * a;
    return result;
}

TEST(MovingEdge, MatchesIntegrationInTime) {
    const Pressing pressing{.maximum_force = 1e-3};
    for (const double speed : {0.3e-6, 1e-6, 10e-6}) {
        auto edge = rubber;
        edge.law.reference_speed = speed;
        const auto found = edge_retraction(sphere, pressing, edge), expected = by_time(sphere, pressing, edge);
        EXPECT_NEAR(found.smallest_force / expected.smallest_force, 1.0, 1e-4) << speed;
        EXPECT_NEAR(found.edge_work / expected.edge_work, 1.0, 1e-3) << speed;
        EXPECT_GT(found.work_read, sphere.work_retraction);
    }
}

TEST(MovingEdge, WithoutSpeedDependenceEqualsTheStaticEdge) {
    auto edge = rubber;
    edge.law.reference_speed = 1e6;
    for (const double stiffness : {60.0, fixed_grips}) {
        const Pressing pressing{.maximum_force = 1e-3, .machine_stiffness = stiffness};
        const auto resting = sphere_loop(sphere, pressing), moving = sphere_loop(sphere, pressing, edge);
        EXPECT_NEAR(moving.smallest_force / resting.smallest_force, 1.0, 1e-5) << stiffness;
        EXPECT_NEAR(moving.energy_loss() / resting.energy_loss(), 1.0, 5e-5) << stiffness;
        EXPECT_NEAR(edge_retraction(sphere, pressing, edge).work_read / sphere.work_retraction, 1.0, 5e-4);
    }
}

TEST(MovingEdge, CourseEnclosesTheEnergyLoss) {
    for (const double stiffness : {60.0, fixed_grips}) {
        const Pressing pressing{.maximum_force = 1e-3, .machine_stiffness = stiffness};
        const auto course = loop_course(sphere, pressing, rubber, 8000);
        const auto &depth = course.at("displacement"), &force = course.at("force");
        double area = 0.0;
        for (Index i = 1; i < depth.size(); ++i) area += 0.5 * (force[i] + force[i - 1]) * (depth[i] - depth[i - 1]);
        EXPECT_NEAR(area / sphere_loop(sphere, pressing, rubber).energy_loss(), 1.0, 5e-4) << stiffness;
    }
}

TEST(MovingEdge, WorkAtRestIsRecoveredFromTheApparentWork) {
    const Pressing pressing{.maximum_force = 1e-3, .machine_stiffness = 200.0};
    for (const auto reading : {Reading::last_points, Reading::smallest_force, Reading::loop_area}) {
        const double read = work_read(sphere, pressing, rubber, reading);
        EXPECT_NEAR(work_at_rest(sphere, pressing, rubber, reading, read) / sphere.work_retraction, 1.0, 1e-8);
        EXPECT_GT(read, 1.2 * sphere.work_retraction) << "the speed counts here";
    }
}

TEST(MovingEdge, ApparentWorkFromAreaIsThatOfAnEqualStaticLoop) {
    for (const double stiffness : {200.0, fixed_grips}) {
        const Pressing pressing{.maximum_force = 1e-3, .machine_stiffness = stiffness};
        auto resting = sphere;
        resting.work_retraction = work_read(sphere, pressing, rubber, Reading::loop_area);
        EXPECT_NEAR(sphere_loop(resting, pressing).energy_loss() / sphere_loop(sphere, pressing, rubber).energy_loss(),
                    1.0, 1e-10);
    }
}

TEST(MovingEdge, ApparentWorkFallsWithTheReadingTime) {
    const Pressing pressing{.maximum_force = 1e-3};
    double before = std::numeric_limits<double>::infinity();
    for (const double time : {0.0, 3.0, 10.0, 30.0}) {
        auto edge = rubber;
        edge.reading_time = time;
        const double read = edge_retraction(sphere, pressing, edge).work_read;
        EXPECT_LT(read, before) << "an edge that accelerates was slower before";
        before = read;
    }
}

TEST(MovingEdge, RefusesInvalidInput) {
    const auto refused = [](MovingEdge edge) {
        try {
            (void)edge_retraction(sphere, {.maximum_force = 1e-3}, edge);
        } catch (const InvalidArgument& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    auto edge = rubber;
    edge.law.reference_speed = 0.0;
    EXPECT_NE(refused(edge).find("v0 0 m/s"), std::string::npos);
    edge = rubber;
    edge.motor_speed = -1.0;
    EXPECT_NE(refused(edge).find("motor speed -1 m/s"), std::string::npos);
    EXPECT_THROW((void)work_at_rest(sphere, {.maximum_force = 1e-3}, rubber, Reading::last_points, -1.0),
                 InvalidArgument);
    EXPECT_THROW((void)edge_retraction_course(sphere, {.maximum_force = 1e-3}, rubber, 2), InvalidArgument);
}

}  // namespace
}  // namespace setae::hysteresis::moving_edge_test
