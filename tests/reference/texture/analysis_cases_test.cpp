// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "analysis_cases.hpp"
#include "hybrid_parameters.hpp"
#include "profile_parts.hpp"
#include "setae/core/constants.hpp"
#include "setae/texture/height_parameters.hpp"
#include "setae/texture/material_ratio.hpp"
#include "setae/texture/profile_parameters.hpp"

namespace analysis_cases_test {

using namespace setae;
using namespace setae::texture;
using tests::series;
using topography::HeightMap;
using topography::LineScan;
using topography::Profile;

class TextureCases : public tests::AnalysisCases {
protected:
    /// Bearing areas at the recorded heights; median and half-width, which the package finds by bisection to 1e-6 of
    /// the height range.
    void expect_curve(const MeasurementView& measurement, const char* name) const {
        const auto& expected = cases[name];
        const Array1D heights = series(expected["bearing_heights"]), areas = series(expected["bearing_area"]);
        const auto found = bearing_area(measurement, heights);
        EXPECT_LT((found - areas).abs().maxCoeff(), 1e-10) << name;
        const double range = heights[heights.size() - 1] - heights[0];
        EXPECT_NEAR(median_height(measurement), expected["median"].get<double>(), 2e-6 * range) << name;
        if (expected.contains("mad_height")) {
            EXPECT_NEAR(mad_height(measurement), expected["mad_height"].get<double>(), 4e-6 * range) << name;
        }
    }
};

TEST_F(TextureCases, MaterialRatiosOfLinesAgree) {
    for (const char* name : {"profile_nonperiodic", "profile_periodic"}) expect_curve(line_scan(name), name);
}

TEST_F(TextureCases, MaterialRatiosOfMapsAgree) {
    for (const char* name : {"map_nonperiodic", "map_periodic"}) expect_curve(height_map(name), name);
}

TEST_F(TextureCases, MaterialRatiosOfAMapWithHolesAgree) { expect_curve(masked_map(), "map_masked"); }

TEST_F(TextureCases, MaterialRatiosOfAPolylineAgree) { expect_curve(polyline(), "nonuniform"); }

TEST_F(TextureCases, HeightsAndSlopesOfLinesAgree) {
    for (const char* name : {"profile_nonperiodic", "profile_periodic"}) {
        const auto scan = line_scan(name);
        const auto heights = height_parameters(scan);
        EXPECT_NEAR(heights.Sq / cases[name]["Rq"].get<double>(), 1.0, 1e-10);
        EXPECT_NEAR(heights.mean / cases[name]["mean"].get<double>(), 1.0, 1e-10);
        EXPECT_NEAR(profile_slopes(scan).Rdq_2 / cases[name]["Rdq"].get<double>(), 1.0, 1e-10);
    }
}

TEST_F(TextureCases, HeightsAndGradientsOfMapsAgree) {
    for (const char* name : {"map_nonperiodic", "map_periodic"}) {
        const auto heights = height_parameters(height_map(name));
        EXPECT_NEAR(heights.Sq / cases[name]["Sq"].get<double>(), 1.0, 1e-10);
        EXPECT_NEAR(heights.mean / cases[name]["mean"].get<double>(), 1.0, 1e-10);
    }
    // differences that do not wrap are averaged over different numbers of points along x and y by the package; periodic
    // ones agree
    EXPECT_NEAR(hybrid_parameters(height_map("map_periodic")).Sdq / cases["map_periodic"]["rms_gradient"].get<double>(),
                1.0, 1e-10);
}

TEST_F(TextureCases, MapsWithHolesUseEveryDefinedDifference) {
    const auto heights = height_parameters(masked_map());
    EXPECT_NEAR(heights.Sq / cases["map_masked"]["Sq"].get<double>(), 1.0, 1e-10);
    EXPECT_NEAR(heights.mean / cases["map_masked"]["mean"].get<double>(), 1.0, 1e-10);
    const auto holed = masked_map();
    double x2 = 0.0, y2 = 0.0;
    int x = 0, y = 0, both = 0;
    double both2 = 0.0;
    const auto [dx, dy] = holed.pixel_size();
    for (Index i = 0; i < holed.heights.rows(); ++i)
        for (Index j = 0; j < holed.heights.cols(); ++j) {
            const double hx =
                i + 1 < holed.heights.rows() ? (holed.heights(i + 1, j) - holed.heights(i, j)) / dx : undefined;
            const double hy =
                j + 1 < holed.heights.cols() ? (holed.heights(i, j + 1) - holed.heights(i, j)) / dy : undefined;
            x2 += std::isnan(hx) ? 0.0 : hx * hx;
            y2 += std::isnan(hy) ? 0.0 : hy * hy;
            x += std::isnan(hx) ? 0 : 1;
            y += std::isnan(hy) ? 0 : 1;
            both2 += !std::isnan(hx) && !std::isnan(hy) ? hx * hx + hy * hy : 0.0;
            both += !std::isnan(hx) && !std::isnan(hy) ? 1 : 0;
        }
    EXPECT_NEAR(hybrid_parameters(holed).Sdq, std::sqrt(x2 / x + y2 / y), 1e-12);
    EXPECT_NEAR(std::sqrt(both2 / both), 0.28738572450030225, 1e-12);  // where the package gives 0.2906
}

TEST_F(TextureCases, HeightsAndSlopesOfAPolylineAgree) {
    const auto profile = polyline();
    const auto heights = height_parameters(profile);
    const auto& expected = cases["nonuniform"];
    EXPECT_NEAR(heights.Sq / expected["Rq"].get<double>(), 1.0, 1e-10);
    EXPECT_NEAR(heights.mean / expected["mean"].get<double>(), 1.0, 1e-10);
    EXPECT_NEAR(profile_slopes(profile).Rdq / expected["Rdq"].get<double>(), 1.0, 1e-10);
}

}  // namespace analysis_cases_test
