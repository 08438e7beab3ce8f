// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/hysteresis/speed_factor.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "setae/contact/jkr.hpp"
#include "setae/core/constants.hpp"
#include "setae/hysteresis/retraction_pair.hpp"

namespace setae::hysteresis::speed_factor_test {
namespace {

TracedValue known(double value, double error, const char* name) {
    return {Estimate{.value = value, .standard_error = error}, name};
}

constexpr double radius = 1.25e-3, modulus = 0.92e6, largest = 1.2e-4;
const EdgePull pull{.motor_speed = 60e-9, .reading_time = 3.0};

TracedSphere sphere() { return {.radius = radius, .contact_modulus = modulus, .contact_radius = largest}; }
TracedEdgeSpeed edge() { return {known(1e-6, 0.05e-6, "v0"), known(0.6, 0.02, "n"), known(1.05, 0.01, "rest")}; }

/// φ of an edge from `largest` without the module: the edge_retraction itself.
double factor(double work, double speed, double exponent, double rest) {
    const HystereticSphere body{radius, modulus, 1e-9 * work, rest * work};
    const Pressing pressing{.maximum_force = contact::jkr::force(largest, body.approach())};
    return edge_retraction(body, pressing, {{speed, exponent}, pull.motor_speed, pull.reading_time}).work_read / work;
}

TEST(SpeedFactor, EqualsTheRatioForTheEdgeWithDerivatives) {
    const auto found = speed_factor(sphere(), edge(), pull, 0.05);
    EXPECT_NEAR(found.factor.value / factor(0.05, 1e-6, 0.6, 1.05), 1.0, 1e-12);
    const double by_speed = 0.5 * (factor(0.05, 1.05e-6, 0.6, 1.05) - factor(0.05, 0.95e-6, 0.6, 1.05)),
                 by_rest = 0.5 * (factor(0.05, 1e-6, 0.6, 1.06) - factor(0.05, 1e-6, 0.6, 1.04));
    EXPECT_NEAR(found.factor.components.at("v0").directions[0] / by_speed, 1.0, 1e-6);
    EXPECT_NEAR(found.factor.components.at("rest").directions[0] / by_rest, 1.0, 1e-6);
    EXPECT_LT(by_speed, 0.0) << "a larger v0 minds speed less";
}

TEST(SpeedFactor, ExtrapolatesAsAPowerOfTheWork) {
    const auto found = speed_factor(sphere(), edge(), pull, 0.05);
    EXPECT_LT(found.slope, 0.0);
    for (const double work : {0.025, 0.04, 0.08, 0.12})
        EXPECT_NEAR(found.at(found.factor.value, work) / factor(work, 1e-6, 0.6, 1.05), 1.0, 4e-3) << work;
}

TEST(SpeedFactor, OfAnApparentWorkRecoversTheWorkAtRest) {
    const double work = 0.07, read = work * factor(work, 1e-6, 0.6, 1.05);
    const auto found = speed_factor_of_reading(sphere(), edge(), pull, read);
    EXPECT_NEAR(found.work / work, 1.0, 1e-7);
    EXPECT_NEAR(found.factor.value * found.work / read, 1.0, 1e-7);
    // with another law the same reading stands for another work
    const double other = 1.03e-6;
    const auto moved =
        speed_factor_of_reading(sphere(), {.reference_speed = other, .exponent = 0.6, .rest_factor = 1.05}, pull, read);
    EXPECT_NEAR((found.at_reading(factor(found.work, other, 0.6, 1.05)) - found.factor.value) /
                    (moved.factor.value - found.factor.value),
                1.0, 0.02);
}

/// A pair on a surface that stores 0.9 mJ/m², in full contact, whose edge is known.
RetractionPair known_pair() {
    static const roughness::ParameterSpread none;
    static const auto parameters = [] {
        roughness::SpectralParameters of;
        of.rms_slope = 1.0;
        of.elastic_energy_per_modulus = 1e-9;
        return of;
    }();
    RetractionPair pair{.rough = {"S", parameters, none}, .soft = {"E", modulus, 0.025}, .work_of_adhesion = 0.037};
    pair.radius = TracedValue(radius);
    pair.contact_area = TracedValue(pi * largest * largest);
    pair.edge_speed = edge();
    pair.drive = Drive{.approach_speed = 60e-9, .retraction_speed = 60e-9};
    return pair;
}

TEST(RetractionPair, AtSpeedUsesTheRateOfItsOwnEdge) {
    auto pair = known_pair();
    pair.speed_factor = speed_factor(sphere(), edge(), pull, 0.06);
    const FittedModel opening{.model = {Law::opening_work, Tip::speed}, .parameter = 0.06, .scatter = {}};
    const double work = 0.06 * pair.rough.parameters.area_ratio();
    const auto loop = predicted_retraction_loop(opening, pair);
    ASSERT_TRUE(loop);
    EXPECT_NEAR(loop->work_retraction.value / (work * factor(work, 1e-6, 0.6, 1.05)), 1.0, 3e-3);
    // ∫ G dA less W_app π a², the jump in beside it
    ASSERT_TRUE(loop->edge);
    const auto receding = edge_retraction(loop->sphere, loop->pressing, *loop->edge);
    const double area = pi * largest * largest;
    EXPECT_NEAR((loop->energy_loss.value - loop->shares.jump_in.value) /
                    (receding.edge_work - loop->work_approach.value * area),
                1.0, 1e-9);
    EXPECT_GT(loop->shares.crack_tip.value, 0.2 * loop->energy_loss.value);
    double sum = 0.0;
    for (const auto& [name, share] : EnergyShares::all()) sum += (loop->shares.*share).value;
    EXPECT_NEAR(sum / loop->energy_loss.value, 1.0, 1e-12);
}

TEST(RetractionPair, WithARelaxingBulkAddsTheBulkLoss) {
    auto pair = known_pair();
    const FittedModel opening{.model = {Law::opening_work, Tip::none}, .parameter = 0.06, .scatter = {}};
    const auto elastic = predicted_retraction_loop(opening, pair);
    pair.relaxation = {{known(0.1, 0.02, "g"), known(20.0, 2.0, "tau")}};
    const auto relaxing = predicted_retraction_loop(opening, pair);
    ASSERT_TRUE(elastic && relaxing);
    const auto& bulk = relaxing->shares.bulk;
    EXPECT_GT(bulk.value, 0.0);
    EXPECT_NEAR(relaxing->energy_loss.value, elastic->energy_loss.value + bulk.value, 1e-20);
    EXPECT_NEAR(bulk.components.at("g").directions[0] / (0.2 * bulk.value), 1.0, 0.1) << "nearly in proportion to g";
    pair.drive.reset();
    EXPECT_EQ(predicted_retraction_loop(opening, pair)->shares.bulk.value, 0.0) << "nobody says how fast";
}

TEST(RetractionPair, NamesMissingInputOfARateDependentTip) {
    auto pair = known_pair();
    EXPECT_NE(pair.lacks({Law::reversible, Tip::speed}).find("machine speed"), std::string::npos);
    pair.edge_speed.reset();
    EXPECT_NE(pair.lacks({Law::reversible, Tip::speed}).find("no speed dependence of the contact edge on E"),
              std::string::npos);
}

}  // namespace
}  // namespace setae::hysteresis::speed_factor_test
