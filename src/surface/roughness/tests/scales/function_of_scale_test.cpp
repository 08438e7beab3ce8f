// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/scales/function_of_scale.hpp"

#include <gtest/gtest.h>

#include "brute_force.hpp"
#include "samples.hpp"
#include "setae/core/errors.hpp"
#include "setae/scales/autocorrelation.hpp"
#include "setae/scales/scale_dependent.hpp"
#include "setae/scales/variable_bandwidth.hpp"

namespace setae::scales::function_of_scale_test {
namespace {

using namespace setae::tests;
using topography::LineScan;

LineScan line(unsigned seed, Index n = 300, double step = 0.01) {
    return {tests::walk(random_heights(n, seed)), step * static_cast<double>(n), false, {}};
}

std::vector<FunctionOfScale> three_members() {
    return {autocorrelation(line(1)), autocorrelation(line(2, 500, 0.001)), autocorrelation(line(3, 200, 0.1))};
}

TEST(Combination, OfIdenticalMembersEqualsTheMember) {
    const auto member = autocorrelation(line(1));
    const std::vector<FunctionOfScale> same(3, member);
    const auto combined = combine(same);
    const auto alone = binned(member);
    ASSERT_EQ(combined.value.size(), alone.value.size());
    EXPECT_LT((combined.value / alone.value - 1.0).abs().maxCoeff(), 1e-14);
    EXPECT_LT((combined.distance / alone.distance - 1.0).abs().maxCoeff(), 1e-14);
    EXPECT_LT((combined.standard_error / alone.value).abs().maxCoeff(), 1e-14);
    EXPECT_TRUE((combined.count == 3.0).all());
}

TEST(Combination, DoesNotDependOnOrder) {
    auto members = three_members();
    const auto combined = combine(members);
    std::reverse(members.begin(), members.end());
    const auto reversed = combine(members);
    EXPECT_LT((combined.value / reversed.value - 1.0).abs().maxCoeff(), 1e-14);
    EXPECT_TRUE((combined.count == reversed.count).all());
}

TEST(Combination, BinsDoNotDependOnOtherMembers) {
    const auto members = three_members();
    const auto combined = combine(members);
    const spectra::LogGrid grid;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto alone = combine(std::vector{members[i]});
        for (Index b = 0; b < alone.value.size(); ++b)
            for (Index c = 0; c < combined.value.size(); ++c)
                if (grid.bin_of(alone.distance[b]) == grid.bin_of(combined.distance[c]) && combined.count[c] == 1.0) {
                    EXPECT_EQ(alone.value[b], combined.value[c]);
                }
    }
    // a distance of a power of ten is at an edge, for any range of the data
    EXPECT_EQ(grid.bin_of(10.0), 10);
    EXPECT_EQ(grid.bin_of(10.0 * (1.0 - 1e-9)), 9);
}

TEST(Combination, GivesMeanStandardErrorAndContributors) {
    FunctionOfScale first;
    first.quantity = "rms_slope";
    first.unit = "1";
    first.distance = first.count = first.standard_error = first.value = Array1D::Constant(1, 2.0);
    auto second = first, third = first;
    first.metadata.instrument.type = second.metadata.instrument.type = "afm";
    third.metadata.instrument.type = "stylus";
    second.value[0] = 4.0;
    third.value[0] = 9.0;
    third.count[0] = 6.0;
    const std::vector members{first, second, third};
    const auto equal = combine(members);
    EXPECT_DOUBLE_EQ(equal.value[0], 5.0);
    EXPECT_DOUBLE_EQ(equal.standard_error[0], std::sqrt((9.0 + 1.0 + 16.0) / 2.0 / 3.0));
    EXPECT_EQ(equal.contributors[0], (std::vector<Index>{0, 1, 2}));
    EXPECT_EQ(equal.instrument_count[0], 2.0);
    EXPECT_DOUBLE_EQ(combine(members, {.weighting = Weighting::per_instrument}).value[0], 0.5 * (3.0 + 9.0));
    EXPECT_DOUBLE_EQ(combine(members, {.weighting = Weighting::by_count}).value[0],
                     (2.0 * 2.0 + 2.0 * 4.0 + 6.0 * 9.0) / 10.0);
    EXPECT_TRUE(std::isnan(combine(std::vector{first}).standard_error[0]));
}

TEST(Combination, LimitsEachMemberToItsReliableRange) {
    auto scan = line(1, 300, 1.0);
    scan.metadata.instrument.resolution = 20.0;
    const auto alone = within_limit(autocorrelation(scan));
    EXPECT_DOUBLE_EQ(alone.distance[0], 10.0);
    EXPECT_DOUBLE_EQ(combine(std::vector{autocorrelation(scan)}).distance[0], binned(alone).distance[0]);
    const auto slopes = difference_statistics(scan), curvatures = difference_statistics(scan, {.order = 2});
    EXPECT_DOUBLE_EQ(slopes.reliable_from, 10.0);
    EXPECT_DOUBLE_EQ(curvatures.reliable_from, 20.0);
    for (const auto& statistics : {slopes, curvatures}) {
        const auto function = function_of(statistics, Statistic::rms);
        EXPECT_EQ(combine(std::vector{function}).distance[0], within_limit(function).distance[0]);
    }
    const auto bandwidths = within_limit(variable_bandwidth(scan));
    EXPECT_GE(bandwidths.distance[0], 20.0);
    EXPECT_LT(bandwidths.distance[0], 40.0);
}

TEST(Combination, AssignsValuesToTheirDistances) {
    auto scan = line(1, 300, 1.0);
    const auto all = function_of(difference_statistics(scan), Statistic::rms);
    scan.metadata.instrument.resolution = 20.0;
    const auto cut = combine(std::vector{function_of(difference_statistics(scan), Statistic::rms)});
    for (Index b = 0; b < cut.distance.size(); ++b) {
        Index at = 0;
        (all.distance - cut.distance[b]).abs().minCoeff(&at);
        EXPECT_NEAR(all.distance[at], cut.distance[b], 1e-9);
        EXPECT_EQ(all.value[at], cut.value[b]);
    }
}

TEST(Combination, WithoutReliableDataIsAnError) {
    auto scan = line(1);
    scan.metadata.instrument.resolution = 100.0;
    const auto functions = std::vector{autocorrelation(scan)};
    EXPECT_THROW((void)combine(functions), InvalidArgument);
    EXPECT_THROW((void)combine(std::vector{function_of(difference_statistics(scan), Statistic::rms)}), InvalidArgument);
    EXPECT_THROW((void)combine(std::vector{variable_bandwidth(scan)}), InvalidArgument);
    EXPECT_THROW((void)combine(std::span<const FunctionOfScale>{}), InvalidArgument);
    EXPECT_THROW((void)combine(std::vector{autocorrelation(line(1)), variable_bandwidth(line(1))}), InvalidArgument);
}

TEST(Combination, WithoutReliableDataIsAnErrorForMapsAndPolylinesToo) {
    topography::HeightMap map{random_map(20, 20), {1.0, 1.0}, false, {}};
    auto profile = random_profile(30);
    map.metadata.instrument.resolution = 10.0;
    profile.metadata.instrument.resolution = 1e3;
    for (const auto& function : {autocorrelation_of_lines(map), autocorrelation_of_area(map), autocorrelation(profile),
                                 variable_bandwidth_of_area(map), variable_bandwidth(profile),
                                 function_of(difference_statistics(map), Statistic::rms),
                                 function_of(difference_statistics(profile), Statistic::rms)}) {
        EXPECT_EQ(within_limit(function).distance.size(), 0) << function.quantity;
        EXPECT_THROW((void)combine(std::vector{function}), InvalidArgument) << function.quantity;
    }
}

TEST(Combination, NamesTheGapBetweenMembers) {
    const std::vector members{autocorrelation(line(1, 100, 1e-3)), autocorrelation(line(2, 100, 1.0))};
    const auto combined = combine(members);
    ASSERT_EQ(combined.alerts.size(), 1u);
    EXPECT_EQ(combined.alerts[0].code, "COVERAGE_GAP");
    // distances that were not requested are no gap
    const auto asked = difference_statistics(line(1), {.distances = log_spaced(3, 0.01, 1.0)});
    EXPECT_TRUE(combine(std::vector{function_of(asked, Statistic::rms)}).alerts.empty());
}

TEST(Combination, BinningTwiceEqualsBinningOnce) {
    const auto once = binned(autocorrelation(line(1))), twice = binned(once);
    EXPECT_TRUE((once.value == twice.value).all());
    EXPECT_TRUE((once.count == twice.count).all());
}

TEST(Combination, ScalesWithTheUnit) {
    auto scan = line(1), small = scan;
    small.size *= 1e-6;
    small.heights *= 1e-6;
    const auto metres = combine(std::vector{autocorrelation(scan)}),
               micrometres = combine(std::vector{autocorrelation(small)});
    EXPECT_LT((micrometres.value / metres.value * 1e12 - 1.0).abs().maxCoeff(), 1e-12);
    EXPECT_LT((micrometres.distance / metres.distance * 1e6 - 1.0).abs().maxCoeff(), 1e-12);
}

TEST(Combination, RefusesToWeightLengthsAgainstPairs) {
    const std::vector mixed{autocorrelation(line(1, 300, 1.0)), autocorrelation(random_profile(100))};
    EXPECT_NO_THROW((void)combine(mixed));
    EXPECT_THROW((void)combine(mixed, {.weighting = Weighting::by_count}), InvalidArgument);
}

TEST(Weighting, IsFoundByName) {
    EXPECT_EQ(weighting_from_name("per_instrument"), Weighting::per_instrument);
    EXPECT_THROW((void)weighting_from_name("none"), InvalidArgument);
}

}  // namespace
}  // namespace setae::scales::function_of_scale_test
