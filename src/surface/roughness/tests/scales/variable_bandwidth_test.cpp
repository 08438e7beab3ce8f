// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/scales/variable_bandwidth.hpp"

#include <gtest/gtest.h>
#include <Eigen/Dense>

#include "brute_force.hpp"
#include "samples.hpp"
#include "setae/core/errors.hpp"
#include "setae/topography/detrend.hpp"

namespace setae::scales::variable_bandwidth_test {
namespace {

using namespace setae::tests;
using namespace setae::scales::tests;
using topography::HeightMap;
using topography::LineScan;
using topography::Profile;

/// rms of all residuals of planes in cells, by least squares in each cell.
double checkerboard(const HeightMap& map, Index cells_x, Index cells_y, bool lines) {
    const auto [nx, ny] = map.shape();
    double sum = 0.0, count = 0.0;
    for (Index cx = 0; cx < cells_x; ++cx)
        for (Index cy = 0; cy < cells_y; ++cy) {
            std::vector<std::array<double, 3>> points;
            for (Index i = 0; i < nx; ++i)
                for (Index j = 0; j < ny; ++j)
                    if (i * cells_x / nx == cx && j * cells_y / ny == cy && map.heights(i, j) == map.heights(i, j))
                        points.push_back({static_cast<double>(i), static_cast<double>(j), map.heights(i, j)});
            if (points.empty()) continue;
            const auto n = static_cast<Index>(points.size());
            Eigen::MatrixXd design(n, lines ? 2 : 3);
            Eigen::VectorXd heights(n);
            for (Index p = 0; p < n; ++p) {
                const auto& point = points[static_cast<std::size_t>(p)];
                design(p, 0) = 1.0;
                design(p, 1) = point[0];
                if (!lines) design(p, 2) = point[1];
                heights[p] = point[2];
            }
            sum += (heights - design * design.completeOrthogonalDecomposition().solve(heights)).squaredNorm();
            count += static_cast<double>(n);
        }
    return std::sqrt(sum / count);
}

TEST(VariableBandwidth, OfALineIsTheRmsOfAllResiduals) {
    for (const Index n : {16, 37, 96}) {
        const LineScan scan{random_heights(n), 3.0, false, {}};
        const auto result = variable_bandwidth(scan);
        for (Index k = 0; k < result.distance.size(); ++k) {
            const auto cells = static_cast<Index>(std::lround(3.0 / result.distance[k]));
            EXPECT_GE(n / cells, 4);
            EXPECT_NEAR(result.value[k], checkerboard(as_map(scan), cells, 1, true), 1e-13);
            EXPECT_EQ(result.count[k], static_cast<double>(n));
        }
        EXPECT_LT(n / static_cast<Index>(std::lround(6.0 / result.distance[0])), 4);
    }
}

TEST(VariableBandwidth, OfAMapIsTheRmsOfAllResidualsOfPlanes) {
    for (const bool holes : {false, true})
        for (const auto& [nx, ny] : {std::pair<Index, Index>{24, 16}, {33, 31}, {64, 40}}) {
            HeightMap map{random_map(nx, ny), {6.0, 3.2}, false, {}};
            if (holes) map = with_holes(map);
            const auto result = variable_bandwidth_of_area(map);
            for (Index k = 0; k < result.distance.size(); ++k) {
                const Index magnification = Index{1} << (result.distance.size() - 1 - k);
                EXPECT_NEAR(result.value[k], checkerboard(map, 2 * magnification, magnification, false), 1e-12)
                    << nx << " x " << ny << ", " << magnification;
                EXPECT_NEAR(result.distance[k] * static_cast<double>(magnification), 0.5 * (3.0 + 3.2), 1e-14);
            }
        }
}

TEST(VariableBandwidth, OfLinesIsTheRmsOverAllLines) {
    const HeightMap map = with_holes({random_map(40, 37), {4.0, 3.7}, false, {}});
    const auto result = variable_bandwidth_along_lines(map);
    double sum = 0.0, count = 0.0;
    for (Index j = 0; j < 37; ++j) {
        const HeightMap line{map.heights.col(j), {4.0, 1.0}, false, {}};
        const auto defined = static_cast<double>((!line.heights.isNaN()).count());
        sum += defined * std::pow(checkerboard(line, 8, 1, true), 2);
        count += defined;
    }
    ASSERT_NEAR(result.distance[0], 0.5, 1e-15);
    EXPECT_NEAR(result.value[0], std::sqrt(sum / count), 1e-12);
}

TEST(VariableBandwidth, StartsWithTheDetrendedRms) {
    const LineScan scan{random_heights(64), 1.0, false, {}};
    const auto detrended = topography::detrended(scan, topography::Trend::tilt);
    const auto result = variable_bandwidth(scan);
    EXPECT_NEAR(result.value[result.value.size() - 1], std::sqrt(detrended.heights.square().mean()), 1e-14);
    const HeightMap map{random_map(32, 32), {1.0, 1.0}, false, {}};
    const auto flat = topography::detrended(map, topography::Trend::tilt);
    const auto area = variable_bandwidth_of_area(map);
    EXPECT_NEAR(area.value[area.value.size() - 1], std::sqrt(flat.heights.square().mean()), 1e-13);
}

TEST(VariableBandwidth, OfPolylinesIsTheRmsOfTheIntegralOverAll) {
    // against a fine sampling of the same polyline
    const auto profile = random_profile(80);
    const auto result = variable_bandwidth(profile);
    const double length = profile.size();
    for (Index k = 0; k < result.distance.size(); ++k) {
        const auto cells = static_cast<Index>(std::lround(length / result.distance[k]));
        double sum = 0.0;
        const Index steps = 16000 / cells;
        for (Index c = 0; c < cells; ++c) {
            LineScan cell{Array1D(steps), 1.0, false, {}};
            for (Index s = 0; s < steps; ++s)
                cell.heights[s] = height_at(
                    profile, profile.positions[0] + length *
                                                        (static_cast<double>(c) +
                                                         (static_cast<double>(s) + 0.5) / static_cast<double>(steps)) /
                                                        static_cast<double>(cells));
            sum += topography::detrended(cell, topography::Trend::tilt).heights.square().mean();
        }
        EXPECT_NEAR(result.value[k] / std::sqrt(sum / static_cast<double>(cells)), 1.0, 2e-4) << cells;
    }
    const auto flat = topography::detrended(profile, topography::Trend::tilt);
    const Array1D left = flat.heights.head(79), right = flat.heights.tail(79),
                  steps = flat.positions.tail(79) - flat.positions.head(79);
    const double rms = std::sqrt((steps * (left * left + left * right + right * right)).sum() / (3.0 * length));
    EXPECT_NEAR(result.value[result.value.size() - 1], rms, 1e-10);
}

TEST(VariableBandwidth, OfPolylinesDoesNotDependOnCollinearPoints) {
    const auto profile = random_profile(40);
    Profile split{Array1D(79), Array1D(79), {}};
    for (Index k = 0; k < 40; ++k) {
        split.positions[2 * k] = profile.positions[k];
        split.heights[2 * k] = profile.heights[k];
        if (k == 39) break;
        split.positions[2 * k + 1] = 0.5 * (profile.positions[k] + profile.positions[k + 1]);
        split.heights[2 * k + 1] = 0.5 * (profile.heights[k] + profile.heights[k + 1]);
    }
    const auto as_is = variable_bandwidth(profile), more = variable_bandwidth(split);
    const Index extra = more.value.size() - as_is.value.size();
    EXPECT_LT((more.value.tail(as_is.value.size()) / as_is.value - 1.0).abs().maxCoeff(), 1e-11);
    EXPECT_GE(extra, 0);
}

TEST(VariableBandwidth, OfPolylinesEqualsTheLineScanUpToHalfSegments) {
    const Array1D heights = walk(random_heights(4096));
    const auto points = variable_bandwidth(LineScan{heights, 4096.0, false, {}});
    const auto integral = variable_bandwidth(Profile{Array1D::LinSpaced(4096, 0.0, 4095.0), heights, {}});
    for (Index k = 4; k < points.value.size(); ++k) EXPECT_NEAR(integral.value[k] / points.value[k], 1.0, 0.02);
}

TEST(VariableBandwidth, OfPlanesIsZeroAtAnyOffset) {
    HeightMap plane{Array2D(32, 32), {1.0, 1.0}, false, {}};
    for (Index i = 0; i < 32; ++i)
        for (Index j = 0; j < 32; ++j)
            plane.heights(i, j) = 1e3 + 2.0 * static_cast<double>(i) - 3.0 * static_cast<double>(j);
    EXPECT_LT(variable_bandwidth_of_area(plane).value.maxCoeff(), 1e-6);
    HeightMap map{random_map(32, 32), {1.0, 1.0}, false, {}};
    map.heights += 1e7;
    HeightMap centred = map;
    centred.heights -= 1e7;
    EXPECT_LT(
        (variable_bandwidth_of_area(map).value / variable_bandwidth_of_area(centred).value - 1.0).abs().maxCoeff(),
        1e-9);
    EXPECT_LT((variable_bandwidth_along_lines(map).value / variable_bandwidth_along_lines(centred).value - 1.0)
                  .abs()
                  .maxCoeff(),
              1e-9);
}

TEST(VariableBandwidth, CellsWithTooFewPointsUseTheirBestPlane) {
    HeightMap map{Array2D::Constant(8, 8, undefined), {1.0, 1.0}, false, {}};
    map.heights(0, 0) = 5.0;                           // one point: no residual
    map.heights(0, 4) = 1.0, map.heights(2, 6) = 2.0;  // two: none
    map.heights(4, 0) = 0.0, map.heights(5, 1) = 3.0,
                   map.heights(6, 2) = 0.0;  // three on a diagonal: about their mean 1, squares 1 + 4 + 1
    const auto result = variable_bandwidth_of_area(map);
    ASSERT_EQ(result.value.size(), 2);
    EXPECT_NEAR(result.value[0], std::sqrt(6.0 / 6.0), 1e-14);
    EXPECT_EQ(result.count[0], 6.0);
    map.heights.setConstant(undefined);
    EXPECT_THROW((void)variable_bandwidth_of_area(map), UndefinedDataError);
}

TEST(VariableBandwidth, RefusesDataSmallerThanACell) {
    EXPECT_THROW((void)variable_bandwidth(LineScan{random_heights(3), 1.0, false, {}}), InvalidArgument);
    EXPECT_THROW((void)variable_bandwidth_of_area({random_map(1, 50), {1.0, 50.0}, false, {}}), InvalidArgument);
    EXPECT_THROW((void)variable_bandwidth(LineScan{random_heights(30), 1.0, false, {}}, {.min_points = 1}),
                 InvalidArgument);
    auto reentrant = random_profile(20);
    reentrant.positions[4] = reentrant.positions[6];
    EXPECT_THROW((void)variable_bandwidth(reentrant), InvalidArgument);
}

TEST(VariableBandwidth, OfATransposedMapIsTheSame) {
    const Array2D heights = random_map(48, 20);
    const auto as_is = variable_bandwidth_of_area({heights, {4.8, 2.0}, false, {}});
    const auto turned = variable_bandwidth_of_area({heights.transpose(), {2.0, 4.8}, false, {}});
    EXPECT_LT((as_is.value / turned.value - 1.0).abs().maxCoeff(), 1e-12);
}

TEST(VariableBandwidth, HasTheSameBytesForAnyNumberOfThreads) {
    const HeightMap map = with_holes({random_map(70, 90), {1.0, 1.0}, false, {}});
    EXPECT_TRUE((variable_bandwidth_of_area(map, {.threads = {1}}).value ==
                 variable_bandwidth_of_area(map, {.threads = {3}}).value)
                    .all());
    EXPECT_TRUE((variable_bandwidth_along_lines(map, {.threads = {1}}).value ==
                 variable_bandwidth_along_lines(map, {.threads = {3}}).value)
                    .all());
}

}  // namespace
}  // namespace setae::scales::variable_bandwidth_test
