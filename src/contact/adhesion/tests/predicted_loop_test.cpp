// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/adhesion/predicted_loop.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "setae/adhesion/partial_contact.hpp"
#include "setae/contact/jkr.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::adhesion::predicted_loop_test {
namespace {

constexpr double radius = 1.25e-3;
const Press press{.radius = radius, .preload = 1e-3};
constexpr double W_int = 0.037, gamma_1 = 0.025, modulus = 0.9e6;

/// A rough side without errors.
struct Side {
    roughness::SpectralParameters parameters{.rms_slope = 0.35, .elastic_energy_per_modulus = 1e-10};
    roughness::ParameterSpread spread{};
    [[nodiscard]] RoughSide rough() const { return {"A", parameters, spread}; }
};

SoftSide soft(double error = 0.0) {
    return {"soft", {{.value = modulus, .standard_error = error}, "modulus"}, gamma_1};
}

TEST(PredictedLoop, MatchesTheTrueAreaLoss) {
    const Side side;
    const auto loop = predict_loop(side.rough(), soft(), W_int, press);
    ASSERT_TRUE(loop);
    const double r = side.parameters.area_ratio(),
                 W_app = W_int * r - gamma_1 * (r - 1.0) - modulus * side.parameters.elastic_energy_per_modulus;
    // (1) in closed form
    const double pull = 3.0 * pi * radius * W_app,
                 a = std::cbrt(0.75 * radius / modulus *
                               (press.preload + pull + std::sqrt(2.0 * pull * press.preload + pull * pull)));
    EXPECT_NEAR(loop->contact_radius.value, a, 1e-12 * a);
    const auto& conformal = loop->conformal_loss;
    EXPECT_NEAR(conformal.energy_loss.value, W_int * r * pi * a * a, 1e-12 * conformal.energy_loss.value);
    // the edge and both jumps lose as much together
    const double W_ret = conformal.work_retraction.value;
    const auto jumps = [&](double work) { return contact::jkr::ideal_loop_loss({radius, modulus, work}); };
    EXPECT_NEAR((W_ret - W_app) * pi * a * a + jumps(W_app).jump_in + jumps(W_ret).jump_out,
                conformal.energy_loss.value, 1e-10 * conformal.energy_loss.value);
    EXPECT_NEAR(conformal.pull_off_force.value, 1.5 * pi * radius * W_ret, 1e-15);
    EXPECT_GT(W_ret, W_app);
    EXPECT_NEAR(loop->reversible.work_retraction.value, W_app, 1e-15);
    EXPECT_NEAR(loop->reversible.pull_off_force.value, 1.5 * pi * radius * W_app, 1e-15);
    EXPECT_NEAR(loop->reversible.energy_loss.value, jumps(W_app).total, 1e-20);
}

// JKR in closed form: F = 3/2 πRW, E = 1.2749410291 πWR (π²W²R/E*²)^(1/3) (9/16)^(1/3)
TEST(PredictedLoop, TendsToJkrAsRoughnessTendsToZero) {
    const double force = 1.5 * pi * radius * W_int,
                 loss = 1.2749410291 * pi * W_int * radius *
                        std::cbrt(9.0 / 16.0 * pi * pi * W_int * W_int * radius / (modulus * modulus));
    double previous = 50.0;
    for (const double h : {1e-7, 1e-8, 1e-9, 1e-10}) {  // of one shape, so that r − 1 falls as h² and U_el as h²
        const double slope = h / 1e-7 * 0.35;
        const Side side{.parameters = {.rms_slope = slope, .elastic_energy_per_modulus = 1e-8 * std::pow(h / 1e-7, 2)}};
        const auto loop = predict_loop(side.rough(), soft(), W_int, press);
        ASSERT_TRUE(loop);
        const double off = std::abs(loop->reversible.pull_off_force.value / force - 1.0);
        EXPECT_LT(off, 0.02 * previous) << h;
        previous = off;
        EXPECT_NEAR(loop->reversible.smooth_pull_off_force, force, 1e-12 * force);
    }
    const Side mirror{.parameters = {.rms_slope = 1e-6}};
    const auto smooth = predict_loop(mirror.rough(), soft(), W_int, press);
    ASSERT_TRUE(smooth);
    EXPECT_NEAR(smooth->reversible.pull_off_force.value, force, 1e-9 * force);
    EXPECT_NEAR(smooth->reversible.energy_loss.value, loss, 1e-9 * loss);
}

// by (10) a smooth sphere loses W_int πa², a³ = 9πR²W/(2E*) without preload, and JKR's far less
TEST(PredictedLoop, ByTrueAreaLossHasNoSmoothLimit) {
    const Side smooth{.parameters = {.rms_slope = 1e-5}};
    const auto loop = predict_loop(smooth.rough(), soft(), W_int, {.radius = radius, .preload = 0.0});
    ASSERT_TRUE(loop);
    const double a = std::cbrt(4.5 * pi * radius * radius * W_int / modulus), force = 1.5 * pi * radius * W_int;
    EXPECT_NEAR(loop->contact_radius.value, a, 1e-6 * a);
    EXPECT_NEAR(loop->conformal_loss.energy_loss.value, W_int * pi * a * a, 1e-6 * W_int * pi * a * a);
    EXPECT_NEAR(loop->conformal_loss.pull_off_force.value, loop->conformal_loss.smooth_pull_off_force, 1e-6 * force);
    EXPECT_GT(loop->conformal_loss.smooth_pull_off_force, 1.5 * force);
    EXPECT_LT(loop->reversible.energy_loss.value, 0.7 * loop->conformal_loss.energy_loss.value);
}

TEST(PredictedLoop, PropagatesErrorsOfItsInputs) {
    const Side side;
    const TracedValue work({.value = W_int, .standard_error = 1e-3}, "work");
    const auto both = predict_loop(side.rough(), soft(0.02e6), work, press),
               one = predict_loop(side.rough(), soft(), work, press);
    ASSERT_TRUE(both && one);
    // dF/dW_int = 3/2 π R r at fixed modulus
    EXPECT_NEAR(one->reversible.pull_off_force.standard_error, 1.5 * pi * radius * side.parameters.area_ratio() * 1e-3,
                1e-12);
    EXPECT_GT(both->contact_radius.standard_error, one->contact_radius.standard_error);
    Side scattered;
    scattered.spread.replicas = {{.rms_slope = 0.34, .elastic_energy_per_modulus = 1e-10},
                                 {.rms_slope = 0.36, .elastic_energy_per_modulus = 1e-10}};
    const auto known = predict_loop(scattered.rough(), soft(), work, press);
    EXPECT_GT(known->conformal_loss.energy_loss.standard_error(), one->conformal_loss.energy_loss.standard_error());
}

// U_el/(A W) = 2.4: contact of next to no area, which holds next to nothing
TEST(PredictedLoop, OfPartialContactUsesTheWorkOfPartialContact) {
    const Side rough{.parameters = {.rms_slope = 0.35, .elastic_energy_per_modulus = 1e-7}};
    const auto loop = predict_loop(rough.rough(), soft(), W_int, press);
    ASSERT_TRUE(loop);
    const double work = partial_prediction(rough.rough(), soft(), W_int).value;
    EXPECT_GT(work, 0.0);
    EXPECT_LT(work, 0.02 * W_int);
    EXPECT_NEAR(loop->reversible.work_retraction.value, work, 1e-15);
}

TEST(PredictedLoop, IsEmptyWithoutContact) {
    const Side side;
    const SoftSide stiff_skin{"soft", modulus, 1.0};  // stretching costs more than W_int gains
    EXPECT_FALSE(predict_loop(side.rough(), stiff_skin, W_int, press));
    EXPECT_THROW((void)predict_loop(side.rough(), soft(), W_int, {.radius = 0.0, .preload = 1e-3}), InvalidArgument);
    EXPECT_THROW((void)predict_loop(side.rough(), soft(), W_int, {.radius = 1e-3, .preload = -1e-3}), InvalidArgument);
}

}  // namespace
}  // namespace setae::adhesion::predicted_loop_test
