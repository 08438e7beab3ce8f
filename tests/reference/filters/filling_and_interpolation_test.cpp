// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "analysis_cases.hpp"
#include "setae/processing/fill.hpp"
#include "setae/processing/interpolation.hpp"

namespace filling_and_interpolation_test {

using namespace setae;
using namespace setae::processing;
using nlohmann::json;
using tests::AnalysisCases;
using tests::matrix;
using topography::HeightMap;

TEST_F(AnalysisCases, FilledMapsAgreeOnSquarePixels) {
    HeightMap map = masked_map();
    const Array2D expected = matrix(cases["map_masked"]["imputed"]);
    // the case's pixels are 0.25 x 0.2; the package weighs both directions alike whatever the pixels, which is right
    // for square ones
    map.size = {24.0, 16.0};
    EXPECT_LT((filled(map).heights - expected).abs().maxCoeff(), 1e-14);
    map.size = {6.0, 3.2};
    EXPECT_GT((filled(map).heights - expected).abs().maxCoeff(), 1e-4);
}

TEST_F(AnalysisCases, LinearInterpolationAgrees) {
    for (const char* name : {"map_nonperiodic", "map_periodic"}) {
        const HeightMap map = height_map(name);
        const LinearInterpolator height(map);
        const json points = cases["map_nonperiodic"]["linear_points"];
        const json &periodic_points = cases["map_periodic"]["bicubic_points"], &values = cases[name]["linear_values"];
        for (std::size_t k = 0; k < values.size(); ++k) {
            const json& point = map.periodic ? periodic_points[k] : points[k];
            EXPECT_NEAR(height(point[0], point[1]), values[k].get<double>(), 1e-14) << name << " " << k;
        }
    }
}

TEST_F(AnalysisCases, BicubicInterpolationAgrees) {
    const HeightMap map = height_map("map_periodic");
    const BicubicInterpolator height(map);
    const json &points = cases["map_periodic"]["bicubic_points"], &values = cases["map_periodic"]["bicubic_values"];
    // the third point alone asks slopes along y, which with an even number of points there hold a share of the Nyquist
    // mode in the package: README.md
    for (const std::size_t k : {0u, 1u, 3u})
        EXPECT_NEAR(height(points[k][0], points[k][1]), values[k].get<double>(), 1e-14) << k;
    EXPECT_GT(std::abs(height(points[2][0], points[2][1]) - values[2].get<double>()), 1e-3);
}

TEST_F(AnalysisCases, BicubicInterpolationAgreesWithoutANyquistMode) {
    HeightMap map = height_map("map_periodic");
    map.heights = Array2D(map.heights.leftCols(15));
    map.size = {6.0, 3.0};
    const BicubicInterpolator interpolator(map);
    struct Expected {
        double x, y, height, slope_x, slope_y;
    };
    for (const Expected& expected : {Expected{0.1, 0.23, 0.006959980684837861, 0.1970821078899217, 0.05736874772812749},
                                     {5.9, 2.95, -0.06997908107473784, 0.5808974664826699, 0.6250750524633156},
                                     {3.33, 1.71, -0.007311178569950616, -0.22042690234681975, -0.3785451288722},
                                     {1.2, 2.5, 0.07015778108143422, -0.17011822946084423, -0.26772521069301286}}) {
        const SurfacePoint point = interpolator.at(expected.x, expected.y);
        EXPECT_NEAR(point.height, expected.height, 1e-14);
        EXPECT_NEAR(point.slope_x, expected.slope_x, 1e-13);
        EXPECT_NEAR(point.slope_y, expected.slope_y, 1e-13);
    }
}

TEST_F(AnalysisCases, SlopesDoNotDependOnTheNamesOfTheAxes) {
    // the package's Fourier derivative along y of a map with even ny holds the Nyquist mode, the one along x does not:
    // transposing changes slopes by 0.15
    const HeightMap map = height_map("map_periodic");
    const HeightMap turned{map.heights.transpose(), {map.size[1], map.size[0]}, true, {}};
    const SurfacePoint a = BicubicInterpolator(map).at(5.9, 3.1), b = BicubicInterpolator(turned).at(3.1, 5.9);
    EXPECT_NEAR(a.height, b.height, 1e-14);
    EXPECT_NEAR(a.slope_x, b.slope_y, 1e-13);
    EXPECT_NEAR(a.slope_y, b.slope_x, 1e-13);
}

}  // namespace filling_and_interpolation_test
