// SPDX-License-Identifier: GPL-3.0-or-later
// W_int of each elastomer in proportion to its smooth reference.
#include <gtest/gtest.h>

#include <random>

#include "setae/adhesion/pair_fit.hpp"
#include "setae/adhesion/prediction.hpp"

namespace setae::adhesion::reference_scaled_test {
namespace {

/// Four surfaces, four elastomers with works of 40, 37, 39 and 51 mJ/m² of their own, noise of 0.5 mJ/m².
std::vector<PairPoint> pairs() {
    static constexpr double works[] = {0.040, 0.037, 0.039, 0.051}, ratios[] = {1.07, 1.69, 1.48, 1.42},
                            energies[] = {0.2e-9, 3e-9, 4e-9, 5e-9}, moduli[] = {0.9e6, 1.4e6, 2.5e6, 3.5e6};
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal(0.0, 5e-4);
    std::vector<PairPoint> list;
    for (int s = 0; s < 4; ++s)
        for (int e = 0; e < 4; ++e) {
            PairPoint pair{.surface = "s" + std::to_string(s), .elastomer = "e" + std::to_string(e)};
            pair.slope = ratios[s];
            pair.offset = 0.025 * (ratios[s] - 1.0) + moduli[e] * energies[s];
            pair.measured = {works[e] * pair.slope - pair.offset + normal(random), 5e-4};
            list.push_back(std::move(pair));
        }
    return list;
}

TEST(ReferenceScaled, IsOneForTrueReferencesAndRejectsACommonWork) {
    static constexpr double references[] = {0.040, 0.037, 0.039, 0.051};
    auto scaled = pairs();
    for (std::size_t i = 0; i < scaled.size(); ++i)
        scaled[i] = reference_scaled_point(std::move(scaled[i]), TracedValue(references[i % 4]));
    const auto factor = fit_work_of_adhesion(scaled), common = fit_work_of_adhesion(pairs());
    const auto& c = factor.generalised.work_of_adhesion;
    EXPECT_NEAR(c.value, 1.0, 2.0 * c.standard_error());
    EXPECT_LT(c.standard_error(), 0.01);
    EXPECT_LT(factor.weighted->chi_squared, 30.0);  // of 15: 1.2 % above by chance
    EXPECT_GT(common.weighted->chi_squared, 1000.0);
    EXPECT_GT(factor.r_squared, common.r_squared);
}

TEST(ReferenceScaled, SlopeIsReferenceWorkTimesAreaRatio) {
    const auto pair = pairs()[5];
    const auto scaled = reference_scaled_point(pair, {Estimate{.value = 0.037, .standard_error = 0.001}, "reference"});
    EXPECT_DOUBLE_EQ(scaled.slope, 0.037 * pair.slope);
    EXPECT_DOUBLE_EQ(scaled.offset, pair.offset);
    EXPECT_TRUE(scaled.slope_inputs.contains("reference"));
}

}  // namespace
}  // namespace setae::adhesion::reference_scaled_test
