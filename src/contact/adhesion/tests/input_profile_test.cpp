// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/adhesion/input_profile.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "setae/core/constants.hpp"

namespace setae::adhesion::input_profile_test {
namespace {

Components one(const std::string& name, double size) { return {{name, {Array1D::Constant(1, size)}}}; }

/// Pairs of one elastomer on rougher and rougher surfaces, W = 37 mJ/m² and γ1 as given; the study is told 25 ± 5
/// mJ/m².
std::vector<PairPoint> pairs_of(double surface_energy, double noise) {
    std::vector<PairPoint> list;
    for (const double r : {1.0, 1.1, 1.2, 1.4, 1.6}) {
        PairPoint p{.surface = std::to_string(r), .elastomer = "e", .slope = r, .offset = 0.025 * (r - 1.0)};
        p.measured = {0.037 * r - surface_energy * (r - 1.0), noise};
        p.offset_inputs = one("surface_energy", 0.005 * (r - 1.0));
        list.push_back(std::move(p));
    }
    return list;
}

// Weighted straight line: measured = W r − γ (r − 1) is linear in W and γ, so that the line's own γ and its standard
// error are what the pairs alone say.
TEST(InputProfile, RecoversTheInputFromThePairs) {
    constexpr double noise = 1e-4;
    const auto pairs = pairs_of(0.031, noise);
    const auto fit = fit_generalised(pairs, ModelScatter{});
    const auto profiles = profile_inputs(pairs, fit, {"surface_energy"});
    ASSERT_EQ(profiles.size(), 1U);
    double rr = 0.0, rd = 0.0, dd = 0.0;
    for (const auto& p : pairs) {
        const double r = p.slope, d = r - 1.0;
        rr += r * r;
        rd += r * d;
        dd += d * d;
    }
    const double error = noise * std::sqrt(rr / (rr * dd - rd * rd));
    EXPECT_NEAR(profiles[0].by_pairs.value, (0.031 - 0.025) / 0.005, 1e-6);
    EXPECT_NEAR(profiles[0].by_pairs.standard_error, error / 0.005, 1e-6);
}

// ∂W/∂γ1 = Σ r (r − 1)/Σ r² where all pairs weigh alike.
TEST(InputProfile, ChangesWAsTheDerivative) {
    const auto pairs = pairs_of(0.025, 1e-4);
    const auto profile = profile_inputs(pairs, fit_generalised(pairs, ModelScatter{}), {"surface_energy"}).at(0);
    double rr = 0.0, rd = 0.0;
    for (const auto& p : pairs) {
        rr += p.slope * p.slope;
        rd += p.slope * (p.slope - 1.0);
    }
    ASSERT_EQ(profile.points.size(), 5U);
    for (const auto& point : profile.points)
        EXPECT_NEAR(point.work_of_adhesion.value - 0.037, point.shift * 0.005 * rd / rr, 1e-9);
}

TEST(InputProfile, OfAnUndeterminedInputHasNoMaximum) {
    auto pairs = pairs_of(0.025, 1e-4);
    for (auto& p : pairs) {
        p.in_unitputs = one("lens", 0.01 * p.measured.value);
        p.slope_inputs = {{"spectrum", {Array1D::Constant(3, 0.01)}}};
        p.offset = 0.0;  // all measured values go with W alone, as they do with the lens
        p.measured.value = 0.037 * p.slope;
        p.in_unitputs = one("lens", 0.01 * p.measured.value);
    }
    const auto profiles =
        profile_inputs(pairs, fit_generalised(pairs, ModelScatter{}), {"lens", "spectrum", "nothing"});
    ASSERT_EQ(profiles.size(), 1U);  // several directions, or none, have no profile
    EXPECT_TRUE(std::isnan(profiles[0].by_pairs.standard_error));
    EXPECT_NEAR(profiles[0].points.back().work_of_adhesion.value, 1.02 * 0.037, 1e-6);
}

TEST(GeneralisedFit, HasTheNormalLogLikelihoodOfIndependentPairs) {
    std::vector<PairPoint> pairs;
    for (const double w : {0.036, 0.037, 0.040})
        pairs.push_back({.surface = "s", .elastomer = std::to_string(w), .measured = {w, 2e-3}, .slope = 1.0});
    const auto fit = fit_generalised(pairs, ModelScatter{});
    const double mean = 0.113 / 3.0;
    double expected = 0.0;
    for (const double w : {0.036, 0.037, 0.040})
        expected += -0.5 * std::pow((w - mean) / 2e-3, 2) - std::log(2e-3) - 0.5 * std::log(2.0 * pi);
    EXPECT_NEAR(fit.log_likelihood, expected, 1e-6);
}

}  // namespace
}  // namespace setae::adhesion::input_profile_test
