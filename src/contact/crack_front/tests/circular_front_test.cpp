// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/crack_front/circular_front.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "setae/contact/jkr.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/crack_front/stress_intensity.hpp"
#include "setae/numerics/random_numbers.hpp"
#include "setae/topography/measurement.hpp"

namespace circular_front_test {

using namespace setae;
using namespace setae::crack_front;

constexpr double W = 1.0 / pi;  // Maugis' units: R = 1, W = 1/π, E* = 3/4
constexpr contact::SphereOnFlat sphere{1.0, 0.75};
constexpr contact::AdhesiveContact jkr_contact{1.0, 0.75, W};

double jkr_radius(double displacement) {
    return contact::jkr::contact_radius_at_displacement(displacement, jkr_contact);
}

WorkField uniform(Index angles) {
    return work_of([](double, double) { return W; }, angles, {401, 0.0, 0.01}, W);
}

/// Displacements up to 1 and back to −0.9.
template <class Visit>
void there_and_back(double step, const Visit& visit) {
    for (double d = 0.001; d <= 1.0; d += step) visit(d);
    for (double d = 1.0; d >= -0.9; d -= step) visit(d);
}

class BothFrontMethods : public testing::TestWithParam<EquilibriumMethod> {};
INSTANTIATE_TEST_SUITE_P(CircularFront, BothFrontMethods,
                         testing::Values(EquilibriumMethod::rosso_krauth, EquilibriumMethod::trust_region),
                         [](const auto& method) {
                             return method.param == EquilibriumMethod::rosso_krauth ? "RossoKrauth" : "TrustRegion";
                         });

TEST_P(BothFrontMethods, GiveJkrCirclesForUniformWork) {
    CircularFront front(sphere, uniform(8), {.method = GetParam(), .tolerance = 1e-12});
    there_and_back(0.01, [&](double d) {
        ASSERT_TRUE(front.solve(HeldDisplacement{d}).converged) << d;
        EXPECT_LT((front.edge() - jkr_radius(d)).abs().maxCoeff(), 1e-10) << d;
    });
    EXPECT_FALSE(front.solve(HeldDisplacement{-0.92}).in_contact);
}

TEST_P(BothFrontMethods, GiveJkrForceAndEnergyUnderEveryControl) {
    CircularFront front(sphere, uniform(64), {.method = GetParam(), .tolerance = 1e-11});
    const auto agrees = [](const FrontState& state) {
        const double a = jkr_radius(state.displacement);
        EXPECT_NEAR(state.mean_radius, a, 1e-6 * a);
        EXPECT_NEAR(state.force, contact::jkr::force(a, jkr_contact), 1e-6);
        EXPECT_NEAR(state.energy(), contact::jkr::total_energy(a, state.displacement, jkr_contact), 1e-6);
        EXPECT_NEAR(state.perimeter, 2.0 * pi * a, 1e-6);
    };
    agrees(front.solve(HeldDisplacement{0.5}));
    const auto loaded = front.solve(DeadLoad{0.7});
    agrees(loaded);
    EXPECT_NEAR(loaded.force, 0.7, 1e-9);
    const auto staged = front.solve(Stage{1.4, 2.0});
    agrees(staged);
    EXPECT_NEAR(staged.force, 2.0 * (1.4 - staged.displacement), 1e-9);
}

// two equilibria, one from below and one from above, at every dip
TEST(CircularFront, BothMethodsAgreeOnAxisymmetricRings) {
    const auto field = work_of([](double r, double) { return W * (1.0 + 0.2 * std::sin(2.0 * pi * r / 0.1)); }, 64,
                               {401, 0.0, 0.0065}, W);
    CircularFront one(sphere, field), other(sphere, field, {.method = EquilibriumMethod::rosso_krauth});
    there_and_back(0.02, [&](double d) {
        const double expected = other.solve(HeldDisplacement{d}).force;
        EXPECT_NEAR(one.solve(HeldDisplacement{d}).force, expected, 1e-5 * std::abs(expected)) << d;
    });
}

/// White noise low-passed below λ = 0.08, rms 0.5 of the mean, on rays.
WorkField random_works(Index angles, double spacing, std::uint64_t seed) {
    constexpr double shortest = 0.08, largest = 1.95;
    constexpr Index n = 256;
    const double size = 5.12;
    topography::HeightMap map{Array2D(n, n), {size, size}, true, {}};
    for (Index i = 0; i < n; ++i) map.heights.row(i) = numerics::normal_numbers({seed}, i * n, n).transpose();
    auto field = works_on_rays({map.heights + 10.0, map.size, true, {}}, {1.0, shortest, {2.56, 2.56}}, angles,
                               {static_cast<Index>(largest / spacing) + 1, 0.0, spacing});
    const double rms = std::sqrt((field.works - field.mean_work).square().mean());
    field.works = W * (1.0 + 0.5 / rms * (field.works - field.mean_work));
    field.mean_work = W;
    return field;
}

TEST(CircularFront, BothMethodsAgreeInARandomField) {
    const auto field = random_works(512, 0.08 / 16.0, 0);
    CircularFront one(sphere, field, {.largest_move = 0.1});
    CircularFront other(sphere, field, {.method = EquilibriumMethod::rosso_krauth, .tolerance = 1e-8});
    for (const double d : {0.0, 0.02, 0.04, 0.02, 0.0, -0.02, -0.04}) {
        const double expected = other.solve(HeldDisplacement{d}).force;
        EXPECT_NEAR(one.solve(HeldDisplacement{d}).force, expected, 1e-5 * std::abs(expected)) << d;
    }
}

// fields differ where a jump occurs in one of them only: by 1.4 % at 0 on retraction from 0.1
TEST(CircularFront, MatchesAFinerFieldWithinOnePercent) {
    CircularFront coarse(sphere, random_works(512, 0.08 / 16.0, 0)), fine(sphere, random_works(512, 0.08 / 64.0, 0));
    for (const double d : {0.0, 0.1, 0.2, 0.1, 0.0, -0.1, -0.2}) {
        const double expected = fine.solve(HeldDisplacement{d}).force;
        EXPECT_NEAR(coarse.solve(HeldDisplacement{d}).force, expected, 1e-2 * std::abs(expected)) << d;
    }
}

// w = W (1 + b cos nθ) with the elasticity of the mean circle: a = a_0 (1 + b/n cos nθ), for any n the points resolve
TEST(CircularFront, OfTheMeanCircleModelMatchesASine) {
    for (const auto& [points, n] : {std::pair<Index, Index>{4, 1}, {16, 3}, {16, 7}, {17, 8}, {128, 17}})
        for (const double d : {-0.4, 1.0}) {
            const double share = 0.05;
            const auto field = work_of([&, m = static_cast<double>(n)](
                                           double, double angle) { return W * (1.0 + share * std::cos(m * angle)); },
                                       points, {401, 0.0, 0.01}, W);
            CircularFront front(sphere, field, {.model = FrontModel::mean_circle, .tolerance = 1e-12});
            front.begin_at(jkr_radius(d));
            ASSERT_TRUE(front.solve(HeldDisplacement{d}).converged);
            for (Index j = 0; j < points; ++j)
                EXPECT_NEAR(front.edge()[j],
                            jkr_radius(d) * (1.0 + share / static_cast<double>(n) *
                                                       std::cos(2.0 * pi * static_cast<double>(n * j) /
                                                                static_cast<double>(points))),
                            1e-9);
        }
}

/// G at every angle of an edge a_0 + b cos nθ, written out: K a = n b cos nθ, Q = n b²/2.
double rate_of_sine(FrontModel model, double a, double bent, double a_0, double waves, double d) {
    const auto rate = [&](double r) { return 0.75 * std::pow(d - r * r, 2) / (2.0 * pi * r); };
    switch (model) {
        case FrontModel::constant_toughness: return rate(a) + W * bent / a;
        case FrontModel::variational: {
            const double slope = (rate(a_0 + 1e-6) - rate(a_0 - 1e-6)) / 2e-6;
            return rate(a) + (rate(a_0) * bent + 0.5 * slope * waves) / a;
        }
        case FrontModel::energy_release_rate: return rate(a) * (1.0 + bent / a);
        case FrontModel::stress_intensity: return rate(a) * std::pow(1.0 + 0.5 * bent / a, 2);
        case FrontModel::mean_circle: return rate(a_0) * (1.0 + bent / a_0);
    }
    return 0.0;
}

TEST(CircularFront, OfEveryModelReproducesItsSineSolution) {
    for (const auto model : {FrontModel::constant_toughness, FrontModel::variational, FrontModel::energy_release_rate,
                             FrontModel::stress_intensity, FrontModel::mean_circle}) {
        const double d = 0.3, a_0 = jkr_radius(d), b = 0.02, n = 5.0;
        const auto edge = [&](double angle) { return a_0 + b * std::cos(n * angle); };
        const auto field = work_of(
            [&](double, double angle) {
                return rate_of_sine(model, edge(angle), n * b * std::cos(n * angle), a_0, 0.5 * n * b * b, d);
            },
            32, {401, 0.0, 0.01}, W);
        CircularFront front(sphere, field, {.model = model, .tolerance = 1e-11});
        front.begin_at(a_0);
        const auto state = front.solve(HeldDisplacement{d});
        ASSERT_TRUE(state.converged) << static_cast<int>(model);
        for (Index j = 0; j < 32; ++j)
            EXPECT_NEAR(front.edge()[j], edge(2.0 * pi * static_cast<double>(j) / 32.0), 1e-8)
                << static_cast<int>(model);
        // the area of a + b cos: π (a² + b²/2); its perimeter to second order
        EXPECT_NEAR(state.area_radius, std::sqrt(a_0 * a_0 + 0.5 * b * b), 1e-8);
        EXPECT_NEAR(state.perimeter, 2.0 * pi * a_0 * (1.0 + 0.25 * n * n * b * b / (a_0 * a_0)), 1e-4);
    }
}

TEST(CircularFront, ForcesAreDerivativesOfItsEnergy) {
    for (const auto model : {FrontModel::constant_toughness, FrontModel::variational}) {
        const auto field = work_of([](double, double angle) { return W * (1.0 + 0.2 * std::cos(3.0 * angle)); }, 32,
                                   {401, 0.0, 0.01}, W);
        CircularFront front(sphere, field, {.model = model, .tolerance = 1e-12});
        front.begin_at(jkr_radius(0.3));
        const double force = front.solve(HeldDisplacement{0.3}).force, h = 1e-4;
        const double below = front.solve(HeldDisplacement{0.3 - h}).energy();
        const double above = front.solve(HeldDisplacement{0.3 + h}).energy();
        EXPECT_NEAR((above - below) / (2.0 * h), force, 1e-6) << static_cast<int>(model);
    }
}

TEST(CircularFront, RefusesDisplacementsOutsideItsField) {
    CircularFront small(sphere, work_of([](double, double) { return W; }, 8, {101, 0.0, 0.01}, W));
    EXPECT_THROW((void)small.solve(HeldDisplacement{0.5}), InvalidArgument);
    EXPECT_THROW(CircularFront(sphere, uniform(8),
                               {.model = FrontModel::variational, .method = EquilibriumMethod::rosso_krauth}),
                 InvalidArgument);
    CircularFront front(sphere, uniform(8));
    EXPECT_THROW((void)front.solve(Stage{1.0, 0.0}), InvalidArgument);
    EXPECT_FALSE(front.solve(HeldDisplacement{-0.1}).in_contact);
}

}  // namespace circular_front_test
