// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/processing/steps.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>

#include "record_number.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/topography/detrend.hpp"

namespace setae::processing::level_test {
namespace {

using topography::HeightMap;
using topography::LineScan;
using topography::Profile;

template <class Height>
HeightMap map_from(Index nx, Index ny, std::array<double, 2> size, Height height) {
    HeightMap map{Array2D(nx, ny), size};
    for (Index i = 0; i < nx; ++i)
        for (Index j = 0; j < ny; ++j)
            map.heights(i, j) = height(size[0] * static_cast<double>(i) / static_cast<double>(nx),
                                       size[1] * static_cast<double>(j) / static_cast<double>(ny));
    return map;
}

HeightMap noise(Index nx, Index ny, unsigned seed) {
    std::mt19937 engine(seed);
    std::normal_distribution<double> normal;
    return map_from(nx, ny, {3e-6, 2e-6}, [&](double, double) { return 1e-8 * normal(engine); });
}

double largest(const Array2D& heights) { return heights.isNaN().select(0.0, heights).abs().maxCoeff(); }

TEST(LevelPlane, RecoversSlopesOfAPlaneTo1e10) {
    const auto level = apply(LevelPlane{}, map_from(37, 64, {3e-6, 2e-6},
                                                    [](double x, double y) { return 5e-7 + 0.0123 * x - 0.0456 * y; }));
    EXPECT_NEAR(number_of(level.record, "removed_slope_x"), 0.0123, 1e-10 * 0.0123);
    EXPECT_NEAR(number_of(level.record, "removed_slope_y"), -0.0456, 1e-10 * 0.0456);
    EXPECT_LT(largest(map_of(level).heights), 1e-20);
}

TEST(LevelPolynomial, RecoversRadiiOfAParaboloidTo1e10) {
    // about the middle between first and last points, where slopes are means over the field
    const double cx = 0.5 * 3e-6 * 36.0 / 37.0, cy = 0.5 * 2e-6 * 63.0 / 64.0;
    const auto level = apply(LevelPolynomial{}, map_from(37, 64, {3e-6, 2e-6}, [&](double x, double y) {
                                 return 4e-7 + 0.02 * (x - cx) + 0.5 * (x - cx) * (x - cx) / 1e-4 -
                                        0.5 * (y - cy) * (y - cy) / 3e-4 + 100.0 * (x - cx) * (y - cy);
                             }));
    EXPECT_NEAR(number_of(level.record, "removed_radius_x"), 1e-4, 1e-14);
    EXPECT_NEAR(number_of(level.record, "removed_radius_y"), -3e-4, 3e-14);
    EXPECT_NEAR(number_of(level.record, "removed_slope_x"), 0.02, 2e-12);
    EXPECT_NEAR(number_of(level.record, "removed_slope_y"), 0.0, 1e-12);
    EXPECT_LT(largest(map_of(level).heights), 1e-19);
}

TEST(LevelPolynomial, RecoversTheRadiusOfASphereWithinOnePercent) {
    constexpr double radius = 2e-5;
    const auto level =
        apply(LevelPolynomial{}, map_from(50, 50, {3e-6, 3e-6}, [](double x, double y) {
                  return std::sqrt(radius * radius - std::pow(x - 1.47e-6, 2) - std::pow(y - 1.47e-6, 2)) - radius;
              }));
    EXPECT_NEAR(number_of(level.record, "removed_radius_x") / radius, -1.0, 0.01);
    EXPECT_NEAR(number_of(level.record, "removed_radius_y") / radius, -1.0, 0.01);
}

TEST(LevelPolynomial, OfDegreeTwelveRemovesAPolynomialOfDegreeTwelve) {
    const auto height = [](double x, double y) {
        const double u = x / 1.5e-6 - 1.0, v = y / 1e-6 - 1.0;
        return 1e-7 * (std::pow(u, 12) * std::pow(v, 11) - std::pow(v, 12) + std::pow(u, 7));
    };
    const auto level = apply(LevelPolynomial{.degree = 24}, map_from(61, 70, {3e-6, 2e-6}, height));
    EXPECT_LT(largest(map_of(level).heights), 1e-7 * 1e-11);
}

TEST(LevelPolynomial, LimitsDegreesOfEachDirection) {
    const auto height = [](double x, double y) { return 1e-7 + 0.1 * x + 1e4 * x * x + 0.2 * y + 1e4 * y * y; };
    const auto level =
        apply(LevelPolynomial{.degree = 3, .degree_x = 2, .degree_y = 1}, map_from(40, 40, {3e-6, 3e-6}, height));
    // the rest is y² minus its best straight line
    Array1D y2(40);
    for (Index j = 0; j < 40; ++j) y2[j] = 1e4 * std::pow(3e-6 * static_cast<double>(j) / 40.0, 2);
    const auto expected = topography::detrended(LineScan{y2, 3e-6}, topography::Trend::tilt);
    for (Index i = 0; i < 40; ++i)
        EXPECT_LT((map_of(level).heights.row(i).transpose() - expected.heights).abs().maxCoeff(), 1e-19);
}

TEST(LevelPolynomial, LeavesAResidualOrthogonalToEveryTerm) {
    auto map = noise(31, 45, 7);
    for (Index k = 0; k < 200; ++k) map.heights((13 * k) % 31, (7 * k) % 45) = undefined;
    const auto level = apply(LevelPolynomial{.degree = 4}, map);
    for (int a = 0; a <= 4; ++a)
        for (int b = 0; a + b <= 4; ++b) {
            double product = 0.0, norm = 0.0;
            for (Index i = 0; i < 31; ++i)
                for (Index j = 0; j < 45; ++j) {
                    const double h = map_of(level).heights(i, j),
                                 term = std::pow(static_cast<double>(i) / 15.0 - 1.0, a) *
                                        std::pow(static_cast<double>(j) / 22.0 - 1.0, b);
                    if (std::isnan(h)) continue;
                    product += h * term;
                    norm += std::fabs(h * term);
                }
            EXPECT_LT(std::fabs(product), 1e-12 * norm) << a << " " << b;
        }
}

TEST(LevelPolynomial, EqualsTheParabolaOfDetrend) {
    auto map = noise(20, 33, 3);
    map.heights(4, 5) = undefined;
    const auto ours = map_of(apply(LevelPolynomial{}, map)),
               theirs = topography::detrended(map, topography::Trend::parabola);
    EXPECT_LT(largest(ours.heights - theirs.heights), 1e-20);
    LineScan scan{map.heights.row(0).transpose(), 1e-6};
    EXPECT_LT((line_of(apply(LevelPolynomial{}, scan)).heights -
               topography::detrended(scan, topography::Trend::parabola).heights)
                  .abs()
                  .maxCoeff(),
              1e-20);
    const Profile profile{Array1D::LinSpaced(33, 0.0, 1e-6).square() / 1e-6, map.heights.row(1).transpose(), {}};
    EXPECT_LT((profile_of(apply(LevelPolynomial{}, profile)).heights -
               topography::detrended(profile, topography::Trend::parabola).heights)
                  .abs()
                  .maxCoeff(),
              1e-20);
}

TEST(LevelPolynomial, KeepsPrecisionAtALargeOffset) {
    const auto map = noise(64, 64, 5);
    auto raised = map;
    raised.heights += 0.1;  // 10⁷ rms
    const auto plain = map_of(apply(LevelPolynomial{}, map)), high = map_of(apply(LevelPolynomial{}, raised));
    EXPECT_LT(largest(plain.heights - high.heights), 1e-16);  // rounding of 0.1 m: 1.4e-17 m
}

TEST(LevelPolynomial, RemovesTheParabolaOfAPolylineFarFromTheOrigin) {
    Profile profile{Array1D::LinSpaced(2000, 1e6, 1e6 + 1.0), Array1D(2000), {}};
    for (Index i = 0; i < 2000; ++i) profile.heights[i] = std::pow(2.0 * (profile.positions[i] - 1e6) - 1.0, 2);
    const auto far = profile_of(apply(LevelPolynomial{}, profile));
    Profile near = profile;
    near.positions -= 1e6;
    // the interpolating polyline of a parabola is not a parabola: both deviate from it by 1e-7
    EXPECT_LT((far.heights - profile_of(apply(LevelPolynomial{}, near)).heights).abs().maxCoeff(), 1e-10);
    EXPECT_LT(far.heights.abs().maxCoeff(), 1e-6);
}

TEST(LevelPlane, OfAPolylineDoesNotDependOnCollinearPoints) {
    Profile profile{Array1D(3), Array1D(3), {}};
    profile.positions << 0.0, 1.0, 3.0;
    profile.heights << 0.0, 1.0, 0.5;
    Profile finer{Array1D(5), Array1D(5), {}};
    finer.positions << 0.0, 0.25, 1.0, 2.0, 3.0;
    finer.heights << 0.0, 0.25, 1.0, 0.75, 0.5;
    const auto coarse = apply(LevelPlane{}, profile), fine = apply(LevelPlane{}, finer);
    EXPECT_NEAR(profile_of(coarse).heights[2], profile_of(fine).heights[4], 1e-15);
    EXPECT_NEAR(number_of(coarse.record, "removed_slope_x"), number_of(fine.record, "removed_slope_x"), 1e-15);
}

TEST(LevelPolynomial, OfAPolylineDoesNotDependOnCollinearPoints) {
    Profile profile{Array1D(4), Array1D(4), {}};
    profile.positions << 0.0, 1.0, 3.0, 4.0;
    profile.heights << 0.0, 1.0, 0.5, 2.0;
    Profile finer{Array1D(6), Array1D(6), {}};
    finer.positions << 0.0, 0.25, 1.0, 2.0, 3.0, 4.0;
    finer.heights << 0.0, 0.25, 1.0, 0.75, 0.5, 2.0;
    for (const Index degree : {2, 3}) {
        const auto coarse = fitted_polynomial(profile, {.total = degree}),
                   fine = fitted_polynomial(finer, {.total = degree});
        EXPECT_LT((coarse.coefficients - fine.coefficients).abs().maxCoeff(), 1e-14);
    }
}

TEST(LevelPlane, RefusesAReentrantPolyline) {
    Profile profile{Array1D(4), Array1D::Random(4), {}};
    profile.positions << 0.0, 1.0, 0.5, 2.0;
    for (const Step& step :
         {Step(LevelMean{}), Step(LevelPlane{}), Step(LevelPolynomial{}), Step(LevelFacet{}), Step(LevelLines{})}) {
        try {
            (void)processing::apply(step, profile, LoadMeasurement{});
            FAIL() << "accepted";
        } catch (const InvalidArgument& error) {
            EXPECT_NE(std::string(error.what()).find("does not increase at point 2"), std::string::npos)
                << error.what();
        }
    }
    profile.positions << 0.0, 1.0, 1.0, 2.0;  // a vertical step is no function, either
    EXPECT_THROW((void)apply(LevelPlane{}, profile), InvalidArgument);
}

TEST(LevelPlane, FittedToARegionIgnoresOtherPoints) {
    auto map = map_from(50, 40, {5e-6, 4e-6},
                        [](double x, double y) { return 0.03 * x - 0.01 * y + (x > 2.95e-6 ? 1e-7 : 0.0); });
    const auto level = apply(LevelPlane{region_from_text("exclude rectangle above 2.95 um")}, map);
    EXPECT_NEAR(number_of(level.record, "removed_slope_x"), 0.03, 1e-13);
    EXPECT_NEAR(number_of(level.record, "removed_slope_y"), -0.01, 1e-13);
    EXPECT_NEAR(map_of(level).heights(45, 3), 1e-7, 1e-19);
    EXPECT_NEAR(map_of(level).heights(5, 30), 0.0, 1e-19);
}

TEST(LevelPlane, IgnoresUndefinedHeights) {
    auto map = noise(24, 20, 2);
    auto other = map;
    map.heights(3, 4) = other.heights(3, 4) = undefined;
    const auto region = region_from_text("exclude rectangle 1 um to 2 um, 0.5 um to 1 um");
    const auto chosen = mask_of(region, other);
    for (Index k = 0; k < chosen.size(); ++k)
        if (!chosen.data()[k]) other.heights.data()[k] += 1e3;  // unused values change nothing elsewhere
    const auto one = map_of(apply(LevelPlane{region}, map)), two = map_of(apply(LevelPlane{region}, other));
    for (Index k = 0; k < chosen.size(); ++k) {
        if (chosen.data()[k] && one.heights.data()[k] == one.heights.data()[k]) {
            EXPECT_EQ(one.heights.data()[k], two.heights.data()[k]);
        }
    }
    EXPECT_TRUE(std::isnan(one.heights(3, 4)));
}

TEST(LevelPlane, RefusesPointsThatDoNotDetermineThePlane) {
    auto map = noise(10, 10, 1);
    EXPECT_THROW((void)apply(LevelPlane{region_from_text("include rectangle 0 um to 0 um")}, map),
                 UndefinedDataError);  // one column
    EXPECT_THROW((void)apply(LevelPolynomial{.degree = 12}, HeightMap(noise(3, 3, 1))), UndefinedDataError);
    EXPECT_THROW((void)apply(LevelPlane{}, HeightMap(noise(1, 10, 1))), UndefinedDataError);  // one row
    EXPECT_THROW((void)apply(LevelPolynomial{.degree = 25}, map), InvalidArgument);
    EXPECT_THROW((void)apply(LevelLines{.degree = -1}, map), InvalidArgument);
    map.heights.setConstant(undefined);
    EXPECT_THROW((void)apply(LevelMean{}, map), UndefinedDataError);
    EXPECT_THROW((void)apply(LevelLines{}, map), UndefinedDataError);
    EXPECT_THROW((void)apply(LevelFacet{}, map), UndefinedDataError);
    LineScan two{Array1D::Random(2), 1.0};
    EXPECT_LT(line_of(apply(LevelPlane{}, two)).heights.abs().maxCoeff(), 1e-15);
}

TEST(LevelMean, OfARowOrAConstantMapIsZero) {
    HeightMap constant{Array2D::Constant(5, 7, 3e-3), {1.0, 1.0}, true};
    const auto level = apply(LevelMean{}, constant);
    EXPECT_EQ(largest(map_of(level).heights), 0.0);
    EXPECT_EQ(number_of(level.record, "removed_height"), 3e-3);
    EXPECT_TRUE(map_of(level).periodic);
    EXPECT_FALSE(map_of(apply(LevelPlane{}, constant)).periodic);
    EXPECT_LT(std::fabs(map_of(apply(LevelMean{}, HeightMap(noise(1, 9, 4)))).heights.mean()), 1e-22);
}

TEST(LevelMean, SubtractsTheMeanOfARegion) {
    auto map = map_from(20, 20, {2e-6, 2e-6}, [](double x, double) { return x < 0.95e-6 ? 2e-9 : 9e-9; });
    const auto level = apply(LevelMean{region_from_text("include heights below 5 nm")}, map);
    EXPECT_NEAR(map_of(level).heights(0, 0), 0.0, 1e-24);
    EXPECT_NEAR(map_of(level).heights(19, 0), 7e-9, 1e-23);
}

/// Terraces of unit-cell steps on a tilted sample.
HeightMap terraces(double slope_x, double slope_y, Index nx = 120, Index ny = 90) {
    return map_from(nx, ny, {1.2e-6, 0.9e-6}, [=](double x, double y) {
        return 3e-10 * std::floor(x / 1.7e-7 + 0.3 * y / 1.7e-7) + slope_x * x + slope_y * y;
    });
}

TEST(LevelFacet, LevelsTerracesUnlikeAPlaneFit) {
    const auto level = apply(LevelFacet{}, terraces(0.01, -0.004));
    EXPECT_NEAR(number_of(level.record, "removed_slope_x"), 0.01, 2e-6);
    EXPECT_NEAR(number_of(level.record, "removed_slope_y"), -0.004, 2e-6);
    EXPECT_TRUE(level.record.alerts.empty());
    EXPECT_LT(std::fabs(map_of(level).heights.mean()), 1e-20);
    const auto plane = apply(LevelPlane{}, terraces(0.01, -0.004));
    EXPECT_GT(std::fabs(number_of(plane.record, "removed_slope_x") - 0.01), 1e-3);
}

TEST(LevelFacet, OfALineWithStepsLevelsItsTerraces) {
    LineScan scan{Array1D(200), 2e-6};
    for (Index i = 0; i < 200; ++i)
        scan.heights[i] = 1e-9 * std::floor(static_cast<double>(i) / 33.0) + 0.02 * 1e-8 * static_cast<double>(i);
    EXPECT_NEAR(number_of(apply(LevelFacet{}, scan).record, "removed_slope_x"), 0.02, 1e-6);
    const Profile profile{Array1D::LinSpaced(200, 0.0, 1.99e-6), scan.heights, {}};
    EXPECT_NEAR(number_of(apply(LevelFacet{}, profile).record, "removed_slope_x"), 0.02, 1e-6);
}

TEST(LevelFacet, OfAPlaneRemovesItInOneStep) {
    const auto level =
        apply(LevelFacet{}, map_from(20, 20, {1e-6, 1e-6}, [](double x, double y) { return 0.25 * x - 0.5 * y; }));
    EXPECT_LT(largest(map_of(level).heights), 1e-20);
}

TEST(LevelLines, RemovesAPolynomialPerLineAlongEitherDirection) {
    const auto height = [](double x, double y) {
        return std::sin(9e6 * y) * 1e-8 + x * std::cos(7e6 * y) * 1e-2 + x * x * 1e3;
    };
    auto map = map_from(30, 26, {3e-6, 2e-6}, height);
    EXPECT_LT(largest(map_of(apply(LevelLines{.degree = 2}, map)).heights), 1e-20);
    HeightMap turned{map.heights.transpose(), {2e-6, 3e-6}};
    const auto level = map_of(apply(LevelLines{.degree = 2, .direction = Direction::y}, turned));
    EXPECT_LT(largest(level.heights), 1e-20);
}

TEST(LevelLines, LinesWithTooFewPointsBecomeUndefinedWithAWarning) {
    auto map = noise(12, 20, 6);
    map.heights.col(4).setConstant(undefined);
    map.heights(3, 4) = 1e-9;
    map.heights(2, 7) = undefined;
    const auto level = apply(LevelLines{.degree = 1}, map);
    EXPECT_TRUE(map_of(level).heights.col(4).isNaN().all());
    EXPECT_EQ(map_of(level).heights.isNaN().count(), 13);
    EXPECT_EQ(number_of(level.record, "levelled_lines"), 19.0);
    ASSERT_EQ(level.record.alerts.size(), 1u);
    EXPECT_EQ(level.record.alerts[0].code, "UNDEFINED");
}

TEST(Level, GivesTheSameBytesForAnyNumberOfThreads) {
    auto map = terraces(0.01, 0.02, 150, 450);
    map.heights(100, 100) = undefined;
    const auto region = region_from_text("exclude percentiles above 90");
    for (const Step& step :
         {Step(LevelPolynomial{.degree = 3, .region = region}), Step(LevelFacet{}), Step(LevelLines{.degree = 3})}) {
        const auto run = [&](int threads) {
            return map_of(processing::apply(step, map, LoadMeasurement{}, {threads})).heights;
        };
        const Array2D one = run(1), three = run(3);
        EXPECT_EQ(std::memcmp(one.data(), three.data(), sizeof(double) * static_cast<std::size_t>(one.size())), 0)
            << step.index();
    }
}

}  // namespace
}  // namespace setae::processing::level_test
