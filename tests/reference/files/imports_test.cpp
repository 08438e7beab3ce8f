// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "reference_data.hpp"
#include "setae/core/errors.hpp"
#include "setae/tables/column_guess.hpp"
#include "setae/tables/force_curve.hpp"
#include "setae/tables/table_file.hpp"

namespace setae::formats::imports_test {
namespace {

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(RealFiles, AmbiguousColumnsOfMemsLoopsAreNamed) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "jkr/pdms_a.txt");
    const auto guess = tables::guess_columns(path.string());
    EXPECT_EQ(guess.columns.size(), 6u);
    EXPECT_EQ(guess.file.decimal_point, ',');
    EXPECT_TRUE(holds(tables::describe(guess),
                      "displacement: undecided between column 1 'Piezo position' [nm] and column 2 'MEMS displ.' [nm]"))
        << tables::describe(guess);
    EXPECT_TRUE(holds(tables::describe(guess), "time: column 3 'Time' [ms]"));
    EXPECT_THROW((void)tables::mapping_from(guess), FormatError);
}

TEST(RealFiles, LadybugSummaryIsReadWithItsTextColumns) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "force_curves/ladybug_pad_summary.txt");
    const auto table = tables::read_raw_table(bytes::file_source(path.string()));
    ASSERT_EQ(table.columns.size(), 42u);
    const auto column = [&](const std::string& name) {
        for (const auto& found : table.columns)
            if (found.name == name) return found;
        return tables::RawTable::RawColumn{};
    };
    EXPECT_EQ(column("Beam Spring Constant").unit, "μN/μm");
    EXPECT_DOUBLE_EQ(column("Beam Spring Constant").values[0], 31.79);
    EXPECT_EQ(column("Adhesion Energy").unit, "pJ");
    EXPECT_NEAR(column("Pulloff Force").values[0], 157.40947683394876, 1e-12);
    EXPECT_NE(column("ROI Label").text, "");
}

// Values below are those afmformats 0.18.7 (PyPI) gives for the same files.

TEST(RealForceCurves, JpkAgreesWithAfmformats) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "force_curves/fmt-jpk-fd_spot3-0192.jpk-force");
    const auto table = tables::read_force_curve(path.string());
    ASSERT_EQ(table.rows(), 4000);
    const auto& force = table.at("force");
    const auto& height = table.at("height");
    EXPECT_NEAR(force[0], -5.145579192349918e-10, 1e-24);
    EXPECT_NEAR(force[2500], -5.795164055415912e-10, 1e-24);
    EXPECT_NEAR(force.mean(), -4.430379197409225e-10, 1e-22);
    EXPECT_NEAR(height[0], 2.2815672438768612e-05, 1e-19);
    EXPECT_NEAR(height[3999], 2.2793994016157793e-05, 1e-19);
    EXPECT_NEAR(height.mean(), 2.0306628064609423e-05, 1e-18);
    EXPECT_NEAR(table.at("time")[2500], 1.25, 1e-12);
    EXPECT_EQ(table.metadata.at("spring_constant"), "0.043493666407368466 N/m");
    EXPECT_EQ(table.metadata.at("sensitivity"), "7.000143623002982e-08 m/V");
}

TEST(RealForceCurves, AfmWorkshopAgreesWithAfmformats) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "force_curves/fmt-afm-workshop-fd_single_2020-02-14_13.41.25.csv");
    const auto table = tables::read_force_curve(path.string());
    ASSERT_EQ(table.rows(), 2030);
    EXPECT_NEAR(table.at("force")[0], 1.2764373000000002e-06, 1e-20);
    EXPECT_NEAR(table.at("force").mean(), 1.3890711267487685e-06, 1e-18);
    EXPECT_NEAR(table.at("height").mean(), 1.6762457066699508e-05, 1e-18);  // the other reader turns the sign
    EXPECT_EQ(table.metadata.at("missing"), "spring_constant");
}

TEST(RealForceCurves, NtMdtAgreesWithAfmformats) {
    SETAE_REQUIRE_REFERENCE_DATA(path,
                                 "force_curves/fmt-ntmdt-txt-fd_2015_01_17_gel4-0,1_mQ_adh_6B_Curve_DFL_Height_51.txt");
    const auto table = tables::read_force_curve(path.string(), {.spring_constant = 0.04, .sensitivity = 60.0});
    ASSERT_EQ(table.rows(), 1644);
    EXPECT_NEAR(table.at("force")[0], -2.6479199999999997e-09, 1e-22);
    EXPECT_NEAR(table.at("force").mean(), -2.087460875912409e-09, 1e-21);
    EXPECT_NEAR(table.at("height").mean(), -3.2872664000000008e-06, 1e-18);
    EXPECT_EQ(table.at("segment").mean(), 0.5);
}

}  // namespace
}  // namespace setae::formats::imports_test
