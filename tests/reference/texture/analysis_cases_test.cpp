// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <fstream>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "reference_data.hpp"
#include "setae/core/constants.hpp"
#include "setae/texture/height_parameters.hpp"
#include "setae/texture/hybrid_parameters.hpp"
#include "setae/texture/material_ratio.hpp"
#include "setae/texture/profile_parameters.hpp"

namespace {

using namespace setae;
using namespace setae::texture;
using nlohmann::json;
using topography::HeightMap;
using topography::LineScan;
using topography::Profile;

Array1D series(const json& values) {
    Array1D numbers(static_cast<Index>(values.size()));
    for (Index i = 0; i < numbers.size(); ++i) numbers[i] = values[static_cast<std::size_t>(i)].get<double>();
    return numbers;
}

class AnalysisCases : public testing::Test {
protected:
    void SetUp() override {
        SETAE_REQUIRE_REFERENCE_DATA(path, "expected/analysis_cases.json");
        cases = json::parse(std::ifstream(path));
    }
    [[nodiscard]] LineScan line(const char* name) const {
        const auto& input = cases[name]["input"];
        return {series(input["heights"]), input["physical_size"], input["periodic"], {}};
    }
    [[nodiscard]] HeightMap map(const char* name) const {
        const auto& input = cases[name]["input"];
        Array2D heights(static_cast<Index>(input["heights"].size()), static_cast<Index>(input["heights"][0].size()));
        for (Index i = 0; i < heights.rows(); ++i) heights.row(i) = series(input["heights"][static_cast<std::size_t>(i)]).transpose();
        return {std::move(heights), {input["physical_sizes"][0], input["physical_sizes"][1]}, input["periodic"], {}};
    }
    /// The non-periodic map with holes.
    [[nodiscard]] HeightMap masked() const {
        auto holed = map("map_nonperiodic");
        for (const auto& place : cases["map_masked"]["mask_true_indices"]) holed.heights(place[0].get<Index>(), place[1].get<Index>()) = undefined;
        return holed;
    }
    [[nodiscard]] Profile polyline() const { return {series(cases["nonuniform"]["input"]["x"]), series(cases["nonuniform"]["input"]["h"]), {}}; }

    /// Bearing areas at the recorded heights; median and half-width, which the package finds by bisection to 1e-6 of the height range.
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

    json cases;
};

TEST_F(AnalysisCases, MaterialRatiosOfLinesAgree) {
    for (const char* name : {"profile_nonperiodic", "profile_periodic"}) expect_curve(line(name), name);
}

TEST_F(AnalysisCases, MaterialRatiosOfMapsAgree) {
    for (const char* name : {"map_nonperiodic", "map_periodic"}) expect_curve(map(name), name);
}

TEST_F(AnalysisCases, MaterialRatiosOfAMapWithHolesAgree) { expect_curve(masked(), "map_masked"); }

TEST_F(AnalysisCases, MaterialRatiosOfAPolylineAgree) { expect_curve(polyline(), "nonuniform"); }

TEST_F(AnalysisCases, HeightsAndSlopesOfLinesAgree) {
    for (const char* name : {"profile_nonperiodic", "profile_periodic"}) {
        const auto scan = line(name);
        const auto heights = height_parameters(scan);
        EXPECT_NEAR(heights.Sq / cases[name]["Rq"].get<double>(), 1.0, 1e-10);
        EXPECT_NEAR(heights.mean / cases[name]["mean"].get<double>(), 1.0, 1e-10);
        EXPECT_NEAR(profile_slopes(scan).Rdq_2 / cases[name]["Rdq"].get<double>(), 1.0, 1e-10);
    }
}

TEST_F(AnalysisCases, HeightsAndGradientsOfMapsAgree) {
    for (const char* name : {"map_nonperiodic", "map_periodic"}) {
        const auto heights = height_parameters(map(name));
        EXPECT_NEAR(heights.Sq / cases[name]["Sq"].get<double>(), 1.0, 1e-10);
        EXPECT_NEAR(heights.mean / cases[name]["mean"].get<double>(), 1.0, 1e-10);
    }
    // differences that do not wrap are averaged over different numbers of points along x and y by the package; periodic ones agree
    EXPECT_NEAR(hybrid_parameters(map("map_periodic")).Sdq / cases["map_periodic"]["rms_gradient"].get<double>(), 1.0, 1e-10);
}

TEST_F(AnalysisCases, AMapWithHolesKeepsEveryDifferenceThatExists) {
    const auto heights = height_parameters(masked());
    EXPECT_NEAR(heights.Sq / cases["map_masked"]["Sq"].get<double>(), 1.0, 1e-10);
    EXPECT_NEAR(heights.mean / cases["map_masked"]["mean"].get<double>(), 1.0, 1e-10);
    const auto holed = masked();
    double x2 = 0.0, y2 = 0.0;
    int x = 0, y = 0, both = 0;
    double both2 = 0.0;
    const auto [dx, dy] = holed.pixel_size();
    for (Index i = 0; i < holed.heights.rows(); ++i)
        for (Index j = 0; j < holed.heights.cols(); ++j) {
            const double hx = i + 1 < holed.heights.rows() ? (holed.heights(i + 1, j) - holed.heights(i, j)) / dx : undefined;
            const double hy = j + 1 < holed.heights.cols() ? (holed.heights(i, j + 1) - holed.heights(i, j)) / dy : undefined;
            x2 += hx == hx ? hx * hx : 0.0;
            y2 += hy == hy ? hy * hy : 0.0;
            x += hx == hx ? 1 : 0;
            y += hy == hy ? 1 : 0;
            both2 += hx == hx && hy == hy ? hx * hx + hy * hy : 0.0;
            both += hx == hx && hy == hy ? 1 : 0;
        }
    EXPECT_NEAR(hybrid_parameters(holed).Sdq, std::sqrt(x2 / x + y2 / y), 1e-12);
    EXPECT_NEAR(std::sqrt(both2 / both), 0.28738572450030225, 1e-12);  // where the package says 0.2906
}

TEST_F(AnalysisCases, HeightsAndSlopesOfAPolylineAgree) {
    const auto profile = polyline();
    const auto heights = height_parameters(profile);
    const auto& expected = cases["nonuniform"];
    EXPECT_NEAR(heights.Sq / expected["Rq"].get<double>(), 1.0, 1e-10);
    EXPECT_NEAR(heights.mean / expected["mean"].get<double>(), 1.0, 1e-10);
    EXPECT_NEAR(profile_slopes(profile).Rdq / expected["Rdq"].get<double>(), 1.0, 1e-10);
}

}  // namespace
