// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/adhesion/predicted_loop.hpp"

#include <cmath>

#include <gtest/gtest.h>

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

TEST(PredictedLoop, LosesWhatEquationTenSays) {
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
    EXPECT_NEAR(loop->energy_loss.value, W_int * r * pi * a * a, 1e-12 * loop->energy_loss.value);
    EXPECT_NEAR(loop->pull_off_force_reversible.value, 1.5 * pi * radius * W_app, 1e-15);
    // the edge and both jumps lose as much together
    const double W_ret = loop->work_retraction.value;
    const auto jumps = [&](double work) { return contact::jkr::ideal_loop_loss({radius, modulus, work}); };
    EXPECT_NEAR((W_ret - W_app) * pi * a * a + jumps(W_app).jump_in + jumps(W_ret).jump_out, loop->energy_loss.value,
                1e-10 * loop->energy_loss.value);
    EXPECT_NEAR(loop->ideal_loss.value, jumps(W_app).total, 1e-20);
    EXPECT_NEAR(loop->pull_off_force.value, 1.5 * pi * radius * W_ret, 1e-15);
    EXPECT_GT(W_ret, W_app);
    EXPECT_TRUE(std::isnan(loop->energy_loss.estimate().standard_error)) << "nothing is uncertain";
}

// A smooth surface without preload: E = πW a², a³ = 9πR²W/(2E*), of which both jumps lose less.
TEST(PredictedLoop, OfASmoothSurfaceStillPinsTheEdge) {
    const Side smooth{.parameters = {.rms_slope = 1e-5}};
    const auto loop = predict_loop(smooth.rough(), soft(), W_int, {.radius = 1.25e-3, .preload = 0.0});
    ASSERT_TRUE(loop);
    const double a = std::cbrt(4.5 * pi * 1.25e-3 * 1.25e-3 * W_int / modulus);
    EXPECT_NEAR(loop->contact_radius.value, a, 1e-6 * a);
    EXPECT_NEAR(loop->energy_loss.value, W_int * pi * a * a, 1e-6 * loop->energy_loss.value);
    EXPECT_GT(loop->work_retraction.value, W_int);
    EXPECT_LT(loop->ideal_loss.value, loop->energy_loss.value);
}

TEST(PredictedLoop, CarriesTheErrorsOfItsInputs) {
    const Side side;
    const TracedValue work({.value = W_int, .standard_error = 1e-3}, "work");
    const auto both = predict_loop(side.rough(), soft(0.02e6), work, press),
               one = predict_loop(side.rough(), soft(), work, press);
    ASSERT_TRUE(both && one);
    // dF/dW_int = 3/2 π R r at fixed modulus
    EXPECT_NEAR(one->pull_off_force_reversible.standard_error, 1.5 * pi * radius * side.parameters.area_ratio() * 1e-3,
                1e-12);
    EXPECT_GT(both->contact_radius.standard_error, one->contact_radius.standard_error);
    Side scattered;
    scattered.spread.replicas = {{.rms_slope = 0.34, .elastic_energy_per_modulus = 1e-10},
                                 {.rms_slope = 0.36, .elastic_energy_per_modulus = 1e-10}};
    const auto known = predict_loop(scattered.rough(), soft(), work, press);
    EXPECT_GT(known->energy_loss.standard_error(), one->energy_loss.standard_error());
}

TEST(PredictedLoop, IsNoneWhereSurfacesDoNotConform) {
    const Side rough{.parameters = {.rms_slope = 0.35, .elastic_energy_per_modulus = 1e-7}};
    EXPECT_FALSE(predict_loop(rough.rough(), soft(), W_int, press));
    const Side side;
    EXPECT_THROW((void)predict_loop(side.rough(), soft(), W_int, {.radius = 0.0, .preload = 1e-3}), InvalidArgument);
    EXPECT_THROW((void)predict_loop(side.rough(), soft(), W_int, {.radius = 1e-3, .preload = -1e-3}), InvalidArgument);
}

}  // namespace
}  // namespace setae::adhesion::predicted_loop_test
