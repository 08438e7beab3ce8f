// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/processing/untouched.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "setae/core/constants.hpp"
#include "setae/processing/steps.hpp"

namespace setae::processing::untouched_test {
namespace {

constexpr Index points = 20000;
constexpr double step = 1e-7;

/// Power of a wave after a filter, far from the ends.
double kept_power(const Step& filter, double wavevector) {
    topography::LineScan scan{Array1D(points), points * step, false, {}};
    for (Index i = 0; i < points; ++i) scan.heights[i] = 1e-9 * std::sin(wavevector * step * static_cast<double>(i));
    const Array1D before = scan.heights.segment(points / 4, points / 2);
    const auto after = std::get<topography::LineScan>(apply(filter, scan, {}).measurement);
    return std::pow((after.heights.segment(points / 4, points / 2) * before).sum() / before.square().sum(), 2);
}

// At its ends the band keeps 99 %, and little more: much less at half the distance beyond.
TEST(Untouched, BandsOfFiltersTransmitNinetyNinePercent) {
    const double cutoff = 20e-6;
    for (const Step& filter : {Step(GaussianFilter{.cutoff = cutoff, .keep = Kept::short_waves}),
                               Step(SplineFilter{.cutoff = cutoff, .keep = Kept::short_waves}),
                               Step(RobustGaussianFilter{.cutoff = cutoff, .keep = Kept::short_waves})}) {
        const double lowest = untouched({{{filter}}}, step).band.lower;
        EXPECT_GT(kept_power(filter, lowest), 0.985) << name(filter);
        EXPECT_LT(kept_power(filter, lowest / 1.5), 0.985) << name(filter);
    }
    for (const Step& filter : {Step(GaussianFilter{.cutoff = cutoff}), Step(SplineFilter{.cutoff = cutoff})}) {
        const double highest = untouched({{{filter}}}, step).band.upper;
        EXPECT_GT(kept_power(filter, highest), 0.985) << name(filter);
        EXPECT_LT(kept_power(filter, highest * 1.5), 0.985) << name(filter);
    }
}

TEST(Untouched, CombinesTheStepsOfAPipeline) {
    Pipeline pipeline;
    pipeline.entries = {{LevelPolynomial{.degree = 5, .degree_x = 3}},
                        {LevelLines{.degree = 2}},
                        {LevelLines{.degree = 9}, false},
                        {LevelLines{.degree = 7, .direction = Direction::y}},
                        {FourierCut{.shortest = 1e-6, .longest = 1e-4}},
                        {Despike{}}};
    const auto found = untouched(pipeline, step);
    EXPECT_EQ(found.trend_degree, 3);
    EXPECT_DOUBLE_EQ(found.band.lower, 2.0 * pi / 1e-4);
    EXPECT_DOUBLE_EQ(found.band.upper, 2.0 * pi / 1e-6);
    EXPECT_TRUE(std::isinf(untouched({}, step).band.upper));
    EXPECT_NEAR(untouched({{{Resample{.pixel_size = 4e-7}}}}, step).band.upper, 0.35 / 4e-7, 1.0);
}

}  // namespace
}  // namespace setae::processing::untouched_test
