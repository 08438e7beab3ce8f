// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "setae/core/errors.hpp"
#include "setae/processing/interpolation.hpp"
#include "setae/processing/resample.hpp"

namespace setae::processing::resample_test {
namespace {

using topography::HeightMap;
using topography::LineScan;
using topography::Profile;

constexpr double undefined_height = std::numeric_limits<double>::quiet_NaN();

Array2D noise(Index nx, Index ny) {
    std::mt19937 generator(1);
    std::normal_distribution<double> normal;
    return Array2D::NullaryExpr(nx, ny, [&] { return normal(generator); });
}

HeightMap plane(Index nx, Index ny) {
    return {Array2D::NullaryExpr(
                nx, ny, [](Index i, Index j) { return 0.5 * static_cast<double>(i) - 0.25 * static_cast<double>(j); }),
            {static_cast<double>(nx), static_cast<double>(ny)},
            false,
            {}};
}

TEST(Resample, ByAveragesKeepsMeanAndSize) {
    const HeightMap map{noise(30, 21), {3.0, 4.2}, false, {}};
    for (const auto& [nx, ny] : {std::pair<Index, Index>{10, 7}, {7, 4}, {45, 50}}) {
        const HeightMap other = resampled(map, Resample{.nx = nx, .ny = ny});
        EXPECT_EQ(other.shape(), (std::array<Index, 2>{nx, ny}));
        EXPECT_EQ(other.size, map.size);
        EXPECT_NEAR(other.heights.mean(), map.heights.mean(), 1e-13);
    }
    const HeightMap thirds = resampled(map, Resample{.nx = 10});
    EXPECT_EQ(thirds.shape(), (std::array<Index, 2>{10, 7}));
    EXPECT_NEAR(thirds.heights(4, 2), map.heights.block(12, 6, 3, 3).mean(), 1e-14);
}

TEST(Resample, ByAveragesIgnoresUndefinedPoints) {
    HeightMap map{noise(4, 4), {4.0, 4.0}, false, {}};
    map.heights(0, 0) = map.heights(2, 2) = map.heights(2, 3) = map.heights(3, 2) = undefined_height;
    const HeightMap other = resampled(map, Resample{.nx = 2});
    EXPECT_NEAR(other.heights(0, 0), (map.heights(0, 1) + map.heights(1, 0) + map.heights(1, 1)) / 3.0, 1e-15);
    EXPECT_TRUE(std::isnan(other.heights(1, 1)));
}

TEST(Resample, OfNonPeriodicMapsSpansFirstToLastPoint) {
    for (const Resampling method : {Resampling::linear, Resampling::bicubic}) {
        const HeightMap other = resampled(plane(9, 5), Resample{.nx = 17, .ny = 3, .method = method});
        EXPECT_LT(
            (other.heights -
             Array2D::NullaryExpr(
                 17, 3, [](Index i, Index j) { return 0.25 * static_cast<double>(i) - 0.5 * static_cast<double>(j); }))
                .abs()
                .maxCoeff(),
            1e-13);
        EXPECT_NEAR(other.pixel_size()[0], 0.5, 1e-15);
        EXPECT_NEAR(other.pixel_size()[1], 2.0, 1e-15);
    }
    const HeightMap exact = resampled(plane(9, 5), Resample{.pixel_size = 0.75, .method = Resampling::linear});
    EXPECT_EQ(exact.shape(), (std::array<Index, 2>{11, 6}));
    EXPECT_NEAR(exact.pixel_size()[0], 0.75, 1e-15);
}

TEST(Resample, OfPeriodicMapsKeepsTheirPeriod) {
    const HeightMap map{noise(8, 6), {2.0, 3.0}, true, {}};
    const HeightMap linear = resampled(map, Resample{.nx = 16, .ny = 12, .method = Resampling::linear}),
                    smooth = resampled(map, Resample{.nx = 16, .ny = 12, .method = Resampling::fourier});
    EXPECT_EQ(linear.size, map.size);
    EXPECT_TRUE(linear.periodic);
    EXPECT_EQ(linear.heights(4, 6), map.heights(2, 3));
    EXPECT_NEAR(linear.heights(15, 0), 0.5 * (map.heights(7, 0) + map.heights(0, 0)), 1e-15);
    EXPECT_TRUE((smooth.heights == fourier_interpolated(map, 16, 12).heights).all());
    EXPECT_EQ(resampled(map, Resample{.pixel_size = 0.1, .method = Resampling::bicubic}).shape(),
              (std::array<Index, 2>{20, 30}));
}

TEST(Resample, HandlesLinesAndPolylines) {
    const LineScan scan{Array1D{{0.0, 1.0, 4.0, 9.0}}, 4.0, false, {}};
    EXPECT_TRUE((resampled(scan, Resample{.nx = 2}).heights == Array1D{{0.5, 6.5}}).all());
    EXPECT_LT((resampled(scan, Resample{.nx = 7, .method = Resampling::linear}).heights -
               Array1D{{0.0, 0.5, 1.0, 2.5, 4.0, 6.5, 9.0}})
                  .abs()
                  .maxCoeff(),
              1e-15);
    EXPECT_LT((resampled(scan, Resample{.nx = 7, .method = Resampling::bicubic}).heights -
               Array1D{{0.0, 0.25, 1.0, 2.25, 4.0, 6.25, 9.0}})
                  .abs()
                  .maxCoeff(),
              1e-15);
    const Profile profile{Array1D{{10.0, 11.0, 13.0, 14.0}}, Array1D{{0.0, 1.0, 3.0, 3.0}}, {}};
    const LineScan even = resampled(profile, Resample{.nx = 9, .method = Resampling::linear});
    EXPECT_LT((even.heights - Array1D{{0.0, 0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 3.0, 3.0}}).abs().maxCoeff(), 1e-15);
    EXPECT_NEAR(even.pixel_size(), 0.5, 1e-15);
    EXPECT_EQ(resampled(profile, Resample{.pixel_size = 1.5, .method = Resampling::linear}).heights.size(), 3);
    EXPECT_THROW((void)resampled(profile, Resample{.nx = 9}), InvalidArgument);
}

TEST(Resample, RefusesInvalidParameters) {
    const HeightMap map = plane(5, 5);
    for (const double pixel : {1e-40, 1e-300}) try {
            (void)resampled(map, Resample{.pixel_size = pixel});
            ADD_FAILURE() << pixel;
        } catch (const InvalidArgument& error) {
            EXPECT_EQ(std::string(error.what()).find("-92233"), std::string::npos) << error.what();
            EXPECT_NE(std::string(error.what()).find("expected at most"), std::string::npos) << error.what();
        }
    EXPECT_THROW((void)resampled(map, Resample{.nx = Index{1} << 40, .ny = 2}), InvalidArgument);
    EXPECT_THROW((void)resampled(map, Resample{}), InvalidArgument);
    EXPECT_THROW((void)resampled(map, Resample{.nx = 1, .ny = 1}), InvalidArgument);
    EXPECT_THROW((void)resampled(map, Resample{.nx = 4, .pixel_size = 1.0}), InvalidArgument);
    EXPECT_THROW((void)resampled(map, Resample{.pixel_size = 10.0}), InvalidArgument);
    EXPECT_THROW((void)resampled(map, Resample{.nx = 10, .method = Resampling::fourier}), InvalidArgument);
    EXPECT_THROW((void)resampled(plane(1, 9), Resample{.nx = 4, .ny = 4, .method = Resampling::linear}),
                 InvalidArgument);
    EXPECT_EQ(apply(Resample{.nx = 10}, map).record.numbers.at(1).estimate.value, 10.0);
}

TEST(Resample, GivesTheSameBytesForAnyNumberOfThreads) {
    const HeightMap map{noise(50, 60), {5.0, 6.0}, false, {}};
    for (const Resampling method : {Resampling::linear, Resampling::bicubic, Resampling::average}) {
        const Array2D one = resampled(map, Resample{.nx = 33, .method = method}, {1}).heights,
                      three = resampled(map, Resample{.nx = 33, .method = method}, {3}).heights;
        EXPECT_EQ(std::memcmp(one.data(), three.data(), sizeof(double) * static_cast<std::size_t>(one.size())), 0);
    }
}

}  // namespace
}  // namespace setae::processing::resample_test
