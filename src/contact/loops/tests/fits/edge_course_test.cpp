// SPDX-License-Identifier: GPL-3.0-or-later
#include "fits/edge_course.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "setae/contact/jkr.hpp"

namespace setae::loops::edge_course_test {
namespace {

constexpr double sphere_radius = 1.25e-3;
constexpr EdgeParameters rubber{.first_radius = 1.3e-4,
                                .contact_modulus = 0.92e6,
                                .law = {.threshold = 0.04, .reference_speed = 3e-7, .exponent = 0.6}};

RetractingEdge released() {
    return {.time = Array1D::LinSpaced(120, 0.0, 120.0), .force = Array1D::LinSpaced(120, 8e-4, -1e-4)};
}

TEST(EdgeCourse, DerivativesMatchDifferences) {
    const EdgeCourse course = edge_course(released(), sphere_radius, rubber);
    constexpr double h = 1e-5;
    for (int p = 0; p < EdgeCourse::parameters; ++p) {
        const auto moved = [&](double by) {
            EdgeParameters at = rubber;
            const std::array<double*, EdgeCourse::parameters> members{
                &at.first_radius, &at.contact_modulus, &at.law.threshold, &at.law.reference_speed, &at.law.exponent};
            *members[static_cast<std::size_t>(p)] *= std::exp(by);
            return edge_course(released(), sphere_radius, at).contact_radius;
        };
        const Array1D difference = (moved(h) - moved(-h)) / (2.0 * h);
        const double scale = difference.abs().maxCoeff();
        EXPECT_LT((course.by_logarithm.col(p).array() - difference).abs().maxCoeff() / scale, 1e-6) << p;
    }
}

TEST(EdgeCourse, RestsBelowTheThresholdAndRecedesByTheCrackSpeedLaw) {
    RetractingEdge pressed = released();
    pressed.force.setConstant(8e-4);
    EdgeParameters strong = rubber;
    strong.law.threshold = 10.0;
    const EdgeCourse still = edge_course(pressed, sphere_radius, strong);
    EXPECT_EQ(still.contact_radius.minCoeff(), rubber.first_radius);
    EXPECT_EQ(still.speed.maxCoeff(), 0.0);

    const EdgeCourse course = edge_course(released(), sphere_radius, rubber);
    const RetractingEdge edge = released();
    for (const Index i : {60, 110}) {
        const double a = course.contact_radius[i], E = rubber.contact_modulus;
        const double hertz = 4.0 * E * a * a * a / (3.0 * sphere_radius) - edge.force[i];
        const double G = hertz * hertz / (8.0 * 3.141592653589793 * E * a * a * a);
        const double law = G > 0.04 ? 3e-7 * std::pow(G / 0.04 - 1.0, 1.0 / 0.6) : 0.0;
        EXPECT_NEAR(course.speed[i] / law, 1.0, 1e-12);
        const double slope =
            (course.contact_radius[i - 1] - course.contact_radius[i + 1]) / (edge.time[i + 1] - edge.time[i - 1]);
        EXPECT_NEAR(slope / law, 1.0, 2e-3);
    }
}

TEST(EdgeCourse, EndsWhereTheEdgeIsUnstable) {
    RetractingEdge pulled = released();
    pulled.force = Array1D::LinSpaced(120, 8e-4, -3e-3);
    const EdgeCourse course = edge_course(pulled, sphere_radius, rubber);
    EXPECT_TRUE(std::isfinite(course.contact_radius[30]));
    EXPECT_TRUE(std::isnan(course.contact_radius[119]));
}

}  // namespace
}  // namespace setae::loops::edge_course_test
