// SPDX-License-Identifier: GPL-3.0-or-later
// Crossed levels beside lme4 1.1-31, lmer with REML. Numbers and their origins: README.md.
#include <gtest/gtest.h>

#include <fstream>
#include <set>

#include "setae/core/constants.hpp"
#include "setae/statistics/mixed_model.hpp"

namespace setae::statistics::crossed_levels_reference_test {

/// Three machines (the fixed effect), six workers who work at all of them, three scores each.
ReplicateData machines(const std::set<int>& left_out = {}) {
    ReplicateData data{.levels = {"machine", "worker"}, .crossed = {"worker"}};
    std::ifstream file("tests/reference/statistics/machines.txt");
    std::string machine, worker, score;
    file >> machine >> worker >> score;
    for (int row = 1; file >> machine >> worker >> score; ++row)
        if (!left_out.contains(row)) data.rows.push_back({std::stod(score), undefined, {machine, worker}});
    return data;
}

void expect_variances(const MixedModel& model, const std::vector<double>& expected) {
    ASSERT_EQ(model.fits.at(0).components.size(), expected.size());
    EXPECT_TRUE(model.fits[0].converged);
    for (std::size_t k = 0; k < expected.size(); ++k)
        EXPECT_NEAR(model.fits[0].components[k].variance / expected[k], 1.0, 1e-4) << k;
}

TEST(CrossedLevelsReference, MachinesAndWorkersAgreeWithLme4) {
    const auto data = machines();
    ASSERT_EQ(data.rows.size(), 54U);
    const auto model = mixed_model(data, {.influence = false});
    expect_variances(model, {22.8584, 13.9095, 0.9246});
    for (const auto& surface : model.surfaces)
        EXPECT_NEAR(surface.mean.standard_error / std::sqrt(6.179351874), 1.0, 1e-4);
    for (const auto& difference : model.differences)
        EXPECT_NEAR(difference.difference.standard_error / std::sqrt(2.0 * (6.179351874 - 3.809740748)), 1.0, 1e-4);
}

TEST(CrossedLevelsReference, UnbalancedMachinesAndWorkersAgreeWithLme4) {
    const auto data = machines({2, 3, 6, 9, 13, 20, 21, 33, 34, 35, 40, 44, 50, 54});
    ASSERT_EQ(data.rows.size(), 40U);
    const auto model = mixed_model(data, {.influence = false});
    expect_variances(model, {22.96783217901, 13.91409814089, 1.18603199511});
    const std::vector<double> means{52.3473924358, 60.1239251867, 66.3578862670},
        variances{6.250740292, 6.261256077, 6.234769975};
    for (std::size_t s = 0; s < means.size(); ++s) {
        const auto& mean = model.surfaces.at(s).mean;
        EXPECT_NEAR(mean.value / means[s], 1.0, 1e-6);
        EXPECT_NEAR(mean.standard_error / std::sqrt(variances[s]), 1.0, 1e-4);
    }
    EXPECT_NEAR(
        model.differences.at(0).difference.standard_error / std::sqrt(6.250740292 + 6.261256077 - 2 * 3.828098851), 1.0,
        1e-4);
}

TEST(CrossedLevelsReference, TwoCrossedLevelsOfPenicillinAgreeWithLme4) {
    ReplicateData data{.levels = {"all", "plate", "sample"}, .crossed = {"plate", "sample"}};
    std::ifstream file("tests/reference/statistics/penicillin.txt");
    std::string diameter, plate, sample;
    file >> diameter >> plate >> sample;
    while (file >> diameter >> plate >> sample)
        data.rows.push_back({std::stod(diameter), undefined, {"all", plate, sample}});
    ASSERT_EQ(data.rows.size(), 144U);
    const auto model = mixed_model(data, {.influence = false});
    expect_variances(model, {0.716905141, 3.731131842, 0.302414956});
    EXPECT_NEAR(model.surfaces[0].mean.value / 22.9722222222, 1.0, 1e-9);
    EXPECT_NEAR(model.surfaces[0].mean.standard_error / std::sqrt(0.6538264585), 1.0, 1e-4);
}

}  // namespace setae::statistics::crossed_levels_reference_test
