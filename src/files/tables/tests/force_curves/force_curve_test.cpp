// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/tables/force_curve.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "import_samples.hpp"
#include "setae/tables/force_map.hpp"

using namespace setae::tests;

namespace setae::tables::tests::force_curve_test {
namespace {

Table curve(const std::string& content, const ForceCurveOptions& options = {}) {
    return read_force_curve(bytes::memory_source("f", content), options);
}

TEST(JpkForce, UsesTheConversionsOfTheFile) {
    for (const bool shared : {false, true}) {
        SCOPED_TRACE(shared);
        const auto table = curve(jpk_force_file(shared));
        ASSERT_EQ(table.rows(), 6);
        // heights 1e-6 (0.5 raw + 1), deflection 50 nm/V (0.001 raw + 0.25 V): offsets of the slots do not affect the
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

TEST(JpkForce, GivenConstantsOverrideTheFile) {
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
    EXPECT_TRUE(holds(changed_segment("", "", "12345"), "5 bytes are not a whole number of values of 2 bytes"));
    EXPECT_TRUE(holds(changed_segment("num-points=3", "num-points=4"), "the header announces 4"));
    EXPECT_TRUE(holds(changed_segment("signedshort", "nibbles"), "encoded as 'nibbles'"));
    EXPECT_TRUE(holds(changed_segment("offsetmultiplier", "spline"), "of style 'spline'"));
    EXPECT_TRUE(holds(changed_segment("base-calibration-slot=distance", "base-calibration-slot=force"), "form a loop"));
    EXPECT_TRUE(holds(changed_segment("multiplier=0.2", "multiplier=two"), "'two' is not a number"));
    EXPECT_TRUE(holds(changed_segment("measuredHeight", "somethingElse"), "no channel of height"));
}

TEST(AfmWorkshop, ReadsBothBranches) {
    const auto table = curve(afm_workshop_file());
    ASSERT_EQ(table.rows(), 5);  // the shorter branch is padded with empty cells
    EXPECT_DOUBLE_EQ(table.at("force")[2], 40e-9);
    EXPECT_DOUBLE_EQ(table.at("force")[4], 15e-9);
    EXPECT_NEAR(table.at("displacement")[1], 110e-9 - 2e-9 / 2.5, 1e-20);
    EXPECT_EQ(table.metadata.at("position_x"), "25.0 um");
    EXPECT_EQ(table.metadata.at("date"), "Friday, February 14, 2020");
    EXPECT_EQ(table.find("time"), nullptr);
}

TEST(AfmWorkshop, NamesTheMissingConstant) {
    auto text = afm_workshop_file();
    text.replace(text.find("\t2.5\r"), 4, "\t1");
    const auto table = curve(text);
    EXPECT_EQ(table.metadata.at("missing"), "spring_constant");
    EXPECT_EQ(table.find("displacement"), nullptr);
    EXPECT_NE(curve(text, {.spring_constant = 1.5}).find("displacement"), nullptr);
    text = afm_workshop_file();
    text.replace(text.find("120,40,,"), 8, "120,40,1,");
    EXPECT_TRUE(holds(message_of([&] { (void)curve(text); }),
                      "channels of different length: row 3 of the retract branch has only a height"));
}

TEST(NtMdt, ReversesApproachAndRemovesPadding) {
    const auto table = curve(nt_mdt_file(), {.spring_constant = 0.5, .sensitivity = 20.0});
    ASSERT_EQ(table.rows(), 9);  // one constant reading ahead of the approach is left out
    EXPECT_DOUBLE_EQ(table.at("height")[0], 0.5e-9);
    EXPECT_NEAR(table.at("force")[3], 0.5 * 20.0 * 1.25e-9, 1e-22);
    EXPECT_NEAR(table.at("deflection")[8], -20.0 * 0.25e-9, 1e-22);
    EXPECT_NEAR(table.at("displacement")[3], 30.5e-9 - 25e-9, 1e-22);
    EXPECT_EQ(table.metadata.at("units"), "nm and nA were assumed: the file states no units");
    EXPECT_EQ(curve(nt_mdt_file()).metadata.at("missing"), "spring_constant, sensitivity");
    EXPECT_EQ(curve(nt_mdt_file()).find("force"), nullptr);
}

TEST(ForceCurves, FormatsAreDistinguished) {
    EXPECT_EQ(force_curve_format(bytes::memory_source("f", jpk_force_file())), "jpk-force");
    EXPECT_EQ(force_curve_format(bytes::memory_source("f", afm_workshop_file())), "afm-workshop");
    EXPECT_EQ(force_curve_format(bytes::memory_source("f", nt_mdt_file())), "nt-mdt");
    for (const auto& other :
         {xlsx_loop(), std::string("a,b\n1,2\n"), std::string("time,force,radius\n1,2,3\n2,3,4\n"), std::string()})
        EXPECT_EQ(force_curve_format(bytes::memory_source("f", other)), std::nullopt);
    EXPECT_TRUE(holds(message_of([] { (void)curve("a,b\n1,2\n"); }), "unknown kind of force curve"));
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

TEST(IgorForce, SplitsAtTheTurningPointWithoutANote) {
    const auto table = curve(igor_force_file(""));
    EXPECT_EQ(table.metadata.at("segments"), "extend, retract");
    EXPECT_EQ(table.at("segment")[2], 0.0);
    EXPECT_EQ(table.at("segment")[3], 1.0);
    EXPECT_EQ(table.metadata.at("missing"), "spring_constant");
    EXPECT_EQ(table.find("time"), nullptr);
}

// ---- Nanoscope ------------------------------------------------------------------------------------------------------

TEST(NanoscopeForce, OrdersRampAndDeflectionFromTheDeepestPoint) {
    for (const int value_bytes : {2, 4}) {
        const auto table = curve(nanoscope_force_file(1, false, value_bytes));
        ASSERT_EQ(table.rows(), 7);
        // ramp of 160 nm in four equal steps, the deepest sample at 160 nm; retraction in three
        EXPECT_NEAR(table.at("height")[0], 40e-9, 1e-20);
        EXPECT_NEAR(table.at("height")[3], 160e-9, 1e-20);
        EXPECT_NEAR(table.at("height")[4], 160e-9, 1e-20);
        EXPECT_NEAR(table.at("height")[6], 160e-9 / 3.0, 1e-20);
        EXPECT_NEAR(table.at("deflection")[3], 0.3 * 50e-9, 1e-20);
        EXPECT_NEAR(table.at("force")[6], -0.08 * 50e-9 * 0.1, 1e-22);
        EXPECT_NEAR(table.at("displacement")[3], 160e-9 - 15e-9, 1e-20);
        EXPECT_EQ(table.metadata.at("format"), "nanoscope-force");
        EXPECT_EQ(table.metadata.at("segments"), "extend, retract");
        EXPECT_EQ(table.metadata.at("height_channel"), "ramp");
        EXPECT_EQ(table.metadata.at("trigger_mode"), "Relative");
        EXPECT_EQ(table.metadata.count("missing"), 0u);
    }
}

TEST(NanoscopeForce, PrefersTheHeightSensorToTheRamp) {
    const auto table = curve(nanoscope_force_file(1, true));
    EXPECT_NEAR(table.at("height")[3], 40e-9, 1e-20);
    EXPECT_NEAR(table.at("height")[0], 10e-9, 1e-20);
    EXPECT_EQ(table.metadata.at("height_channel"), "Height Sensor");
}

TEST(NanoscopeForce, ReadsCurvesOfAForceVolumeOnTheirGrid) {
    const auto curves = open_force_curves(bytes::memory_source("f", nanoscope_force_file(6)));
    ASSERT_EQ(curves.numbers.size(), 6u);
    ASSERT_TRUE(curves.grid);
    EXPECT_EQ(curves.grid->columns, 2);
    EXPECT_EQ(curves.grid->rows, 3);
    const auto last = curves.read(5);
    EXPECT_NEAR(last.table.at("reading")[0], 0.05, 1e-15);                        // 50 more than the first
    EXPECT_EQ(curves.grid->pixel(last.x, last.y), (std::array<Index, 2>{1, 0}));  // the last is at the upper right
    const auto first = curves.read(0);
    EXPECT_EQ(curves.grid->pixel(first.x, first.y), (std::array<Index, 2>{0, 2}));
}

TEST(NanoscopeForce, OmitsUnmeasuredSamples) {
    auto content = nanoscope_force_file();
    content.replace(4096 + 2 * 3, 2, std::string("\x00\x80", 2));  // the farthest of the approach
    EXPECT_EQ(curve(content).rows(), 6);
}

TEST(NanoscopeForce, NamesMissingAndDamagedEntries) {
    const auto changed = [](const std::string& from, const std::string& to) {
        auto content = nanoscope_force_file();
        content.replace(content.find(from), from.size(), to);
        return content;
    };
    EXPECT_EQ(curve(changed("@Sens. DeflSens", "@Sens. XeflSens")).metadata.at("missing"), "sensitivity");
    const auto message = [](const std::string& content) { return message_of([&] { (void)curve(content); }); };
    EXPECT_TRUE(holds(message(changed("Deflection Error", "Friction        ")), "without a channel of deflection"));
    EXPECT_TRUE(holds(message(changed("Ramp size", "Xamp size")), "neither a height sensor nor a ramp size"));
    EXPECT_TRUE(holds(message(nanoscope_force_file().substr(0, 4100)), "truncated"));
    EXPECT_TRUE(holds(message(changed("Bytes/pixel: 2", "Bytes/pixel: 3")), "3 bytes per value"));
}

// ---- text of JPK ----------------------------------------------------------------------------------------------------

TEST(JpkText, ReadsSegmentsWithTheirUnits) {
    const auto table = curve(jpk_text_file());
    ASSERT_EQ(table.rows(), 8);
    EXPECT_NEAR(table.at("force")[3], 3e-9, 1e-22);
    EXPECT_NEAR(table.at("height")[3], 1e-6, 1e-20);  // the measured one, not the nominal
    EXPECT_NEAR(table.at("displacement")[3], -1e-6 - 3e-9 / 0.1, 1e-19);
    EXPECT_NEAR(table.at("time")[4], 1.0, 1e-12);
    EXPECT_EQ(table.metadata.at("segments"), "extend, retract");
    EXPECT_EQ(table.metadata.at("height_channel"), "measuredHeight");
    EXPECT_EQ(table.metadata.at("instrument"), "N1");
    EXPECT_NEAR(curve(jpk_text_file(1, "V")).at("force")[3], 3e-9 * 5e-8 * 0.1, 1e-27);
    EXPECT_NEAR(curve(jpk_text_file(1, "m")).at("deflection")[3], 3e-9, 1e-22);
}

TEST(JpkText, ReadsSeveralCurvesByTheirIndex) {
    const auto curves = open_force_curves(bytes::memory_source("f", jpk_text_file(3)));
    EXPECT_EQ(curves.numbers, (std::vector<long>{0, 1, 2}));
    const auto last = curves.read(2);
    EXPECT_NEAR(last.table.at("force")[0], 20e-9, 1e-20);
    EXPECT_NEAR(last.x, 2e-6, 1e-18);
}

TEST(JpkText, NamesTheMissingColumnAndTheTruncationLine) {
    auto text = jpk_text_file();
    const auto message = [](const std::string& content) { return message_of([&] { (void)curve(content); }); };
    const auto cut = text.substr(0, text.rfind("0.75") - 20);
    EXPECT_TRUE(holds(message(cut), "no number for column")) << message(cut);
    for (auto at = text.find("eight "); at != std::string::npos; at = text.find("eight ")) text.replace(at, 5, "xxxxx");
    for (auto at = text.find("measuredHeight"); at != std::string::npos; at = text.find("measuredHeight"))
        text.replace(at, 14, "somethingOther");
    EXPECT_TRUE(holds(message(text), "no column of height")) << message(text);
}

TEST(ForceCurves, AreDetectedByTheirContent) {
    const auto stated = [](const std::string& content) {
        return stated_force_curve_format(bytes::memory_source("f", content)).value_or("");
    };
    EXPECT_EQ(stated(jpk_text_file()), "jpk-text");
    EXPECT_EQ(stated(afm_workshop_file()), "afm-workshop");
    EXPECT_EQ(stated(nt_mdt_file()), "");
    EXPECT_EQ(stated("1 2 3\n4 5 6\n"), "");
}

}  // namespace
}  // namespace setae::tables::tests::force_curve_test
