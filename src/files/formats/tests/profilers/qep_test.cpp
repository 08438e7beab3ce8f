// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>

#include "error_message.hpp"
#include "format_samples.hpp"
#include "qep_samples.hpp"
#include "sample_files.hpp"
#include "setae/core/constants.hpp"
#include "setae/formats/format.hpp"

using namespace setae::tests;

namespace setae::formats::tests::qep_test {
namespace {

std::vector<Channel> channels_of(const std::string& profile) {
    return open(bytes::memory_source("a.qep", zip_archive({{"Kontur1.prf", profile}})), {});
}

const Array1D positions = Array1D::LinSpaced(5, 1.0, 3.0);  // mm
const Array1D heights = lopsided_heights(5, 1, 0.01);

TEST(Qep, ReadsTheTipRadius) {
    for (const auto* radius : {"0.025", "0,025"})
        EXPECT_DOUBLE_EQ(
            channels_of(marwin_profile(positions, heights, radius)).at(0).info.metadata.instrument.tip_radius.value(),
            25.0 * units::um)
            << radius;
    EXPECT_FALSE(channels_of(marwin_profile(positions, heights, "unknown"))
                     .at(0)
                     .info.metadata.instrument.tip_radius.has_value());
}

TEST(Qep, ReadsInstrumentAndTime) {
    const auto metadata = channels_of(marwin_profile(positions, heights, "0.025")).at(0).info.metadata;
    EXPECT_EQ(metadata.instrument.name, "MarSurf LD 260");
    EXPECT_EQ(metadata.instrument.type, "stylus");
    EXPECT_EQ(metadata.acquisition_time, "2026-03-20  02:44:41  (Mitteleuropäische Zeit)");
    EXPECT_EQ(metadata.attributes.at("software_version"), "MarWin 12.06");
}

TEST(Qep, UnevenStepsGiveAProfileOfValidPoints) {
    Array1D uneven = positions, flagged = heights;
    uneven[1] += 0.2;
    flagged[2] = undefined;
    const auto measurement = channels_of(marwin_profile(uneven, flagged, "0.025")).at(0).read();
    const auto& profile = std::get<topography::Profile>(measurement);
    ASSERT_EQ(profile.positions.size(), 4);
    EXPECT_DOUBLE_EQ(profile.positions[1], 1.7 * units::mm);
    EXPECT_DOUBLE_EQ(profile.heights[2], heights[3] * units::mm);
}

TEST(Qep, EqualStepsKeepUndefinedPoints) {
    Array1D flagged = heights;
    flagged[2] = undefined;
    const auto scan =
        std::get<topography::LineScan>(channels_of(marwin_profile(positions, flagged, "0.025")).at(0).read());
    EXPECT_TRUE(std::isnan(scan.heights[2]));
    EXPECT_DOUBLE_EQ(scan.size, 2.5 * units::mm);
}

TEST(Qep, DamagedProfilesAreRefusedWithTheOffset) {
    const auto whole = marwin_profile(positions, heights, "0.025");
    const auto refusal = [](const std::string& profile) { return message_of([&] { (void)channels_of(profile); }); };
    EXPECT_NE(refusal(whole.substr(0, whole.size() - 3)).find("expected the end of 5 points at byte"),
              std::string::npos);
    auto no_section = whole;
    no_section.replace(no_section.find("[Trajec]"), 8, "[Nothing");
    EXPECT_NE(refusal(no_section).find("without the section '[Trajec]'"), std::string::npos);
    auto huge = whole;
    huge.replace(0x14, 4, std::string("\xff\xff\xff\x7f", 4));
    EXPECT_NE(refusal(huge).find("expected the end of 2147483647 points"), std::string::npos) << refusal(huge);
    Array1D standing = positions;
    standing[3] = standing[2];
    EXPECT_NE(refusal(marwin_profile(standing, heights, "1")).find("x of point 4 is not larger"), std::string::npos);
}

TEST(Qep, RefusesAnImpossibleMemberSizeBeforeAllocation) {
    auto archive = zip_archive({{"Kontur1.prf", marwin_profile(positions, heights, "0.025")}});
    const auto directory = archive.find("PK\x01\x02");
    archive.replace(directory + 24, 4, std::string("\x00\x00\x00\x33", 4));  // 855638016 bytes
    const auto message = message_of([&] { (void)open(bytes::memory_source("a.qep", archive), {}); });
    EXPECT_NE(message.find("member 'Kontur1.prf' announces 855638016 bytes"), std::string::npos) << message;
}

TEST(Qep, ProfileWithoutValidPointsIsUndefined) {
    Array1D uneven = positions;
    uneven[1] += 0.2;
    EXPECT_THROW((void)channels_of(marwin_profile(uneven, Array1D::Constant(5, undefined), "1")), UndefinedDataError);
}

}  // namespace
}  // namespace setae::formats::tests::qep_test
