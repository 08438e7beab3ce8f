// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/processing/despike.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <set>
#include <vector>

#include "record_number.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/spectra/self_affine.hpp"
#include "setae/synthesis/random_surface.hpp"

namespace setae::processing::despike_test {
namespace {

using topography::HeightMap;
using topography::LineScan;

HeightMap self_affine(Index n, double hurst_exponent, std::uint64_t seed) {
    const double size = 1e-6;
    const spectra::SelfAffine model{1e-30, 2.0 * pi / size * 4.0, hurst_exponent, pi * static_cast<double>(n) / size};
    synthesis::SurfaceOptions options;
    options.key = {seed};
    options.exact_rms_height = 1e-8;
    return synthesis::random_surface(spectra::density(model), {n, n, size, size}, options);
}

/// Points sufficiently far from each other, within the map, changed by ± `height`.
std::set<Index> add_spikes(HeightMap& map, double height, Index count, unsigned seed) {
    std::mt19937 engine(seed);
    std::set<Index> added;
    while (static_cast<Index>(added.size()) < count) {
        const auto i = static_cast<Index>(engine() % static_cast<unsigned>(map.heights.rows())),
                   j = static_cast<Index>(engine() % static_cast<unsigned>(map.heights.cols()));
        if (!added.insert(i * map.heights.cols() + j).second) continue;
        map.heights(i, j) += added.size() % 2 == 0 ? height : -height;
    }
    return added;
}

/// The median, by sorting.
double middle_of(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const auto n = values.size();
    return n % 2 == 1 ? values[n / 2] : 0.5 * (values[n / 2 - 1] + values[n / 2]);
}

/// Median of the rises from a point to those around it minus the tilt, point by point.
double median_around(const HeightMap& map, Index i, Index j, Index reach, double down, double along) {
    const auto [nx, ny] = map.shape();
    const auto narrowed = [reach](Index place, Index n) { return std::min({reach, place, n - 1 - place}); };
    const Index reach_i = narrowed(i, nx), reach_j = narrowed(j, ny);
    std::vector<double> rises;
    for (Index a = -reach_i; a <= reach_i; ++a)
        for (Index b = -reach_j; b <= reach_j; ++b) {
            const double rise = map.heights(i + a, j + b) - map.heights(i, j) - static_cast<double>(a) * down -
                                static_cast<double>(b) * along;
            if ((a != 0 || b != 0) && !std::isnan(rise)) rises.push_back(rise);
        }
    return rises.empty() ? undefined : middle_of(rises);
}

TEST(FindSpikes, ComparesWithTheMedianOfNeighbours) {
    auto map = self_affine(64, 0.5, 3);
    map.heights(20, 31) = undefined;
    const auto [nx, ny] = map.shape();
    std::vector<double> down, along;
    for (Index i = 0; i < nx; ++i)
        for (Index j = 0; j < ny; ++j) {
            if (i + 1 < nx) down.push_back(map.heights(i + 1, j) - map.heights(i, j));
            if (j + 1 < ny) along.push_back(map.heights(i, j + 1) - map.heights(i, j));
        }
    for (auto* rises : {&down, &along}) std::erase_if(*rises, [](double rise) { return std::isnan(rise); });
    for (const Index reach : {1, 2, 3, 7}) {
        std::vector<double> sizes;
        for (Index i = 0; i < nx; ++i)
            for (Index j = 0; j < ny; ++j)
                if (const double median = median_around(map, i, j, reach, middle_of(down), middle_of(along));
                    !std::isnan(median))
                    sizes.push_back(std::abs(median));
        constexpr double upper_quartile_of_normal = 0.67448975019608174;
        EXPECT_NEAR(find_spikes(map, {.reach = reach}).deviation / (middle_of(sizes) / upper_quartile_of_normal), 1.0,
                    1e-12)
            << reach;
    }
}

TEST(FindSpikes, FindsNineteenOfTwentySpikesOfFiveRms) {
    for (const double hurst_exponent : {0.3, 0.8}) {
        Index found = 0, added_count = 0, wrong = 0;
        for (std::uint64_t seed = 1; seed <= 4; ++seed) {
            auto map = self_affine(128, hurst_exponent, seed);
            const auto added = add_spikes(map, 5e-8, 20, static_cast<unsigned>(seed));
            const auto spikes = find_spikes(map);
            for (const Index k : added) found += spikes.mask.data()[k];
            added_count += static_cast<Index>(added.size());
            Index others = spikes.count;
            for (const Index k : added) others -= spikes.mask.data()[k];
            wrong += others;
        }
        EXPECT_GE(static_cast<double>(found), 0.95 * static_cast<double>(added_count)) << hurst_exponent;
        EXPECT_LE(wrong, 2) << hurst_exponent;
    }
}

TEST(FindSpikes, FindsAlmostNoneOnCleanGaussianSurfaces) {
    Index false_alarms = 0, points = 0;
    for (const double hurst_exponent : {0.1, 0.5, 0.8, 1.0})
        for (std::uint64_t seed = 11; seed <= 13; ++seed) {
            const auto map = self_affine(128, hurst_exponent, seed);
            false_alarms += find_spikes(map).count;
            points += map.heights.size();
        }
    EXPECT_LE(false_alarms, points / 100000);
}

TEST(FindSpikes, FindsNoneInTiltsStepsAndSmoothWaves) {
    std::mt19937 engine(4);
    std::normal_distribution<double> normal(0.0, 1e-10);
    HeightMap map{Array2D(80, 60), {1.0, 1.0}};
    for (Index i = 0; i < 80; ++i)
        for (Index j = 0; j < 60; ++j)
            map.heights(i, j) =
                1e-8 * static_cast<double>(i) + 1e-7 * static_cast<double>(j) + (i > 40 ? 5e-8 : 0.0) + normal(engine);
    EXPECT_EQ(find_spikes(map).count, 0);
    map.heights.block(10, 20, 15, 15) += 3e-7;  // an island with corners
    EXPECT_EQ(find_spikes(map).count, 0);
    EXPECT_EQ(find_spikes(LineScan{map.heights.col(25), 1.0}).count, 0);
    for (Index i = 0; i < 80; ++i)
        for (Index j = 0; j < 60; ++j) map.heights(i, j) = std::sin(0.2 * static_cast<double>(i + j));
    EXPECT_EQ(find_spikes(map).count, 0);
}

TEST(FindSpikes, FindsNoneInStepsOfDigitisedHeights) {
    std::mt19937 engine(6);
    std::normal_distribution<double> normal(0.0, 0.25);
    HeightMap map{Array2D(100, 100), {1.0, 1.0}};
    for (Index k = 0; k < map.heights.size(); ++k) map.heights.data()[k] = 1e-9 * std::round(normal(engine));
    EXPECT_EQ(find_spikes(map).count, 0);
    map.heights(50, 50) += 2e-8;
    EXPECT_EQ(find_spikes(map).count, 1);
}

TEST(FindSpikes, FindsASpikeOnAFlatMapAndNoneOnAConstantMap) {
    HeightMap map{Array2D::Constant(30, 30, 0.25), {1.0, 1.0}};
    EXPECT_EQ(find_spikes(map).count, 0);
    map.heights(10, 12) += 1e-9;
    map.heights(0, 20) += 1e-9;  // on the border too
    const auto spikes = find_spikes(map);
    EXPECT_EQ(spikes.count, 2);
    EXPECT_EQ(spikes.mask(10, 12), 1);
    EXPECT_EQ(spikes.mask(0, 20), 1);
}

TEST(FindSpikes, IgnoresUndefinedPoints) {
    auto map = self_affine(64, 0.8, 3);
    for (Index i = 20; i < 40; ++i) map.heights.row(i).segment(10, 30).setConstant(undefined);
    map.heights(30, 25) = 1.0;  // without surroundings it is no spike
    map.heights(19, 20) += 1e-7;
    const auto spikes = find_spikes(map);
    EXPECT_EQ(spikes.mask(19, 20), 1);
    EXPECT_EQ(spikes.mask(30, 25), 0);
    EXPECT_EQ(spikes.mask(25, 15), 0);
    map.heights.setConstant(undefined);
    EXPECT_THROW((void)find_spikes(map), UndefinedDataError);
}

TEST(FindSpikes, OfALineGivesAOneColumnMask) {
    LineScan scan{Array1D(400), 1.0};
    for (Index i = 0; i < 400; ++i)
        scan.heights[i] = std::sin(0.05 * static_cast<double>(i)) + 0.001 * std::sin(7.0 * static_cast<double>(i));
    scan.heights[33] += 0.5;
    scan.heights[398] -= 0.5;
    const auto spikes = find_spikes(scan);
    EXPECT_EQ(spikes.mask.rows(), 400);
    EXPECT_EQ(spikes.mask.cols(), 1);
    EXPECT_EQ(spikes.count, 2);
    EXPECT_EQ(spikes.mask(33, 0), 1);
    EXPECT_EQ(spikes.mask(398, 0), 1);
}

TEST(FindSpikes, DoesNotDependOnAnOffsetOrTheSign) {
    auto map = self_affine(64, 0.5, 9);
    (void)add_spikes(map, 5e-8, 10, 2);
    const auto spikes = find_spikes(map);
    auto turned = map;
    turned.heights = 0.1 - turned.heights;  // 10⁷ rms
    EXPECT_TRUE((find_spikes(turned).mask == spikes.mask).all());
    EXPECT_NEAR(find_spikes(turned).threshold / spikes.threshold, 1.0, 1e-6);
}

TEST(FindSpikes, GivesTheSameForAnyNumberOfThreads) {
    auto map = self_affine(128, 0.5, 9);
    (void)add_spikes(map, 5e-8, 10, 2);
    const auto one = find_spikes(map, {}, {1}), three = find_spikes(map, {}, {3});
    EXPECT_TRUE((one.mask == three.mask).all());
    EXPECT_EQ(one.threshold, three.threshold);
}

TEST(Despike, ReplacesSpikesByTheLocalMedian) {
    const auto clean = self_affine(128, 0.8, 5);
    auto map = clean;
    const auto added = add_spikes(map, 8e-8, 20, 3);
    map.heights(60, 60) += 1e-7, map.heights(60, 61) += 1e-7;  // next to each other
    const auto done = apply(Despike{}, map);
    EXPECT_EQ(number_of(done.record, "spikes"), 22.0);
    EXPECT_NEAR(number_of(done.record, "areal_rms_height_before"), rms_of(map.heights), 1e-18);
    EXPECT_NEAR(number_of(done.record, "areal_rms_height_after"), rms_of(clean.heights), 1e-3 * rms_of(clean.heights));
    EXPECT_LT(rms_of(map_of(done).heights - clean.heights), 0.02 * rms_of(clean.heights));
    for (const Index k : added) EXPECT_NE(map_of(done).heights.data()[k], map.heights.data()[k]);
}

TEST(Despike, ReplacesSpikesByUndefinedHeightsOnRequest) {
    auto map = self_affine(64, 0.8, 5);
    map.heights(7, 9) += 1e-6;
    const auto done = apply(Despike{.replace_by = SpikeReplacement::undefined}, map);
    EXPECT_EQ(map_of(done).heights.isNaN().count(), 1);
    EXPECT_TRUE(std::isnan(map_of(done).heights(7, 9)));
}

TEST(Despike, RefusesInvalidParameters) {
    const auto map = self_affine(64, 0.8, 5);
    EXPECT_THROW((void)apply(Despike{.threshold = 0.0}, map), InvalidArgument);
    EXPECT_THROW((void)apply(Despike{.reach = 0}, map), InvalidArgument);
    EXPECT_THROW((void)apply(Despike{.reach = 11}, map), InvalidArgument);
    EXPECT_THROW((void)apply(Despike{}, topography::Profile{Array1D::LinSpaced(5, 0.0, 1.0), Array1D::Zero(5), {}}),
                 InvalidArgument);
    EXPECT_EQ(find_spikes(LineScan{Array1D::Random(2), 1.0}).count, 0);
    EXPECT_EQ(find_spikes(HeightMap{Array2D::Random(1, 9), {1.0, 1.0}}).count, 0);
}

}  // namespace
}  // namespace setae::processing::despike_test
