// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/tables/force_map.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "import_samples.hpp"
#include "setae/core/constants.hpp"

using namespace setae::tests;

namespace setae::tables::tests::force_map_test {
namespace {

ForceCurves opened(const std::string& content, const ForceCurveOptions& options = {}) {
    return open_force_curves(bytes::memory_source("f", content), options);
}

const std::vector<JpkMapCurve> two_curves{{.number = 3, .x = 0.0, .y = -1e-6}, {.number = 12, .x = 2e-6, .y = -0.6e-6}};

TEST(JpkForceOf2015, IsDetectedByTypeAndReadWithItsSharedHeader) {
    const auto source = bytes::memory_source("f", jpk_force_file_of_2015());
    EXPECT_EQ(force_curve_format(source), "jpk-force");
    const auto table = read_force_curve(source);
    ASSERT_EQ(table.rows(), 3);
    EXPECT_NEAR(table.at("force")[2], 0.2 * 50e-9 * 0.45, 1e-22);
    EXPECT_NEAR(table.at("time")[1], 0.5 / 3.0, 1e-15);  // the duration is only in the shared header
    EXPECT_EQ(table.metadata.at("segments"), "extend");
    EXPECT_EQ(table.metadata.at("position_y"), "-2e-6 m");
}

TEST(JpkMap, GivesCurvesByNumberWithTheirPositions) {
    for (const bool qi : {false, true}) {
        SCOPED_TRACE(qi);
        const auto content = jpk_map_file(two_curves, jpk_map_header(2, 1, 0.0, qi));
        EXPECT_EQ(force_curve_format(bytes::memory_source("f", content)), "jpk-force-map");
        const auto curves = opened(content);
        EXPECT_EQ(curves.numbers, (std::vector<long>{3, 12}));
        const auto curve = curves.read(12);
        EXPECT_DOUBLE_EQ(curve.x, 2e-6);
        EXPECT_DOUBLE_EQ(curve.y, -0.6e-6);
        ASSERT_EQ(curve.table.rows(), 6);
        EXPECT_NEAR(curve.table.at("force")[2], 0.2 * 50e-9 * 0.45, 1e-22);
        EXPECT_EQ(curve.table.metadata.at("segments"), "extend, retract");
        EXPECT_EQ(curve.table.metadata.at("format"), "jpk-force-map");
    }
}

TEST(JpkMap, GivenConstantsOverrideTheFile) {
    EXPECT_NEAR(opened(jpk_map_file(two_curves), {.spring_constant = 0.4}).read(3).table.at("force")[2],
                0.4 * 50e-9 * 0.45, 1e-22);
}

TEST(JpkMap, IsNotASingleCurve) {
    EXPECT_TRUE(
        holds(message_of([] { (void)read_force_curve(bytes::memory_source("f", jpk_map_file(two_curves))); }),
              "2 force curves, expected one; `setae jkr fit` fits all of them, `curve_number` selects one of 3 to 12"));
}

TEST(JpkMap, DamageAffectsOneCurveOrTheGrid) {
    auto damaged = two_curves;
    damaged[1].readings[0] = {1, 2};
    const auto curves = opened(jpk_map_file(damaged));
    EXPECT_EQ(curves.read(3).table.rows(), 6);
    EXPECT_TRUE(holds(message_of([&] { (void)curves.read(12); }), "index/12/segments/0/segment-header.properties"));
    for (const auto& [columns, rows] : {std::pair{0, 1}, {1 << 20, 1 << 20}, {2, -1}})
        EXPECT_TRUE(holds(message_of([&] { (void)opened(jpk_map_file(two_curves, jpk_map_header(columns, rows))); }),
                          "it is damaged"));
    auto header = jpk_map_header();
    header.replace(header.find("ulength=4e-6"), 12, "ulength=four");
    EXPECT_TRUE(holds(message_of([&] { (void)opened(jpk_map_file(two_curves, header)); }), "no number"));
    header = jpk_map_header();
    header.replace(header.find("grid-position-pattern"), 21, "line-position-pattern");
    EXPECT_EQ(opened(jpk_map_file(two_curves, header)).grid, std::nullopt);
}

TEST(MapGrid, FindsPixelsFromTheTopLeft) {
    const MapGrid grid{.columns = 4, .rows = 2, .width = 4.0, .height = 2.0, .x = 10.0, .y = 20.0};
    EXPECT_EQ(grid.pixel(8.5, 20.5), (std::array<Index, 2>{0, 0}));
    EXPECT_EQ(grid.pixel(11.5, 19.5), (std::array<Index, 2>{3, 1}));
    EXPECT_EQ(grid.pixel(12.5, 19.5), std::nullopt);
    EXPECT_EQ(grid.pixel(std::nan(""), 19.5), std::nullopt);
    // the same, rotated by 90° about its centre: what was to the right is above
    const MapGrid turned{.columns = 4, .rows = 2, .width = 4.0, .height = 2.0, .x = 10.0, .y = 20.0, .angle = 0.5 * pi};
    EXPECT_EQ(turned.pixel(10.5, 21.5), (std::array<Index, 2>{3, 1}));
    EXPECT_EQ(turned.pixel(9.5, 18.5), (std::array<Index, 2>{0, 0}));
}

TEST(NanosurfForce, ReadsOneCurvePerLine) {
    const auto content = nanosurf_force_file();
    EXPECT_EQ(force_curve_format(bytes::memory_source("f", content)), "nanosurf-force");
    const auto curves = opened(content);
    EXPECT_EQ(curves.numbers, (std::vector<long>{0, 1}));
    EXPECT_EQ(curves.grid, std::nullopt);
    const auto curve = curves.read(1);
    EXPECT_DOUBLE_EQ(curve.x, 3e-6);
    EXPECT_DOUBLE_EQ(curve.y, 4e-6);
    const auto& table = curve.table;
    ASSERT_EQ(table.rows(), 5);  // the retraction of this curve has two points
    EXPECT_NEAR(table.at("height")[0], 8e-6, 1e-18);
    EXPECT_NEAR(table.at("deflection")[2], 60e-9, 1e-20);
    EXPECT_NEAR(table.at("force")[2], 48.0 * 60e-9, 1e-18);
    EXPECT_NEAR(table.at("displacement")[2], -4e-6 - 60e-9, 1e-18);  // heights decrease on approach
    EXPECT_NEAR(table.at("time")[4], 0.3 + 0.3, 1e-15);
    EXPECT_EQ(table.metadata.at("segments"), "extend, retract");
    EXPECT_EQ(table.metadata.at("probe"), "Tap190");
    EXPECT_EQ(table.metadata.count("missing"), 0u);
}

TEST(NanosurfForce, ConvertsVoltsToForceByTheCalibration) {
    const auto table = opened(nanosurf_force_file("V")).read(0).table;
    EXPECT_NEAR(table.at("reading")[2], 20e-4, 1e-15);
    EXPECT_NEAR(table.at("force")[2], 48.0 * 30e-9 * 20e-4, 1e-20);
    EXPECT_EQ(table.metadata.at("sensitivity"), "3e-08 m/V");
}

std::string changed_nanosurf(const std::string& from, const std::string& to) {
    auto content = nanosurf_force_file();
    content.replace(content.rfind(from), from.size(), to);
    return message_of([&] { (void)opened(content); });
}

TEST(NanosurfForce, DamageIsNamed) {
    const auto whole = nanosurf_force_file();
    EXPECT_TRUE(holds(message_of([&] { (void)opened(whole.substr(0, whole.size() - 1)); }), "it is truncated"));
    EXPECT_TRUE(holds(changed_nanosurf("Lines=2", "Lines=1"), "differ in points, curves or units"));
    EXPECT_TRUE(holds(changed_nanosurf("SaveBits=16", "SaveBits=12"), "integers of '12' bits"));
    auto content = whole;
    for (auto at = content.find("Z-Axis"); at != std::string::npos; at = content.find("Z-Axis", at))
        content.replace(at, 6, "Phase-");
    EXPECT_TRUE(holds(message_of([&] { (void)opened(content); }), "no part of the spectroscopy has a Z-Axis"));
}

}  // namespace
}  // namespace setae::tables::tests::force_map_test
