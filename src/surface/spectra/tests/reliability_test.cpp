// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectra/reliability.hpp"

#include <gtest/gtest.h>

#include "samples.hpp"
#include "setae/core/errors.hpp"

namespace reliability_test {

using namespace setae;
using namespace setae::spectra;
using topography::HeightMap;
using topography::LineScan;
using topography::Profile;

constexpr double amplitude = 0.05;

/// cos x over ten periods, a peak on a grid point.
LineScan cosine(bool periodic = true, double unit = 1.0) {
    const Index n = 2000;
    const auto heights = Array1D::NullaryExpr(n, [=](Index i) {
        return unit * amplitude * std::cos(2.0 * pi * 10.0 * static_cast<double>(i) / static_cast<double>(n));
    });
    return {heights, unit * 20.0 * pi, periodic, {}};
}

/// Radius whose cutoff on the cosine is l: the second difference at a peak is −A (2 − 2cos(l/2))/(l/2)².
double radius_for(double length) {
    const double half = 0.5 * length;
    return half * half / (4.0 * amplitude * (1.0 - std::cos(half)));
}

TEST(TipCutoff, OfACosineIsWhereItsCurvatureReachesThatOfTheTip) {
    const double step = 20.0 * pi / 2000.0;
    for (const Index steps : {40, 60, 90}) {
        // stencil arms that end on grid points, where linear interpolation is exact
        const double length = 2.0 * static_cast<double>(steps) * step;
        for (const bool periodic : {true, false}) {
            const auto cutoff = tip_cutoff(cosine(periodic), radius_for(length));
            EXPECT_EQ(cutoff.status, CutoffStatus::found);
            EXPECT_NEAR(cutoff.value / length, 1.0, 1e-7);
        }
    }
}

TEST(TipCutoff, DoesNotDependOnTheUnitOfLength) {
    const double radius = radius_for(3.0), expected = tip_cutoff(cosine(), radius).value;
    for (const double unit : {1e-12, 1e-9, 1e-6, 1e-3})
        EXPECT_NEAR(tip_cutoff(cosine(true, unit), radius * unit).value / (unit * expected), 1.0, 1e-7);
}

TEST(TipCutoff, OfAMapIsEvaluatedAlongXOrY) {
    const auto scan = cosine();
    const HeightMap along_x{scan.heights.replicate(1, 50), {scan.size, 5.0}, true, {}};
    const HeightMap along_y{scan.heights.transpose().replicate(50, 1), {5.0, scan.size}, true, {}};
    const double radius = radius_for(3.0), expected = tip_cutoff(scan, radius).value;
    EXPECT_NEAR(tip_cutoff(along_x, radius).value, expected, 1e-9);
    EXPECT_EQ(tip_cutoff(along_y, radius).status, CutoffStatus::all_reliable);
    EXPECT_NEAR(tip_cutoff(along_y, radius, {}, {.both_directions = true}).value, expected, 1e-9);
}

TEST(TipCutoff, OfAProfileEqualsThatOfTheLineScan) {
    const auto scan = cosine(false);
    const Profile profile{Array1D::LinSpaced(2000, 0.0, 1999.0) * scan.pixel_size(), scan.heights, {}};
    EXPECT_NEAR(tip_cutoff(profile, radius_for(3.0)).value, tip_cutoff(scan, radius_for(3.0)).value, 1e-7);
}

TEST(TipCutoff, ReportsWhenEverythingOrNothingIsReliable) {
    const auto sharp = tip_cutoff(cosine(), 1e-3);
    EXPECT_EQ(sharp.status, CutoffStatus::all_reliable);
    EXPECT_EQ(sharp.value, 0.0);
    const auto blunt = tip_cutoff(cosine(false), 1e9);
    EXPECT_EQ(blunt.status, CutoffStatus::nothing_reliable);
    EXPECT_NEAR(blunt.value, 20.0 * pi, 1e-12);
}

TEST(TipCutoff, APercentileIgnoresASpike) {
    auto scan = cosine();
    const double radius = radius_for(3.0), expected = tip_cutoff(scan, radius).value;
    scan.heights[1003] += 100.0 * amplitude;
    EXPECT_GT(tip_cutoff(scan, radius).value, 2.0 * expected);
    const auto robust = tip_cutoff(scan, radius, {}, {.percentile = 0.002});
    EXPECT_NEAR(robust.value / expected, 1.0, 0.02);
    EXPECT_EQ(robust.percentile, 0.002);
}

TEST(TipCutoff, ExcludesOnlyStencilsThatUseAHole) {
    auto scan = cosine();
    scan.heights[77] = undefined;
    const double expected = tip_cutoff(cosine(), radius_for(3.0)).value;
    EXPECT_NEAR(tip_cutoff(scan, radius_for(3.0)).value, expected, 1e-9);
}

TEST(TipCutoff, IntervalFollowsFromThatOfTheRadius) {
    const double radius = radius_for(3.0), error = 0.1 * radius;
    const auto cutoff = tip_cutoff(cosine(), radius, error);
    ASSERT_TRUE(cutoff.interval);
    EXPECT_NEAR(cutoff.interval->lower, tip_cutoff(cosine(), radius - 1.959963984540054 * error).value, 1e-12);
    EXPECT_NEAR(cutoff.interval->upper, tip_cutoff(cosine(), radius + 1.959963984540054 * error).value, 1e-12);
    EXPECT_FALSE(tip_cutoff(cosine(), radius).interval);
}

TEST(TipCutoff, GivesTheSameBytesForAnyNumberOfThreads) {
    const HeightMap map{tests::random_map(200, 64), {200.0, 64.0}, false, {}};
    for (const double percentile : {0.0, 0.01}) {
        const ReliabilityOptions options{.percentile = percentile, .both_directions = true};
        EXPECT_EQ(tip_cutoff(map, 30.0, {}, options, {1}).value, tip_cutoff(map, 30.0, {}, options, {3}).value);
    }
}

TEST(TipCutoff, RefusesInvalidRadiiAndPercentiles) {
    EXPECT_THROW((void)tip_cutoff(cosine(), 0.0), InvalidArgument);
    EXPECT_THROW((void)tip_cutoff(cosine(), undefined), InvalidArgument);
    EXPECT_THROW((void)tip_cutoff(cosine(), 1.0, {}, {.percentile = 0.7}), InvalidArgument);
}

TEST(ReliableBand, EndsAtTheSmallestOfItsLimits) {
    auto scan = cosine();
    const double nyquist = pi / scan.pixel_size();
    EXPECT_NEAR(reliable_band(scan).band.upper, nyquist, 1e-12 * nyquist);
    EXPECT_EQ(reliable_band(scan).upper_limit, "sampling");
    EXPECT_NEAR(reliable_band(scan).band.lower, 0.1, 1e-14);

    scan.metadata.instrument.resolution = 0.5;
    EXPECT_NEAR(reliable_band(scan).band.upper, 4.0 * pi, 1e-12);
    EXPECT_EQ(reliable_band(scan).upper_limit, "resolution");

    scan.metadata.instrument.tip_radius = radius_for(3.0);
    const auto tip = reliable_band(scan);
    EXPECT_NEAR(tip.band.upper * tip.tip->value, 2.0 * pi, 1e-12);
    EXPECT_EQ(tip.upper_limit, "tip radius");
    ASSERT_EQ(tip.alerts.size(), 1u);
    EXPECT_EQ(tip.alerts[0].code, "TIP_CUTOFF");
}

TEST(ReliableBand, ExcludesLowModesAndTheRequestedShareBelowNyquist) {
    const auto band = reliable_band(cosine(), {.nyquist_fraction = 0.5, .first_mode = 3}).band;
    EXPECT_NEAR(band.lower, 0.3, 1e-14);
    EXPECT_NEAR(band.upper, 50.0, 1e-12);
    EXPECT_THROW((void)reliable_band(cosine(), {.nyquist_fraction = 0.0}), InvalidArgument);
    EXPECT_THROW((void)reliable_band(cosine(), {.first_mode = 0}), InvalidArgument);
}

TEST(ReliableBand, IsEmptyIfTheTipHidesEverything) {
    auto scan = cosine(false);
    scan.metadata.instrument.tip_radius = 1e9;
    EXPECT_TRUE(reliable_band(scan).empty());
    EXPECT_FALSE(reliable_band(cosine()).empty());
}

TEST(ReliableBand, OfAMapByBandsEqualsThatOfTheWholeMap) {
    topography::HeightMap map{tests::random_map(128, 33), {1.0, 0.3}, false, {}};
    map.heights *= 1e-3;
    map.metadata.instrument.tip_radius = 0.05;
    map.metadata.instrument.tip_radius_standard_error = 0.01;
    const auto whole = reliable_band(map);
    ASSERT_TRUE(whole.tip);
    for (const Index lines : {1, 8, 33}) {
        const auto tiled = reliable_band(topography::tiled(map), lines);
        EXPECT_NEAR(tiled.band.upper, whole.band.upper, 1e-6 * whole.band.upper);
        EXPECT_NEAR(tiled.tip->interval->lower, whole.tip->interval->lower, 1e-6);
        EXPECT_NEAR(tiled.tip->interval->upper, whole.tip->interval->upper, 1e-6);
        EXPECT_EQ(tiled.upper_limit, whole.upper_limit);
    }
    EXPECT_THROW((void)reliable_band(topography::tiled(map), 8, {.percentile = 0.01}), InvalidArgument);
}

}  // namespace reliability_test
