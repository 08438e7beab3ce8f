// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/scales/autocorrelation.hpp"

#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "brute_force.hpp"
#include "samples.hpp"
#include "setae/core/errors.hpp"

namespace setae::scales::autocorrelation_test {
namespace {

using namespace setae::tests;
using namespace setae::scales::tests;
using topography::HeightMap;
using topography::LineScan;
using topography::Profile;

/// For every distance of a result, by the double loop.
void expect_pairs_of_lines(const FunctionOfScale& result, const HeightMap& map, double tolerance) {
    ASSERT_GT(result.distance.size(), 0);
    for (Index k = 0; k < result.distance.size(); ++k) {
        const auto lag = static_cast<Index>(std::lround(result.distance[k] / map.pixel_size()[0]));
        EXPECT_NEAR(result.value[k] / pair_mean(map, lag, 0), 1.0, tolerance) << "lag " << lag;
    }
}

TEST(Autocorrelation, OfACosineIsOneMinusCosine) {
    const Index n = 240;
    const double q = 2.0 * pi * 5.0 / 12.0, amplitude = 0.3;
    const Array1D x = Array1D::LinSpaced(n, 0.0, 12.0 * (1.0 - 1.0 / static_cast<double>(n)));
    const auto result = autocorrelation(LineScan{amplitude * (q * x).cos(), 12.0, true, {}});
    EXPECT_EQ(result.distance.size(), n / 2);
    const Array1D expected = 0.5 * amplitude * amplitude * (1.0 - (q * result.distance).cos());
    EXPECT_LT((result.value - expected).abs().maxCoeff(), 1e-15);
}

TEST(Autocorrelation, OfAnImpulseIsTheShareOfPairsThatContainIt) {
    LineScan scan{Array1D::Zero(9), 9.0, false, {}};
    scan.heights[3] = 2.0;
    const auto result = autocorrelation(scan);
    for (Index k = 1; k < 9; ++k) {
        const double seen = (3 + k < 9 ? 1.0 : 0.0) + (3 - k >= 0 ? 1.0 : 0.0);
        EXPECT_NEAR(result.value[k - 1], 0.5 * 4.0 * seen / static_cast<double>(9 - k), 1e-15);
        EXPECT_EQ(result.count[k - 1], static_cast<double>(9 - k));
    }
}

TEST(Autocorrelation, OfAStepIsHalfTheShareOfPairsAcrossIt) {
    LineScan scan{Array1D::Zero(12), 12.0, false, {}};
    scan.heights.tail(6) = 1.0;
    const auto result = autocorrelation(scan);
    for (Index k = 1; k <= 6; ++k)
        EXPECT_NEAR(result.value[k - 1], 0.5 * static_cast<double>(k) / static_cast<double>(12 - k), 1e-15);
}

TEST(Autocorrelation, OfUncorrelatedHeightsIsTheirVariance) {
    const auto result = autocorrelation(LineScan{random_heights(100000), 1.0, true, {}});
    EXPECT_NEAR(result.value.mean(), 1.0, 0.02);
    EXPECT_NEAR(result.value[0], 1.0, 0.02);
}

TEST(Autocorrelation, OfALineIsTheMeanOverItsPairs) {
    for (const bool periodic : {false, true})
        for (const Index n : {2, 3, 31, 64, 97}) {
            const LineScan scan{random_heights(n), 2.0, periodic, {}};
            expect_pairs_of_lines(autocorrelation(scan), as_map(scan), 1e-11);
        }
}

TEST(Autocorrelation, OfLinesIsTheMeanOverPairsOfAllLines) {
    for (const bool periodic : {false, true}) {
        const HeightMap map{random_map(24, 35), {6.0, 3.2}, periodic, {}};
        expect_pairs_of_lines(autocorrelation_of_lines(map), map, 1e-11);
    }
}

TEST(Autocorrelation, WithHolesUsesPairsOfDefinedPoints) {
    for (const bool periodic : {false, true}) {
        auto map = with_holes({random_map(19, 21), {6.0, 3.2}, periodic, {}});
        expect_pairs_of_lines(autocorrelation_of_lines(map), map, 1e-11);
        map.heights.col(5) = undefined;
        expect_pairs_of_lines(autocorrelation_of_lines(map), map, 1e-11);
    }
    LineScan scan{random_heights(20), 1.0, false, {}};
    scan.heights.segment(1, 17) = undefined;  // points 0, 18 and 19 are left: lags 1, 18, 19
    const auto result = autocorrelation(scan);
    ASSERT_EQ(result.distance.size(), 3);
    EXPECT_NEAR(result.distance[1], 18.0 / 20.0, 1e-15);
    EXPECT_NEAR(result.value[1], 0.5 * std::pow(scan.heights[18] - scan.heights[0], 2), 1e-14);
}

TEST(Autocorrelation, KeepsNineDigitsAtOffsetsOfTenMillionRms) {
    const Array2D heights = random_map(64, 64);
    for (const bool periodic : {false, true}) {
        const HeightMap map{heights, {1.0, 1.0}, periodic, {}};
        HeightMap lifted = map;
        lifted.heights += 1e7;
        lifted.heights -= 1e7;  // the digits lost by the offset in storage are no error of the analysis
        HeightMap offset = lifted;
        offset.heights += 1e7;
        const auto area = autocorrelation_of_area(lifted), area_offset = autocorrelation_of_area(offset);
        EXPECT_LT((area_offset.value / area.value - 1.0).abs().maxCoeff(), 1e-9);
        const auto lines = autocorrelation_of_lines(lifted), lines_offset = autocorrelation_of_lines(offset);
        EXPECT_LT((lines_offset.value / lines.value - 1.0).abs().maxCoeff(), 1e-9);
        expect_pairs_of_lines(lines_offset, offset, 1e-9);
        auto holed = with_holes(offset);
        expect_pairs_of_lines(autocorrelation_of_lines(holed), holed, 1e-9);
    }
}

TEST(Autocorrelation, OfAConstantIsZero) {
    const HeightMap map{Array2D::Constant(8, 9, 3.0), {1.0, 1.0}, false, {}};
    EXPECT_EQ(autocorrelation_of_lines(map).value.abs().maxCoeff(), 0.0);
    EXPECT_EQ(autocorrelation_of_area(map).value.abs().maxCoeff(), 0.0);
}

TEST(Autocorrelation, OfUndefinedHeightsIsAnError) {
    EXPECT_THROW((void)autocorrelation(LineScan{Array1D::Constant(5, undefined), 1.0, false, {}}), UndefinedDataError);
    EXPECT_THROW((void)autocorrelation_of_area({Array2D::Constant(5, 5, undefined), {1.0, 1.0}, false, {}}),
                 UndefinedDataError);
    EXPECT_THROW((void)autocorrelation(LineScan{Array1D::Zero(1), 1.0, false, {}}), InvalidArgument);
    EXPECT_THROW((void)autocorrelation_of_lines({Array2D::Zero(1, 5), {1.0, 1.0}, false, {}}), InvalidArgument);
    EXPECT_THROW((void)autocorrelation_of_area({Array2D::Zero(1, 5), {1.0, 1.0}, false, {}}), InvalidArgument);
}

TEST(Autocorrelation, OfAnInfiniteHeightIsAnError) {
    HeightMap map{random_map(8, 8), {1.0, 1.0}, false, {}};
    map.heights(3, 3) = std::numeric_limits<double>::infinity();
    EXPECT_THROW((void)autocorrelation_of_lines(map), InvalidArgument);
    EXPECT_THROW((void)autocorrelation_of_area(map), InvalidArgument);
}

TEST(AutocorrelationArea, IsTheMeanOverTheFullCircle) {
    for (const bool periodic : {false, true})
        for (const bool holes : {false, true}) {
            HeightMap map{random_map(14, 11), {1.4, 2.2}, periodic, {}};
            if (holes) map = with_holes(map);
            const auto result = autocorrelation_of_area(map, {5});
            const double longest = periodic ? 0.7 : 1.3;
            Array1D sum = Array1D::Zero(result.distance.size()), lengths = sum, count = sum;
            const spectra::LogGrid grid{5};
            std::map<Index, Index> order;
            for (Index b = 0; b < result.distance.size(); ++b) order[grid.bin_of(result.distance[b])] = b;
            for (Index k = -13; k <= 13; ++k)
                for (Index l = -10; l <= 10; ++l) {
                    if (periodic && (std::abs(k) > 7 || std::abs(l) > 5)) continue;
                    const double length = std::hypot(0.1 * static_cast<double>(k), 0.2 * static_cast<double>(l));
                    const double value = pair_mean(map, k, l);
                    if (length == 0.0 || length > longest * (1.0 + 1e-12) || std::isnan(value)) continue;
                    const Index b = order.at(grid.bin_of(length));
                    sum[b] += value;
                    lengths[b] += length;
                    count[b] += 1.0;
                }
            EXPECT_LT((result.count - count).abs().maxCoeff(), 0.5);
            EXPECT_LT((result.value - sum / count).abs().maxCoeff(), 1e-12);
            EXPECT_LT((result.distance - lengths / count).abs().maxCoeff(), 1e-12);
        }
}

/// cos(q(x ± y)) on a non-periodic map.
HeightMap diagonal_grating(double sign) {
    HeightMap map{Array2D(81, 81),
                  {8.1, 8.1},
                  false,
                  {}};  // eight periods from the first to the last point: each is the other's mirror image
    for (Index i = 0; i < 81; ++i)
        for (Index j = 0; j < 81; ++j)
            map.heights(i, j) = std::cos(2.0 * pi * 0.1 * (static_cast<double>(i) + sign * static_cast<double>(j)));
    return map;
}

TEST(AutocorrelationArea, IsEqualForBothDiagonals) {
    const auto rising = autocorrelation_of_area(diagonal_grating(1.0)),
               falling = autocorrelation_of_area(diagonal_grating(-1.0));
    EXPECT_LT((rising.value - falling.value).abs().maxCoeff(), 1e-12);
}

TEST(AutocorrelationArea, OfADiagonalGratingIsTheAngularMean) {
    HeightMap map{Array2D(16, 16), {16.0, 16.0}, true, {}};
    for (Index i = 0; i < 16; ++i)
        for (Index j = 0; j < 16; ++j) map.heights(i, j) = std::cos(pi / 8.0 * static_cast<double>(i + j));
    const auto result = autocorrelation_of_area(map);
    ASSERT_NEAR(result.distance[1], std::sqrt(2.0),
                1e-14);  // the four diagonal neighbours: 0.1464 along, 0 across the waves
    EXPECT_EQ(result.count[1], 4.0);
    EXPECT_NEAR(result.value[1], 0.25 * (1.0 - std::cos(0.25 * pi)), 1e-14);
}

TEST(AutocorrelationArea, IsInvariantUnderMirroringAndRotation) {
    const Array2D heights = random_map(30, 30);
    const auto as_is = autocorrelation_of_area({heights, {3.0, 3.0}, false, {}});
    const auto mirrored = autocorrelation_of_area({heights.rowwise().reverse(), {3.0, 3.0}, false, {}});
    const auto turned = autocorrelation_of_area({heights.transpose().colwise().reverse(), {3.0, 3.0}, false, {}});
    EXPECT_LT((as_is.value - mirrored.value).abs().maxCoeff(), 1e-13);
    EXPECT_LT((as_is.value - turned.value).abs().maxCoeff(), 1e-13);
}

TEST(Autocorrelation, HasTheSameBytesForAnyNumberOfThreads) {
    for (const bool holes : {false, true}) {
        HeightMap map{random_map(70, 90), {1.0, 1.0}, false, {}};
        if (holes) map = with_holes(map);
        const auto one = autocorrelation_of_area(map, {}, {.threads = {1}}),
                   three = autocorrelation_of_area(map, {}, {.threads = {3}});
        EXPECT_TRUE((one.value == three.value).all());
        const auto line = autocorrelation_of_lines(map, {.threads = {1}}),
                   lines = autocorrelation_of_lines(map, {.threads = {3}});
        EXPECT_TRUE((line.value == lines.value).all());
    }
}

TEST(TiledAutocorrelation, EqualsThatOfTheMapInMemory) {
    for (const bool periodic : {false, true})
        for (const bool holes : {false, true}) {
            HeightMap map{random_map(40, 53), {4.0, 5.3}, periodic, {}};
            map.heights += 1e3;
            if (holes) map = with_holes(map);
            const std::size_t band = 7 * 40 * sizeof(double);
            const auto lines = autocorrelation_of_lines(map),
                       tiled = autocorrelation_of_lines(topography::tiled(map), band);
            EXPECT_LT((tiled.value / lines.value - 1.0).abs().maxCoeff(), 1e-10);
            EXPECT_TRUE((tiled.count == lines.count).all());
            EXPECT_EQ(tiled.reliable_from, lines.reliable_from);
            const auto area = autocorrelation_of_area(map),
                       part = autocorrelation_of_area(topography::tiled(map), 1.0, {}, band);
            ASSERT_LE(part.value.size(), area.value.size());
            for (Index b = 0; b + 1 < part.value.size(); ++b) {
                EXPECT_NEAR(part.value[b] / area.value[b], 1.0, 1e-10);
                EXPECT_NEAR(part.count[b], area.count[b], 1e-9);
                EXPECT_NEAR(part.distance[b], area.distance[b], 1e-12);
            }
        }
}

TEST(TiledAutocorrelation, RefusesDistancesOutsideTheMap) {
    const HeightMap map{random_map(10, 12), {1.0, 1.2}, false, {}};
    EXPECT_THROW((void)autocorrelation_of_area(topography::tiled(map), 0.05), InvalidArgument);
    EXPECT_THROW((void)autocorrelation_of_area(topography::tiled(map), 1.0), InvalidArgument);
}

TEST(TiledAutocorrelation, HasTheReliableRangeOfTheMapInMemory) {
    HeightMap map{1e-3 * random_map(64, 12), {1.0, 0.2}, false, {}};
    map.metadata.instrument.tip_radius = 0.05;
    const auto whole = autocorrelation_of_lines(map),
               tiled = autocorrelation_of_lines(topography::tiled(map), 64 * 5 * sizeof(double));
    EXPECT_GT(whole.reliable_from, map.pixel_size()[0]);
    EXPECT_NEAR(tiled.reliable_from, whole.reliable_from, 1e-6 * whole.reliable_from);
    map.metadata.instrument.resolution = 0.9;
    EXPECT_DOUBLE_EQ(autocorrelation_of_lines(topography::tiled(map)).reliable_from, 0.45);
}

TEST(PolylineAutocorrelation, OfARampIsHalfTheSquareOfItsRise) {
    const Profile ramp{Array1D::LinSpaced(7, 0.0, 3.0), 0.5 * Array1D::LinSpaced(7, 0.0, 3.0), {}};
    const Array1D d = Array1D::LinSpaced(5, 0.3, 2.9);
    EXPECT_LT((autocorrelation(ramp, d).value / (0.5 * (0.5 * d).square()) - 1.0).abs().maxCoeff(), 1e-13);
}

TEST(PolylineAutocorrelation, IsTheExactIntegral) {
    const auto profile = random_profile(40);
    const double length = profile.size();
    const Array1D distances = log_spaced(6, 0.1, 0.9 * length);
    const auto result = autocorrelation(profile, distances);
    for (Index k = 0; k < distances.size(); ++k) {
        const double d = distances[k];
        double sum = 0.0;
        const Index steps = 20000;
        for (Index s = 0; s < steps; ++s) {
            const double x =
                profile.positions[0] + (length - d) * (static_cast<double>(s) + 0.5) / static_cast<double>(steps);
            sum += 0.5 * std::pow(height_at(profile, x + d) - height_at(profile, x), 2);
        }
        EXPECT_NEAR(result.value[k] / (sum / static_cast<double>(steps)), 1.0, 1e-4);
        EXPECT_NEAR(result.count[k], length - d, 1e-12 * length);
    }
}

TEST(PolylineAutocorrelation, IsInvariantUnderCollinearPointsAndOffsets) {
    const auto profile = random_profile(30);
    Profile split{Array1D(59), Array1D(59), {}};
    for (Index k = 0; k < 30; ++k) {
        split.positions[2 * k] = profile.positions[k];
        split.heights[2 * k] = profile.heights[k];
        if (k == 29) break;
        split.positions[2 * k + 1] = 0.3 * profile.positions[k] + 0.7 * profile.positions[k + 1];
        split.heights[2 * k + 1] = 0.3 * profile.heights[k] + 0.7 * profile.heights[k + 1];
    }
    Profile moved = profile;
    moved.positions += 1e3;
    moved.heights += 1e6;
    const Array1D distances = log_spaced(8, 0.1, 20.0);
    const auto as_is = autocorrelation(profile, distances);
    EXPECT_LT((autocorrelation(split, distances).value / as_is.value - 1.0).abs().maxCoeff(), 1e-10);
    EXPECT_LT((autocorrelation(moved, distances).value / as_is.value - 1.0).abs().maxCoeff(), 1e-8);
}

TEST(PolylineAutocorrelation, AgreesWithALineOfEqualStepsUpToThePartialSegments) {
    const LineScan scan{walk(random_heights(2000)), 2000.0, false, {}};
    const Profile profile{Array1D::LinSpaced(2000, 0.0, 1999.0), scan.heights, {}};
    const auto points = autocorrelation(scan);
    const auto integral = autocorrelation(profile, Array1D(points.distance.segment(19, 5)));
    EXPECT_LT((integral.value / points.value.segment(19, 5) - 1.0).abs().maxCoeff(), 0.02);
}

TEST(PolylineAutocorrelation, RefusesInvalidDistancesAndPolylines) {
    const auto profile = random_profile(10);
    for (const double distance : {0.0, -1.0, profile.size(), 2.0 * profile.size()})
        EXPECT_THROW((void)autocorrelation(profile, Array1D::Constant(1, distance)), InvalidArgument);
    auto reentrant = profile;
    reentrant.positions[4] = reentrant.positions[6];
    EXPECT_THROW((void)autocorrelation(reentrant), InvalidArgument);
    auto holed = profile;
    holed.heights[4] = undefined;
    EXPECT_THROW((void)autocorrelation(holed), UndefinedDataError);
    const Profile two{Array1D::LinSpaced(2, 0.0, 1.0), Array1D::LinSpaced(2, 0.0, 1.0), {}};
    EXPECT_NEAR(autocorrelation(two, Array1D::Constant(1, 0.5)).value[0], 0.125, 1e-15);
}

TEST(PolylineAutocorrelation, OfManyDistancesEqualsEachComputedSeparately) {
    const auto profile = random_profile(3000);
    const auto result = autocorrelation(profile, log_spaced(30, 1.0, 2000.0));
    EXPECT_TRUE((result.value > 0.0).all());
    for (const Index i : {0, 15, 29})
        EXPECT_NEAR(autocorrelation(profile, Array1D::Constant(1, result.distance[i])).value[0] / result.value[i], 1.0,
                    1e-12);
}

TEST(Slope, FromAutocorrelationEqualsThatOfDifferences) {
    const LineScan scan{random_heights(50), 5.0, true, {}};
    const auto slope = slope_from_autocorrelation(autocorrelation(scan));
    EXPECT_EQ(slope.quantity, "rms_slope");
    for (Index k = 0; k < slope.distance.size(); ++k) {
        double sum = 0.0;
        for (Index i = 0; i < 50; ++i)
            sum += std::pow((scan.heights[(i + k + 1) % 50] - scan.heights[i]) / slope.distance[k], 2);
        EXPECT_NEAR(slope.value[k], std::sqrt(sum / 50.0), 1e-12);
    }
    EXPECT_THROW((void)slope_from_autocorrelation(slope), InvalidArgument);
}

}  // namespace
}  // namespace setae::scales::autocorrelation_test
