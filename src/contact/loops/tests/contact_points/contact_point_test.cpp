// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/loops/contact_point.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "refusal.hpp"
#include "setae/contact/hertz.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/loops/analysis.hpp"
#include "synthetic_loop.hpp"

namespace setae::loops::contact_point_test {
namespace {

using tests::rubber_on_diamond;
using tests::SyntheticLoop;
using Mode = ContactPointChoice::Mode;

const SyntheticLoop smooth{.samples = 400, .even_in_displacement = true};
constexpr double origin = 3e-6;

Loop shifted(Loop loop) {
    loop.displacement += origin;
    return loop;
}

TEST(ContactPoints, OfAnIdealLoopAgree) {
    for (const bool radius_measured : {true, false}) {
        Loop loop = shifted(smooth.make());
        if (!radius_measured) loop.contact_radius = Array1D();
        const LoopAnalysis analysis = analyse(loop, rubber_on_diamond());
        ASSERT_TRUE(analysis.contact_points) << analysis.contact_points.reason;
        const ContactPoints& points = *analysis.contact_points;
        ASSERT_EQ(points.estimates.size(), 7u);
        for (const ContactPointMethod method :
             {ContactPointMethod::force_displacement, ContactPointMethod::zero_force}) {
            ASSERT_TRUE(points.of(method).contact_point) << contact_point_name(method);
            // the parabola through the zero of force is exact to third order
            EXPECT_NEAR(points.of(method).contact_point->value, origin, 2e-9) << contact_point_name(method);
        }
        for (const ContactPointMethod method :
             {ContactPointMethod::force_departure, ContactPointMethod::jump_in, ContactPointMethod::pull_off}) {
            // the jumps are sampled at their very ends, half a step of free flight, 16 nm, from its middle
            ASSERT_TRUE(points.of(method).contact_point)
                << contact_point_name(method) << points.of(method).contact_point.reason;
            EXPECT_NEAR(points.of(method).contact_point->value, origin, 8.1e-9) << contact_point_name(method);
        }
        EXPECT_FALSE(points.of(ContactPointMethod::broken_line).contact_point);
        EXPECT_NE(points.of(ContactPointMethod::broken_line).contact_point.reason.find("jumps into contact"),
                  std::string::npos);
        EXPECT_EQ(points.of(ContactPointMethod::pointwise).contact_point.value.has_value(), radius_measured);
        EXPECT_EQ(points.chosen, ContactPointMethod::force_displacement);
        EXPECT_LT(points.spread_share, 0.01);
    }
}

TEST(ContactPoints, OfHertzianContactFollowFromThePowerLaw) {
    // no adhesion on the way in: F = 4/3 E* √R d^(3/2) from the origin on
    std::mt19937_64 generator(5);
    constexpr Index n = 800;
    const contact::SphereOnFlat bodies{1.25e-3, 0.92e6};
    Loop loop;
    loop.displacement = Array1D::LinSpaced(2 * n, -8e-6, 8e-6);
    loop.force = loop.displacement.max(0.0).pow(1.5) * (4.0 / 3.0 * bodies.contact_modulus * std::sqrt(bodies.radius));
    loop.contact_radius = (loop.displacement.max(0.0) * bodies.radius).sqrt();
    loop.force = tests::with_noise(loop.force, 2e-3 * loop.force.maxCoeff(), generator);
    loop.displacement += origin;
    const LoopAnalysis analysis = analyse(loop, rubber_on_diamond());
    for (const ContactPointMethod method : {ContactPointMethod::force_departure, ContactPointMethod::broken_line}) {
        const auto& found = analysis.contact_points->of(method).contact_point;
        ASSERT_TRUE(found) << contact_point_name(method) << ": " << found.reason;
        EXPECT_NEAR(found->value, origin, 3.0 * found->standard_error) << contact_point_name(method);
        EXPECT_LT(found->standard_error, 0.02 * 8e-6) << contact_point_name(method);
    }
    EXPECT_FALSE(analysis.contact_points->of(ContactPointMethod::jump_in).contact_point);
}

TEST(ContactPoints, HaveTheSensitivityOfModulusAndWork) {
    const LoopAnalysis analysis = analyse(shifted(smooth.make()), rubber_on_diamond());
    const ContactPoints& points = *analysis.contact_points;
    constexpr double step = 2e-9;
    const auto held = [&](double value) {
        AnalysisOptions options;
        options.contact_point = {.mode = Mode::value, .value = value};
        return *analyse(shifted(smooth.make()), rubber_on_diamond(), options).loading.force_displacement;
    };
    const JkrFit above = held(points.contact_point.value + step), below = held(points.contact_point.value - step);
    EXPECT_NEAR(
        (above.work_of_adhesion.value - below.work_of_adhesion.value) / (2.0 * step) / points.work_by_contact_point,
        1.0, 0.01);
    EXPECT_NEAR(
        (above.contact_modulus.value - below.contact_modulus.value) / (2.0 * step) / points.modulus_by_contact_point,
        1.0, 0.01);
    EXPECT_NE(points.work_by_contact_point, 0.0);
}

TEST(ContactPointChoice, FixesTheValueInTheFits) {
    AnalysisOptions options;
    options.contact_point = {.mode = Mode::value, .value = origin};
    const LoopAnalysis analysis = analyse(shifted(smooth.make()), rubber_on_diamond(), options);
    const JkrFit& fit = *analysis.loading.force_displacement;
    EXPECT_EQ(fit.method, "force_displacement_held_contact_point");
    EXPECT_EQ(fit.contact_point.value, origin);
    EXPECT_EQ(fit.contact_point.standard_error, 0.0);
    EXPECT_NEAR(fit.contact_modulus.value / 0.92e6, 1.0, 1e-8);
    EXPECT_NEAR(fit.work_of_adhesion.value / 0.040, 1.0, 1e-8);
    EXPECT_EQ(analysis.contact_points->chosen, std::nullopt);
    EXPECT_NEAR(analysis.unloading->force_displacement->work_of_adhesion.value / 0.040, 1.0, 1e-8);
}

TEST(ContactPointChoice, OfAnEstimatorPropagatesItsError) {
    AnalysisOptions options;
    options.contact_point = {.mode = Mode::estimator, .estimator = ContactPointMethod::jump_in};
    const LoopAnalysis analysis = analyse(shifted(smooth.make()), rubber_on_diamond(), options);
    ASSERT_TRUE(analysis.contact_points) << analysis.contact_points.reason;
    const JkrFit& fit = *analysis.loading.force_displacement;
    const Estimate& point = analysis.contact_points->contact_point;
    EXPECT_EQ(analysis.contact_points->chosen, ContactPointMethod::jump_in);
    EXPECT_EQ(fit.contact_point.value, point.value);
    // noise-free: the error of W is that of the contact point times its slope
    EXPECT_NEAR(fit.work_of_adhesion.standard_error /
                    std::abs(point.standard_error * analysis.contact_points->work_by_contact_point),
                1.0, 0.1);
}

TEST(ContactPointChoice, WithoutResultGivesAWarningAndNoSubstitute) {
    AnalysisOptions options;
    options.contact_point = {.mode = Mode::estimator, .estimator = ContactPointMethod::broken_line};
    const LoopAnalysis analysis = analyse(smooth.make(), rubber_on_diamond(), options);
    EXPECT_FALSE(analysis.contact_points);
    EXPECT_NE(analysis.contact_points.reason.find("broken_line"), std::string::npos);
    EXPECT_EQ(analysis.loading.force_displacement->method, "force_displacement");
    bool found = false;
    for (const Alert& alert : analysis.alerts) found = found || alert.code == "CONTACT_POINT_UNKNOWN";
    EXPECT_TRUE(found);
}

TEST(ContactPointChoice, IsReadFromText) {
    EXPECT_EQ(parse_contact_point("auto"), ContactPointChoice{});
    EXPECT_EQ(parse_contact_point("fit").mode, Mode::fit);
    EXPECT_EQ(parse_contact_point("zero_force").estimator, ContactPointMethod::zero_force);
    EXPECT_DOUBLE_EQ(parse_contact_point("1.25 um").value, 1.25e-6);
    EXPECT_NE(tests::refusal_of<InvalidArgument>([] { (void)parse_contact_point("1.25"); }).find("zero_force"),
              std::string::npos);
}

TEST(FitWithContactPoint, RecoversModulusAndWorkOnAnyBranch) {
    const contact::jkr::Contact lens = smooth.approach;
    for (const double work : {0.0, 0.040, 2.0}) {
        contact::jkr::Contact sticky = lens;
        sticky.work_of_adhesion = work;
        const double least = work > 0.0 ? contact::jkr::pull_off_at_fixed_grips(sticky).contact_radius : 2e-5;
        const Array1D radii = Array1D::LinSpaced(200, 1.001 * least, 4.0 * least);
        BranchData data{.force = radii, .displacement = radii};
        for (Index i = 0; i < radii.size(); ++i) {
            data.force[i] = contact::jkr::force(radii[i], sticky);
            data.displacement[i] = contact::jkr::displacement(radii[i], sticky) + origin;
        }
        const JkrFit fit = fit_with_contact_point(data, rubber_on_diamond(), origin);
        EXPECT_TRUE(fit.converged);
        EXPECT_NEAR(fit.contact_modulus.value / 0.92e6, 1.0, 1e-8) << work;
        EXPECT_NEAR(fit.work_of_adhesion.value, work, 1e-8 * std::max(work, 0.01)) << work;
    }
}

TEST(FitWithContactPoint, RequiresAPenetration) {
    const BranchData data{.force = Array1D::LinSpaced(10, 0.0, 1.0), .displacement = Array1D::LinSpaced(10, 0.0, 1e-6)};
    EXPECT_THROW((void)fit_with_contact_point(data, rubber_on_diamond(), 2e-6), UndefinedDataError);
    EXPECT_THROW((void)fit_with_contact_point({.force = data.force}, rubber_on_diamond(), 0.0), UndefinedDataError);
}

}  // namespace
}  // namespace setae::loops::contact_point_test
