// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/tables/force_curve.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "import_samples.hpp"

using namespace setae::tests;

namespace setae::tables::tests::force_curve_test {
namespace {

Table curve(const std::string& content, const ForceCurveOptions& options = {}) {
    return read_force_curve(bytes::memory_source("f", content), options);
}

TEST(JpkForce, FollowsTheConversionsOfTheFile) {
    for (const bool shared : {false, true}) {
        SCOPED_TRACE(shared);
        const auto table = curve(jpk_force_file(shared));
        ASSERT_EQ(table.rows(), 6);
        // heights 1e-6 (0.5 raw + 1), deflection 50 nm/V (0.001 raw + 0.25 V): offsets of the slots do not enter the
        // sensitivity
        EXPECT_NEAR(table.at("height")[0], 3e-6, 1e-20);
        EXPECT_NEAR(table.at("deflection")[1], 50e-9 * 0.35, 1e-22);
        EXPECT_NEAR(table.at("force")[2], 0.2 * 50e-9 * 0.45, 1e-22);
        EXPECT_NEAR(table.at("force")[5], 0.2 * 50e-9 * 0.2, 1e-22);
        EXPECT_NEAR(table.at("displacement")[2], -1e-6 - 50e-9 * 0.45, 1e-20);
        EXPECT_NEAR(table.at("time")[4], 0.5 + 0.5 / 3.0, 1e-15);
        EXPECT_EQ(table.at("segment")[3], 1.0);
        EXPECT_EQ(table.metadata.at("segments"), "extend, retract");
        EXPECT_EQ(table.metadata.at("format"), "jpk-force");
        EXPECT_EQ(table.metadata.at("instrument"), "N1");
        EXPECT_EQ(table.metadata.at("date"), "2020-01-02 03:04:05");
        EXPECT_EQ(table.metadata.count("missing"), 0u);
    }
}

TEST(JpkForce, ConstantsGivenOverruleTheFile) {
    const auto table = curve(jpk_force_file(), {.spring_constant = 0.4, .sensitivity = 100e-9});
    EXPECT_NEAR(table.at("force")[2], 0.4 * 100e-9 * 0.45, 1e-22);
    EXPECT_EQ(table.metadata.at("spring_constant"), "0.4 N/m");
    EXPECT_THROW((void)curve(jpk_force_file(), {.spring_constant = -1.0}), InvalidArgument);
    EXPECT_THROW((void)curve(jpk_force_file(), {.sensitivity = std::nan("")}), InvalidArgument);
}

std::string changed_segment(const std::string& from, const std::string& to,
                            const std::string& heights = big_endian<std::int16_t>({4, 2, 0})) {
    auto properties = jpk_segment("extend", 3, false);
    for (auto at = properties.find(from); at != std::string::npos && !from.empty();
         at = properties.find(from, at + to.size()))
        properties.replace(at, from.size(), to);
    return message_of([&] {
        (void)curve(zip_archive({{"header.properties", "jpk-data-file=spm-forcefile\n"},
                                 {"segments/0/segment-header.properties", properties},
                                 {"segments/0/channels/measuredHeight.dat", heights},
                                 {"segments/0/channels/vDeflection.dat", big_endian<std::int16_t>({1, 2, 3})}}));
    });
}

TEST(JpkForce, DamageIsNamedByMember) {
    EXPECT_EQ(changed_segment("", ""), "no error");
    EXPECT_TRUE(holds(changed_segment("", "", big_endian<std::int16_t>({4, 2})),
                      "channels of different length: 'measuredHeight' has 2 values, 'vDeflection' 3"));
    EXPECT_TRUE(holds(changed_segment("", "", "12345"), "5 bytes are no whole number of values of 2 bytes"));
    EXPECT_TRUE(holds(changed_segment("num-points=3", "num-points=4"), "the header announces 4"));
    EXPECT_TRUE(holds(changed_segment("signedshort", "nibbles"), "encoded as 'nibbles'"));
    EXPECT_TRUE(holds(changed_segment("offsetmultiplier", "spline"), "of style 'spline'"));
    EXPECT_TRUE(
        holds(changed_segment("base-calibration-slot=distance", "base-calibration-slot=force"), "run in a circle"));
    EXPECT_TRUE(holds(changed_segment("multiplier=0.2", "multiplier=two"), "'two' is no number"));
    EXPECT_TRUE(holds(changed_segment("measuredHeight", "somethingElse"), "no channel of height"));
}

TEST(AfmWorkshop, ReadsBothBranches) {
    const auto table = curve(afm_workshop_file());
    ASSERT_EQ(table.rows(), 5);  // the shorter branch is filled up with empty cells
    EXPECT_DOUBLE_EQ(table.at("force")[2], 40e-9);
    EXPECT_DOUBLE_EQ(table.at("force")[4], 15e-9);
    EXPECT_NEAR(table.at("displacement")[1], 110e-9 - 2e-9 / 2.5, 1e-20);
    EXPECT_EQ(table.metadata.at("position_x"), "25.0 um");
    EXPECT_EQ(table.metadata.at("date"), "Friday, February 14, 2020");
    EXPECT_EQ(table.find("time"), nullptr);
}

TEST(AfmWorkshop, SaysWhichConstantIsMissing) {
    auto text = afm_workshop_file();
    text.replace(text.find("\t2.5\r"), 4, "\t1");
    const auto table = curve(text);
    EXPECT_EQ(table.metadata.at("missing"), "spring_constant");
    EXPECT_EQ(table.find("displacement"), nullptr);
    EXPECT_NE(curve(text, {.spring_constant = 1.5}).find("displacement"), nullptr);
    text = afm_workshop_file();
    text.replace(text.find("120,40,,"), 8, "120,40,1,");
    EXPECT_TRUE(holds(message_of([&] { (void)curve(text); }),
                      "channels of different length: row 3 of the retract branch has a height alone"));
}

TEST(NtMdt, ReversesApproachAndCutsPadding) {
    const auto table = curve(nt_mdt_file(), {.spring_constant = 0.5, .sensitivity = 20.0});
    ASSERT_EQ(table.rows(), 9);  // one constant reading ahead of the approach is left out
    EXPECT_DOUBLE_EQ(table.at("height")[0], 0.5e-9);
    EXPECT_NEAR(table.at("force")[3], 0.5 * 20.0 * 1.25e-9, 1e-22);
    EXPECT_NEAR(table.at("deflection")[8], -20.0 * 0.25e-9, 1e-22);
    EXPECT_NEAR(table.at("displacement")[3], 30.5e-9 - 25e-9, 1e-22);
    EXPECT_EQ(table.metadata.at("units"), "assumed nm and nA: the file states none");
    EXPECT_EQ(curve(nt_mdt_file()).metadata.at("missing"), "spring_constant, sensitivity");
    EXPECT_EQ(curve(nt_mdt_file()).find("force"), nullptr);
}

TEST(ForceCurves, FormatsAreToldApart) {
    EXPECT_EQ(force_curve_format(bytes::memory_source("f", jpk_force_file())), "jpk-force");
    EXPECT_EQ(force_curve_format(bytes::memory_source("f", afm_workshop_file())), "afm-workshop");
    EXPECT_EQ(force_curve_format(bytes::memory_source("f", nt_mdt_file())), "nt-mdt");
    for (const auto& other :
         {xlsx_loop(), std::string("a,b\n1,2\n"), std::string("time,force,radius\n1,2,3\n2,3,4\n"), std::string()})
        EXPECT_EQ(force_curve_format(bytes::memory_source("f", other)), std::nullopt);
    EXPECT_TRUE(holds(message_of([] { (void)curve("a,b\n1,2\n"); }), "no force curve setae reads"));
}

TEST(IgorForce, ReadsChannelsByTheirLabels) {
    for (const bool big : {false, true}) {
        const auto table = curve(igor_force_file(
            "SpringConstant: 0.5\rInvOLS: 1e-7\rNumPtsPerSec: 10\rIndexes: 0,2,3,5\rMicroscopeModel: MFP\r", big));
        ASSERT_EQ(table.rows(), 5);
        EXPECT_NEAR(table.at("force")[2], 2e-9, 1e-16);  // floats have 7 digits
        EXPECT_NEAR(table.at("displacement")[2], 3e-6 - 4e-9, 1e-12);
        EXPECT_NEAR(table.at("reading")[2], 0.04, 1e-8);
        EXPECT_NEAR(table.at("time")[4], 0.4, 1e-12);
        EXPECT_EQ(table.at("segment")[4], 2.0);
        EXPECT_EQ(table.metadata.at("segments"), "extend, pause, retract");
        EXPECT_EQ(table.metadata.at("instrument"), "MFP");
        EXPECT_NEAR(
            curve(igor_force_file("InvOLS: 1e-7\r"), {.spring_constant = 1.0, .sensitivity = 2e-7}).at("force")[2],
            8e-9, 1e-15);
    }
}

TEST(IgorForce, SplitsAtTheTurnWithoutANote) {
    const auto table = curve(igor_force_file(""));
    EXPECT_EQ(table.metadata.at("segments"), "extend, retract");
    EXPECT_EQ(table.at("segment")[2], 0.0);
    EXPECT_EQ(table.at("segment")[3], 1.0);
    EXPECT_EQ(table.metadata.at("missing"), "spring_constant");
    EXPECT_EQ(table.find("time"), nullptr);
}

}  // namespace
}  // namespace setae::tables::tests::force_curve_test
