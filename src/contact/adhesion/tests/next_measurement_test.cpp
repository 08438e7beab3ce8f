// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/adhesion/next_measurement.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "setae/roughness/parameter_spread.hpp"

namespace setae::adhesion::next_measurement_test {
namespace {

using Kind = Candidate::Kind;

Components one(const std::string& name, double size) { return {{name, {Array1D::Constant(1, size)}}}; }

/// Four smooth pairs on one lens: W is their mean, Var W = σ²/4 + s².
std::vector<PairPoint> smooth_pairs(double noise, double lens) {
    std::vector<PairPoint> list;
    for (int e = 0; e < 4; ++e) {
        PairPoint p{.surface = "s", .elastomer = "e" + std::to_string(e), .measured = {0.04, noise}, .slope = 1.0};
        p.in_unitputs = one("lens", lens);
        list.push_back(std::move(p));
    }
    return list;
}

TEST(NextMeasurement, PredictsTheVarianceOfAMean) {
    constexpr double noise = 4e-4, lens = 3e-4;
    const auto pairs = smooth_pairs(noise, lens);
    const auto fit = fit_generalised(pairs, ModelScatter{});
    const auto next = next_measurements(
        work_target(pairs, fit),
        {{.kind = Kind::loop, .name = "s", .elastomer = "e0", .loops = 1}, {.kind = Kind::input, .name = "lens"}});
    ASSERT_EQ(next.size(), 2U);
    EXPECT_EQ(next[0].candidate.name, "lens");
    EXPECT_NEAR(next[0].standard_error, std::sqrt(noise * noise / 4.0 + lens * lens / 4.0), 1e-12);
    // one of four weights doubled: 1/(3/σ² + 2/σ²)
    EXPECT_NEAR(next[1].standard_error, std::sqrt(noise * noise / 5.0 + lens * lens), 1e-12);
    EXPECT_NEAR(next[1].gain, 1.0 - next[1].standard_error / fit.work_of_adhesion.standard_error(), 1e-12);
}

TEST(NextMeasurement, RanksByGainPerHourIfAllHoursAreGiven) {
    const auto pairs = smooth_pairs(4e-4, 3e-4);
    const auto fit = fit_generalised(pairs, ModelScatter{});
    const auto next =
        next_measurements(work_target(pairs, fit), {{.kind = Kind::loop, .name = "s", .elastomer = "e0", .hours = 0.1},
                                                    {.kind = Kind::input, .name = "lens", .hours = 50.0}});
    EXPECT_EQ(next[0].candidate.kind, Kind::loop);
}

TEST(NextMeasurement, OfAPredictionIncludesItsOwnInputs) {
    const auto pairs = smooth_pairs(4e-4, 3e-4);
    PairPoint line{.surface = "rough", .elastomer = "e0", .slope = 1.3, .offset = 0.01};
    line.slope_inputs = one(roughness::spectrum_input("rough"), 0.1);
    const auto fit = fit_generalised(pairs, ModelScatter{});
    const double now = raw_prediction(line, fit.work_of_adhesion).standard_error();
    const auto next =
        next_measurements(prediction_target(pairs, fit, line), {{.kind = Kind::spectrum, .name = "rough"}});
    const double W = fit.work_of_adhesion.value;
    EXPECT_NEAR(next[0].standard_error, std::sqrt(now * now - 0.5 * std::pow(W * 0.1, 2)), 1e-9);
}

// What both fits share drops out of their difference: the lens of all pairs, and the noise of the same measured values.
TEST(NextMeasurement, OfADifferenceCancelsCommonInputs) {
    const auto pairs = smooth_pairs(4e-4, 3e-4);
    auto others = pairs;
    for (auto& pair : others) {
        pair.quantity = "E_loss";
        pair.measured.standard_error = 6e-4;
    }
    const auto fit = fit_generalised(pairs, ModelScatter{}), loss = fit_generalised(others, ModelScatter{});
    const auto work = work_target(pairs, fit), from_loss = work_target(others, loss);
    EXPECT_NEAR(value_of(difference_target(work, work)).standard_error(), 0.0, 1e-15);
    const auto difference = difference_target(work, from_loss);
    EXPECT_NEAR(value_of(difference).standard_error(), std::sqrt((16e-8 + 36e-8) / 4.0), 1e-10);
    const auto next = next_measurements(difference, {{.kind = Kind::input, .name = "lens"}});
    EXPECT_NEAR(next[0].gain, 0.0, 1e-6);
}

// Doing it: the scatter of W over drawn data with one pair measured twice is what was promised.
TEST(NextMeasurement, PredictedErrorMatchesTheScatterAfterMeasuring) {
    constexpr int draws = 4000;
    constexpr double noise = 4e-4, lens = 3e-4;
    const auto nominal = smooth_pairs(noise, lens);
    const auto fit = fit_generalised(nominal, ModelScatter{});
    const auto promised = next_measurements(work_target(nominal, fit),
                                            {{.kind = Kind::loop, .name = "s", .elastomer = "e0", .loops = 1}});
    std::mt19937 random(5);
    std::normal_distribution<double> normal;
    double squares = 0.0;
    for (int d = 0; d < draws; ++d) {
        auto pairs = nominal;
        const double gain = lens * normal(random);
        for (auto& p : pairs) p.measured.value += gain + noise * normal(random);
        pairs[0].measured.value += 0.5 * (0.04 + gain + noise * normal(random) - pairs[0].measured.value);
        pairs[0].measured.standard_error = noise / std::sqrt(2.0);
        const double off = fit_generalised(pairs, ModelScatter{}).work_of_adhesion.value - 0.04;
        squares += off * off / draws;
    }
    EXPECT_NEAR(std::sqrt(squares) / promised[0].standard_error, 1.0, 3.0 / std::sqrt(2.0 * draws));
}

}  // namespace
}  // namespace setae::adhesion::next_measurement_test
