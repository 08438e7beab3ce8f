// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/study/force_map.hpp"

#include <cmath>
#include <fstream>
#include <limits>

#include <gtest/gtest.h>

#include "import_samples.hpp"
#include "setae/output/force_map_output.hpp"
#include "setae/output/loop_answer.hpp"

using namespace setae::tests;

namespace setae::study::tests::force_map_test {
namespace {

class FittedForceMap : public ::testing::Test {
protected:
    /// Contact moduli of 20, 25, 30 Pa on three pixels of four; the fourth curve is damaged.
    [[nodiscard]] std::string file(const std::string& header = jpk_map_header(2, 2)) const {
        std::vector<JpkMapCurve> curves{jpk_contact(0, 0.0, -1.5e-6, 20.0), jpk_contact(1, 2e-6, -1.5e-6, 25.0),
                                        jpk_contact(2, 0.0, -0.5e-6, 30.0), jpk_contact(9, 2e-6, -0.5e-6, 30.0)};
        curves.back().readings[0].pop_back();
        const auto path = folder_.path("map.jpk-force-map");
        std::ofstream(path, std::ios::binary) << jpk_map_file(curves, header);
        return path;
    }
    [[nodiscard]] static loops::LensAndCounterBody sphere() {
        return {.radius = 1e-3, .counter_youngs_modulus = std::numeric_limits<double>::infinity()};
    }

    TemporaryFolder folder_;
};

TEST_F(FittedForceMap, GivesModulusOrReasonForEachCurve) {
    const auto map = fit_force_map(file(), {}, sphere(), {}, {1});
    ASSERT_EQ(map.curves.size(), 4U);
    const double true_moduli[] = {20.0, 25.0, 30.0};
    for (std::size_t k = 0; k < 3; ++k) {
        ASSERT_TRUE(map.curves[k].summary) << map.curves[k].summary.reason;
        EXPECT_NEAR(map.curves[k].summary->contact_modulus->value / true_moduli[k], 1.0, 0.01);
        EXPECT_NEAR(map.curves[k].summary->pull_off_force->value, -1.5e-8, 2e-11);
        EXPECT_GT(map.curves[k].summary->energy_loss->value, 0.0);
    }
    EXPECT_EQ(map.curves[3].number, 9);
    EXPECT_TRUE(holds(map.curves[3].summary.reason, "index/9/segments/0"));
    EXPECT_TRUE(holds(output::answer(map), "4 curves on a grid of 2 × 2: E* 25.0"));
    EXPECT_TRUE(holds(output::answer(map), "1 curve without E*"));
}

TEST_F(FittedForceMap, QuantitiesAreOnTheGrid) {
    const auto quantities = quantities_on_grid(fit_force_map(file(), {}, sphere(), {}, {2}));
    ASSERT_EQ(quantities.size(), 5U);
    EXPECT_EQ(quantities[0].name, "contact_modulus");
    EXPECT_EQ(quantities[0].unit, "Pa");
    const auto& modulus = quantities[0].values;
    ASSERT_EQ(modulus.rows(), 2);
    EXPECT_NEAR(modulus(0, 1) / 20.0, 1.0, 0.01);  // y is least at the bottom
    EXPECT_NEAR(modulus(1, 1) / 25.0, 1.0, 0.01);
    EXPECT_NEAR(modulus(0, 0) / 30.0, 1.0, 0.01);
    EXPECT_TRUE(std::isnan(modulus(1, 0)));
}

TEST_F(FittedForceMap, IsTheSameForAnyNumberOfThreads) {
    const auto path = file();
    const auto one = output::curves_table(fit_force_map(path, {}, sphere(), {}, {1})),
               four = output::curves_table(fit_force_map(path, {}, sphere(), {}, {4}));
    EXPECT_EQ(tables::as_csv(one), tables::as_csv(four));
}

TEST_F(FittedForceMap, InvalidOptionsAreErrorsOfTheWholeMap) {
    const auto path = file();
    EXPECT_THROW((void)fit_force_map(path, {}, {}, {}, {1}), InvalidArgument);  // no radius
    EXPECT_TRUE(holds(message_of([&] { (void)open_force_curve(path, 5, {}); }), "no force curve 5; the file has 4"));
    EXPECT_EQ(open_force_curve(path, 2, {}).table.metadata.at("curve"), "2");
    auto header = jpk_map_header();
    header.replace(header.find("grid-position-pattern"), 21, "line-position-pattern");
    const auto map = fit_force_map(file(header), {}, sphere(), {}, {1});
    EXPECT_TRUE(holds(message_of([&] { (void)quantities_on_grid(map); }), "states no grid"));
}

TEST_F(FittedForceMap, WithDamagedCurvesOnlyIsRefused) {
    auto curve = jpk_contact(3, 0.0, 0.0, 20.0);
    curve.readings[0].pop_back();
    const auto path = folder_.write("map.jpk-force-map", jpk_map_file({curve}));
    EXPECT_TRUE(
        holds(message_of([&] { (void)fit_force_map(path, {}, sphere(), {}, {1}); }),
              "none of 1 force curves could be read and fitted; reason of the first: member 'index/3/segments/0"));
}

TEST_F(FittedForceMap, IsWrittenAsTableAndMaps) {
    const auto written =
        output::write_force_map(fit_force_map(file(), {}, sphere(), {}, {1}), folder_.path("out"), "map");
    ASSERT_EQ(written.size(), 2U);
    std::ifstream table(written[0]);
    std::string header, first;
    std::getline(table, header);
    std::getline(table, first);
    EXPECT_EQ(
        header,
        "curve,x [m],y [m],column,row,E_star [Pa],E_star standard_error [Pa],E [Pa],E standard_error [Pa],W [J/m2],"
        "W standard_error [J/m2],F_po [N],F_po standard_error [N],E_loss [J],E_loss standard_error [J],reason");
    EXPECT_TRUE(first.starts_with("0,0,-1.5e-06,0,1,"));
    EXPECT_TRUE(written[1].ends_with("map.gwy"));
}

}  // namespace
}  // namespace setae::study::tests::force_map_test
