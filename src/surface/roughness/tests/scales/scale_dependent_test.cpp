// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/scales/scale_dependent.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "brute_force.hpp"
#include "samples.hpp"
#include "setae/core/errors.hpp"
#include "setae/scales/autocorrelation.hpp"

namespace setae::scales::scale_dependent_test {
namespace {

using namespace setae::tests;
using namespace setae::scales::tests;
using topography::HeightMap;
using topography::LineScan;
using topography::Profile;

Array1D list(std::initializer_list<double> values) {
    return Eigen::Map<const Array1D>(values.begin(), static_cast<Index>(values.size()));
}

/// Every difference of a line by the definition, with heights between points on straight lines.
std::vector<double> differences_of(const LineScan& scan, int order, double distance) {
    const double s = distance / order / scan.pixel_size();
    const Index n = scan.heights.size();
    const std::vector<std::pair<int, double>> stencil =
        order == 1   ? std::vector<std::pair<int, double>>{{0, -1.0}, {1, 1.0}}
        : order == 2 ? std::vector<std::pair<int, double>>{{-1, 1.0}, {0, -2.0}, {1, 1.0}}
                     : std::vector<std::pair<int, double>>{{-1, -1.0}, {0, 3.0}, {1, -3.0}, {2, 1.0}};
    std::vector<double> result;
    for (Index i = 0; i < n; ++i) {
        double sum = 0.0;
        bool inside = true;
        for (const auto& [place, coefficient] : stencil) {
            double x = static_cast<double>(i) + place * s;
            if (std::abs(x - std::round(x)) < 1e-9) x = std::round(x);
            if (!scan.periodic && (x < 0.0 || x > static_cast<double>(n - 1))) inside = false;
            const double floor = std::floor(x), share = x - floor;
            const auto at = [&](double place_of) { return scan.heights[((static_cast<Index>(place_of) % n) + n) % n]; };
            if (!inside) break;
            sum += coefficient * (share > 0.0 ? (1.0 - share) * at(floor) + share * at(floor + 1.0) : at(floor));
        }
        if (inside && !std::isnan(sum)) result.push_back(sum / std::pow(distance / order, order));
    }
    return result;
}

void expect_statistics(const DifferenceStatistics& found, Index k, const std::vector<double>& differences) {
    const Eigen::Map<const Array1D> all(differences.data(), static_cast<Index>(differences.size()));
    const double mean = all.mean(), variance = (all - mean).square().mean();
    EXPECT_EQ(found.count[k], static_cast<double>(differences.size()));
    EXPECT_NEAR(found.mean[k], mean, 1e-12 * std::sqrt(all.square().mean()));
    EXPECT_NEAR(found.rms[k] / std::sqrt(all.square().mean()), 1.0, 1e-12);
    EXPECT_NEAR(found.variance[k] / variance, 1.0, 1e-11);
    EXPECT_NEAR(found.skewness[k], (all - mean).cube().mean() / std::pow(variance, 1.5), 1e-10);
    EXPECT_NEAR(found.kurtosis[k], (all - mean).square().square().mean() / (variance * variance), 1e-10);
    EXPECT_NEAR(found.minimum[k], all.minCoeff(), 1e-12 * std::abs(all.minCoeff()));
    EXPECT_NEAR(found.maximum[k], all.maxCoeff(), 1e-12 * std::abs(all.maxCoeff()));
}

TEST(Differences, OfLinesMatchTheDefinition) {
    for (const bool periodic : {false, true})
        for (const bool holes : {false, true})
            for (const int order : {1, 2, 3}) {
                LineScan scan{random_heights(61), 6.1, periodic, {}};
                if (holes) scan.heights[7] = scan.heights[30] = undefined;
                const Array1D distances = list({0.3, 0.6, 0.75, 1.5, 2.1});
                const auto found = difference_statistics(scan, {.order = order, .distances = distances});
                ASSERT_EQ(found.distance.size(), distances.size());
                for (Index k = 0; k < distances.size(); ++k)
                    expect_statistics(found, k, differences_of(scan, order, distances[k]));
            }
}

TEST(Differences, OfMapsEqualThoseOfTheirLines) {
    for (const bool periodic : {false, true})
        for (const int order : {1, 2, 3}) {
            const HeightMap map = with_holes({random_map(34, 41), {3.4, 8.2}, periodic, {}});
            const Array1D distances = list({0.6, 1.25});
            const auto along_x =
                difference_statistics(map, {.order = order, .along = Along::x, .distances = distances});
            const auto along_y =
                difference_statistics(map, {.order = order, .along = Along::y, .distances = distances});
            for (Index k = 0; k < 2; ++k) {
                std::vector<double> of_x, of_y;
                for (Index j = 0; j < 41; ++j)
                    for (const double d : differences_of({map.heights.col(j), 3.4, periodic, {}}, order, distances[k]))
                        of_x.push_back(d);
                for (Index i = 0; i < 34; ++i)
                    for (const double d : differences_of({map.heights.row(i), 8.2, periodic, {}}, order, distances[k]))
                        of_y.push_back(d);
                expect_statistics(along_x, k, of_x);
                expect_statistics(along_y, k, of_y);
            }
        }
}

TEST(Differences, ExcludeOnlyThoseThatUseAHole) {
    HeightMap map{random_map(12, 12), {12.0, 12.0}, true, {}};
    map.heights(5, 6) = undefined;
    EXPECT_EQ(difference_statistics(map, {.distances = list({1.0})}).count[0], 144.0 - 2.0);
    EXPECT_EQ(difference_statistics(map, {.along = Along::y, .distances = list({1.0})}).count[0], 144.0 - 2.0);
    EXPECT_EQ(difference_statistics(map, {.along = Along::both, .distances = list({1.0})}).count[0], 144.0 - 3.0);
    EXPECT_EQ(difference_statistics(map, {.order = 2, .distances = list({2.0})}).count[0], 144.0 - 3.0);
    EXPECT_EQ(difference_statistics(map, {.distances = list({1.5})}).count[0], 144.0 - 3.0);
}

TEST(Differences, DoNotUseMaskedValues) {
    // the value under a hole is NaN: no difference may use a neighbour of weight zero
    LineScan scan{Array1D::LinSpaced(9, 0.0, 8.0), 9.0, false, {}};
    scan.heights[4] = undefined;
    const auto found = difference_statistics(scan, {.distances = list({1.0, 2.0})});
    EXPECT_EQ(found.count[0], 6.0);
    EXPECT_EQ(found.count[1], 5.0);
    EXPECT_NEAR(found.rms[0], 1.0, 1e-15);
}

TEST(Differences, BothDirectionsAreGradientAndMeanCurvatureAtCommonPoints) {
    const HeightMap map{random_map(20, 17), {2.0, 1.7}, false, {}};
    const auto gradient = difference_statistics(map, {.along = Along::both, .distances = list({0.3})});
    const auto curvature = difference_statistics(map, {.order = 2, .along = Along::both, .distances = list({0.4})});
    double squares = 0.0, curvatures = 0.0, count = 0.0, curvature_count = 0.0;
    for (Index i = 0; i < 20; ++i)
        for (Index j = 0; j < 17; ++j) {
            const auto& h = map.heights;
            if (i + 3 < 20 && j + 3 < 17) {
                squares += (std::pow(h(i + 3, j) - h(i, j), 2) + std::pow(h(i, j + 3) - h(i, j), 2)) / 0.09;
                count += 1.0;
            }
            if (i >= 2 && j >= 2 && i + 2 < 20 && j + 2 < 17) {
                curvatures +=
                    std::pow(0.5 * (h(i + 2, j) + h(i - 2, j) + h(i, j + 2) + h(i, j - 2) - 4.0 * h(i, j)) / 0.04, 2);
                curvature_count += 1.0;
            }
        }
    EXPECT_NEAR(gradient.rms[0], std::sqrt(squares / count), 1e-12);
    EXPECT_EQ(gradient.count[0], count);
    EXPECT_NEAR(curvature.rms[0] / std::sqrt(curvatures / curvature_count), 1.0, 1e-12);
    EXPECT_EQ(curvature.count[0], curvature_count);
}

TEST(Differences, SlopeOfASineIsTheSlopeOfItsChords) {
    const Index n = 400;
    const double q = 2.0 * pi * 4.0, amplitude = 0.7;
    const LineScan scan{
        amplitude * (q * Array1D::LinSpaced(n, 0.0, 1.0 - 1.0 / static_cast<double>(n))).sin(), 1.0, true, {}};
    const auto found = difference_statistics(scan, {.distances = list({0.01, 0.05, 0.1, 0.2})});
    for (Index k = 0; k < found.distance.size(); ++k) {
        const double r = found.distance[k];
        EXPECT_NEAR(found.rms[k], amplitude * std::sqrt(1.0 - std::cos(q * r)) / r, 1e-12);
    }
}

TEST(Differences, OfAParabolaAreConstant) {
    const Array1D x = Array1D::LinSpaced(200, 0.0, 1.99);
    const LineScan scan{1.5 * x.square(), 2.0, false, {}};
    const auto second = difference_statistics(scan, {.order = 2});
    ASSERT_GT(second.distance.size(), 10);
    for (Index k = 0; k < second.distance.size(); ++k) {
        const double steps = 0.5 * second.distance[k] / 0.01;
        if (std::abs(steps - std::round(steps)) > 1e-9) continue;
        EXPECT_NEAR(second.minimum[k], 3.0, 1e-8);
        EXPECT_NEAR(second.maximum[k], 3.0, 1e-8);
    }
    const auto third =
        difference_statistics(LineScan{x.cube(), 2.0, false, {}}, {.order = 3, .distances = list({0.03, 0.3})});
    EXPECT_NEAR(third.mean[1], 6.0, 1e-9);
    EXPECT_NEAR(third.rms[0], 6.0, 1e-5);
}

TEST(Differences, AtFractionsOfAStepAreExactOnPlanes) {
    HeightMap plane{Array2D(20, 20), {2.0, 2.0}, false, {}};
    for (Index i = 0; i < 20; ++i)
        for (Index j = 0; j < 20; ++j)
            plane.heights(i, j) = 0.3 * 0.1 * static_cast<double>(i) - 0.4 * 0.1 * static_cast<double>(j) + 7.0;
    for (const double distance : {0.1, 0.137, 0.5, 0.777}) {
        const auto gradient = difference_statistics(plane, {.along = Along::both, .distances = list({distance})});
        EXPECT_NEAR(gradient.minimum[0], 0.5, 1e-13);
        EXPECT_NEAR(gradient.maximum[0], 0.5, 1e-13);
        const auto curvature =
            difference_statistics(plane, {.order = 2, .along = Along::both, .distances = list({distance})});
        EXPECT_LT(curvature.maximum[0], 1e-11);
    }
}

TEST(Differences, TrimOnlyTheReachOfTheStencil) {
    const HeightMap map{random_map(24, 16), {24.0, 16.0}, false, {}};
    EXPECT_EQ(difference_statistics(map, {.distances = list({3.0})}).count[0], 21.0 * 16.0);
    EXPECT_EQ(difference_statistics(map, {.distances = list({2.5})}).count[0], 21.0 * 16.0);
    EXPECT_EQ(difference_statistics(map, {.along = Along::both, .distances = list({3.0})}).count[0], 21.0 * 13.0);
    EXPECT_EQ(difference_statistics(map, {.order = 2, .distances = list({6.0})}).count[0], 18.0 * 16.0);
    EXPECT_EQ(difference_statistics(map, {.order = 3, .along = Along::y, .distances = list({9.0})}).count[0],
              24.0 * 7.0);
}

TEST(Differences, VarianceIsTwiceTheAutocorrelationOverTheSquaredDistance) {
    const LineScan scan{walk(random_heights(128)), 1.28, true, {}};
    const auto A = autocorrelation(scan);
    const auto slopes = difference_statistics(scan, {.distances = A.distance});
    EXPECT_LT((slopes.rms.square() / (2.0 * A.value / A.distance.square()) - 1.0).abs().maxCoeff(), 1e-10);
    const auto curvature = difference_statistics(scan, {.order = 2, .distances = Array1D(2.0 * A.distance.head(32))});
    for (Index k = 0; k < 32; ++k) {
        const double step = A.distance[k];
        EXPECT_NEAR(
            curvature.rms[k] * curvature.rms[k] * std::pow(step, 4) / (8.0 * A.value[k] - 2.0 * A.value[2 * k + 1]),
            1.0, 1e-9);
    }
}

TEST(Differences, KeepPrecisionAtOffsets) {
    LineScan lifted{random_heights(500), 5.0, false, {}};
    lifted.heights += 1e7;
    LineScan centred = lifted;
    centred.heights -= 1e7;
    for (const int order : {1, 2, 3}) {
        const Array1D distances = list({0.06, 0.25});
        const auto with = difference_statistics(lifted, {.order = order, .distances = distances});
        const auto without = difference_statistics(centred, {.order = order, .distances = distances});
        EXPECT_LT((with.rms / without.rms - 1.0).abs().maxCoeff(), 1e-9);
        EXPECT_LT((with.kurtosis / without.kurtosis - 1.0).abs().maxCoeff(), 1e-9);
    }
}

TEST(Differences, StatisticsAreUnaffectedByATiltOfAMillionRms) {
    LineScan scan{random_heights(500), 5.0, false, {}};
    const auto level = difference_statistics(scan, {.distances = list({0.5})});
    scan.heights += 1e6 * Array1D::LinSpaced(500, 0.0, 4.99);
    const auto tilted = difference_statistics(scan, {.distances = list({0.5})});
    EXPECT_NEAR(tilted.variance[0] / level.variance[0], 1.0, 1e-7);
    EXPECT_NEAR(tilted.kurtosis[0] / level.kurtosis[0], 1.0, 1e-7);
    EXPECT_NEAR(tilted.mean[0], 1e6 + level.mean[0], 1e-8);
}

TEST(Differences, ByFourierInterpolationOfASineAreExactAtAnyDistance) {
    const Index n = 64;
    const double q = 2.0 * pi * 5.0;
    const LineScan scan{(q * Array1D::LinSpaced(n, 0.0, 1.0 - 1.0 / static_cast<double>(n))).sin(), 1.0, true, {}};
    HeightMap map{Array2D(n, 8), {1.0, 1.0}, true, {}};
    map.heights.colwise() = scan.heights;
    for (const double r : {0.01, 0.033, 0.2}) {
        const DifferenceOptions options{.interpolation = Interpolation::fourier, .distances = list({r})};
        const double expected = std::sqrt(1.0 - std::cos(q * r)) / r;
        EXPECT_NEAR(difference_statistics(scan, options).rms[0], expected, 1e-11);
        EXPECT_NEAR(difference_statistics(map, options).rms[0], expected, 1e-11);
        const DifferenceOptions second{
            .order = 2, .interpolation = Interpolation::fourier, .distances = list({2.0 * r})};
        EXPECT_NEAR(difference_statistics(scan, second).rms[0],
                    std::sqrt(0.5) * 2.0 * (1.0 - std::cos(q * r)) / (r * r), 1e-9);
    }
}

TEST(Differences, ByFourierInterpolationAtWholeStepsEqualPointDifferences) {
    const HeightMap map{random_map(24, 15), {2.4, 1.5}, true, {}};
    for (const Along along : {Along::x, Along::y})
        for (const int order : {1, 2, 3}) {
            DifferenceOptions options{.order = order, .along = along, .distances = list({0.1 * order, 0.3 * order})};
            const auto linear = difference_statistics(map, options);
            options.interpolation = Interpolation::fourier;
            EXPECT_LT((difference_statistics(map, options).rms / linear.rms - 1.0).abs().maxCoeff(), 1e-12);
        }
}

TEST(Differences, DefaultDistancesAreTheSameForAllMeasurements) {
    const auto small = difference_statistics(LineScan{random_heights(100), 1.0, false, {}});
    const auto large = difference_statistics(LineScan{random_heights(333), 7.0, false, {}});
    for (const double distance : small.distance) {
        const double tenth = 10.0 * std::log10(distance);
        EXPECT_NEAR(tenth, std::round(tenth), 1e-9);
        if (distance >= large.distance[0]) {
            EXPECT_NEAR((large.distance - distance).abs().minCoeff(), 0.0, 1e-12);
        }
    }
    EXPECT_GE(small.distance[0], 0.01 * (1.0 - 1e-9));
    EXPECT_LE(difference_statistics(LineScan{random_heights(100), 1.0, true, {}}).distance.maxCoeff(),
              0.5 * (1.0 + 1e-6));
}

TEST(Differences, PassedRowByRowMatchTheStatistics) {
    const HeightMap map = with_holes({random_map(12, 15), {1.2, 1.5}, false, {}});
    const DifferenceOptions options{.along = Along::y};
    double squares = 0.0, count = 0.0;
    Index previous = -1;
    for_each_row_of_differences(map, 0.25, options, [&](Index row, Index first, const ArrayView1D& values) {
        EXPECT_EQ(row, previous + 1);
        EXPECT_EQ(first, 0);
        EXPECT_EQ(values.size(), 12);
        previous = row;
        for (const double value : values)
            if (!std::isnan(value)) {
                squares += value * value;
                count += 1.0;
            }
    });
    const auto found = difference_statistics(map, {.along = Along::y, .distances = list({0.25})});
    EXPECT_EQ(found.count[0], count);
    EXPECT_NEAR(found.rms[0], std::sqrt(squares / count), 1e-13);
}

TEST(Differences, OfPolylinesAreExactIntegrals) {
    const auto profile = random_profile(40);
    for (const int order : {1, 2, 3}) {
        const double distance = 4.7, s = distance / order;
        const auto found = difference_statistics(profile, {.order = order, .distances = list({distance})});
        const double begin = profile.positions[0] + (order == 1 ? 0.0 : s),
                     end = profile.positions[39] - (order == 3 ? 2.0 : 1.0) * s;
        const Index steps = 40000;
        Array1D g(steps);
        for (Index k = 0; k < steps; ++k) {
            const double x = begin + (end - begin) * (static_cast<double>(k) + 0.5) / static_cast<double>(steps);
            const auto h = [&](double places) { return height_at(profile, x + places * s); };
            g[k] = order == 1   ? h(1) - h(0)
                   : order == 2 ? h(-1) - 2.0 * h(0) + h(1)
                                : -h(-1) + 3.0 * h(0) - 3.0 * h(1) + h(2);
        }
        g /= std::pow(s, order);
        const double mean = g.mean(), variance = (g - mean).square().mean();
        EXPECT_NEAR(found.count[0], end - begin, 1e-12);
        EXPECT_NEAR(found.mean[0], mean, 1e-4 * std::sqrt(variance));
        EXPECT_NEAR(found.variance[0] / variance, 1.0, 1e-5);
        EXPECT_NEAR(found.skewness[0], (g - mean).cube().mean() / std::pow(variance, 1.5), 1e-4);
        EXPECT_NEAR(found.kurtosis[0], (g - mean).square().square().mean() / (variance * variance), 1e-4);
        EXPECT_NEAR(found.minimum[0], g.minCoeff(), 1e-3 * std::sqrt(variance));
        EXPECT_NEAR(found.maximum[0], g.maxCoeff(), 1e-3 * std::sqrt(variance));
    }
}

TEST(Differences, OfPolylineParabolasFollowThePolyline) {
    const Array1D x = Array1D::LinSpaced(401, 0.0, 2.0);
    const auto found =
        difference_statistics(Profile{x, 1.5 * x.square(), {}}, {.order = 2, .distances = list({0.1, 0.5, 1.0})});
    for (const double mean : found.mean) EXPECT_NEAR(mean, 3.0, 1e-9);
}

TEST(Differences, RefuseInvalidOptions) {
    const LineScan line{random_heights(20), 2.0, false, {}};
    const HeightMap map{random_map(8, 8), {1.0, 1.0}, false, {}};
    EXPECT_THROW((void)difference_statistics(line, {.order = 4}), InvalidArgument);
    EXPECT_THROW((void)difference_statistics(line, {.order = 0}), InvalidArgument);
    EXPECT_THROW((void)difference_statistics(line, {.along = Along::y}), InvalidArgument);
    EXPECT_THROW((void)difference_statistics(map, {.order = 3, .along = Along::both}), InvalidArgument);
    EXPECT_THROW((void)difference_statistics(line, {.distances = list({-1.0})}), InvalidArgument);
    EXPECT_THROW((void)difference_statistics(line, {.distances = list({undefined})}), InvalidArgument);
    EXPECT_THROW((void)difference_statistics(line, {.distances = list({2.5})}), InvalidArgument);
    EXPECT_THROW((void)difference_statistics(line, {.interpolation = Interpolation::fourier}), InvalidArgument);
    EXPECT_THROW((void)difference_statistics(LineScan{Array1D::Constant(20, undefined), 2.0, false, {}}),
                 InvalidArgument);
    HeightMap holed = with_holes({random_map(12, 12), {1.0, 1.0}, true, {}});
    EXPECT_THROW((void)difference_statistics(holed, {.interpolation = Interpolation::fourier}), UndefinedDataError);
    auto reentrant = random_profile(20);
    reentrant.positions[4] = reentrant.positions[6];
    EXPECT_THROW((void)difference_statistics(reentrant), InvalidArgument);
}

TEST(Differences, OfATransposedMapAreExchanged) {
    const HeightMap map = with_holes({random_map(30, 21), {3.0, 4.2}, false, {}}),
                    turned{map.heights.transpose(), {4.2, 3.0}, false, {}};
    for (const auto& [here, there] :
         {std::pair{Along::x, Along::y}, {Along::y, Along::x}, {Along::both, Along::both}}) {
        const auto a = difference_statistics(map, {.along = here, .distances = list({0.6})}),
                   b = difference_statistics(turned, {.along = there, .distances = list({0.6})});
        EXPECT_NEAR(a.rms[0], b.rms[0], 1e-12);
        EXPECT_EQ(a.count[0], b.count[0]);
    }
}

TEST(Differences, OfConstantHeightsAreZeroWithoutAShape) {
    const auto found =
        difference_statistics(LineScan{Array1D::Constant(20, 4.0), 2.0, false, {}}, {.distances = list({0.5})});
    EXPECT_EQ(found.rms[0], 0.0);
    EXPECT_NE(found.kurtosis[0], found.kurtosis[0]);
}

TEST(Differences, OfOneRowOrColumnEqualThoseOfALine) {
    const Array1D heights = random_heights(30);
    const HeightMap row{heights.transpose(), {1.0, 3.0}, false, {}}, column{heights, {3.0, 1.0}, false, {}};
    const auto line = difference_statistics(LineScan{heights, 3.0, false, {}}, {.distances = list({0.2})});
    EXPECT_EQ(difference_statistics(row, {.along = Along::y, .distances = list({0.2})}).rms[0], line.rms[0]);
    EXPECT_NEAR(difference_statistics(column, {.distances = list({0.2})}).rms[0], line.rms[0], 1e-14);
}

TEST(Differences, HaveTheSameBytesForAnyNumberOfThreads) {
    const HeightMap map = with_holes({random_map(150, 90), {1.5, 0.9}, false, {}});
    for (const Along along : {Along::x, Along::y, Along::both}) {
        const auto one = difference_statistics(map, {.along = along, .threads = {1}}),
                   three = difference_statistics(map, {.along = along, .threads = {3}});
        EXPECT_TRUE((one.rms == three.rms).all() && (one.skewness == three.skewness).all());
    }
}

TEST(Differences, AreNamedByOrderAndStatistic) {
    const LineScan line{random_heights(40), 4.0, false, {}};
    EXPECT_EQ(function_of(difference_statistics(line), Statistic::rms).quantity, "rms_slope");
    const auto curvature = function_of(difference_statistics(line, {.order = 2}), Statistic::variance);
    EXPECT_EQ(curvature.quantity, "variance_curvature");
    EXPECT_EQ(curvature.unit, "1/m2");
    EXPECT_EQ(function_of(difference_statistics(line, {.order = 3}), Statistic::kurtosis).unit, "1");
    EXPECT_EQ(statistic_from_name("kurtosis"), Statistic::kurtosis);
    EXPECT_THROW((void)statistic_from_name("median"), InvalidArgument);
    EXPECT_EQ(along_from_name("both"), Along::both);
    EXPECT_THROW((void)along_from_name("z"), InvalidArgument);
}

}  // namespace
}  // namespace setae::scales::scale_dependent_test
