// SPDX-License-Identifier: GPL-3.0-or-later
#include "mnt_samples.hpp"

#include <gtest/gtest.h>

#include "compound_file.hpp"
#include "error_message.hpp"
#include "format_samples.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/formats/format.hpp"

using namespace setae::tests;

namespace setae::formats::tests::mnt_test {
namespace {

std::vector<Channel> opened(const std::string& content) { return open(bytes::memory_source("a.mnt", content), {}); }
Array2D heights_of(const std::string& content, std::size_t channel = 0) {
    return std::get<topography::HeightMap>(opened(content).at(channel).read()).heights;
}

MntSurface surface_with_a_zero() {
    MntSurface surface{.counts = lopsided_heights(5, 4, 10.0)};
    surface.counts(2, 3) = 0.0;
    return surface;
}

TEST(Mnt, HeightIsCountTimesStepPlusOrigin) {
    const auto surface = surface_with_a_zero();
    const auto heights = heights_of(mnt_file(mnt_contents({surface})));
    EXPECT_NEAR(heights(0, 0), 50.0 * units::um + surface.counts(0, 0) * 0.1 * units::nm, 1e-18);
    EXPECT_NEAR(heights(4, 3) - heights(0, 0), (surface.counts(4, 3) - surface.counts(0, 0)) * 0.1 * units::nm, 1e-18);
}

TEST(Mnt, SizeIsPointsTimesStep) {
    const auto channel = opened(mnt_file(mnt_contents({surface_with_a_zero()})))[0];
    EXPECT_DOUBLE_EQ(channel.info.size.at(0), 5 * 2.0 * units::um);
    EXPECT_DOUBLE_EQ(channel.info.size.at(1), 4 * 1.5 * units::um);
    EXPECT_EQ(channel.info.unit, "µm");
    EXPECT_EQ(channel.info.metadata.attributes.at("software_version"), "9.2.0.9994");
}

/// Entry 1 next to the list of objects is their number, 12 or 39 in files in which it seemed to define the meaning of
/// zero: the mask does.
TEST(Mnt, ZeroIsUndefinedOnlyIfTheMaskMarksIt) {
    auto surface = surface_with_a_zero();
    for (const int others : {11, 38}) {
        surface.mask = false;
        EXPECT_EQ(heights_of(mnt_file(mnt_contents({surface}, others))).isNaN().count(), 0) << others;
        surface.mask = true;
        const auto heights = heights_of(mnt_file(mnt_contents({surface}, others)));
        EXPECT_EQ(heights.isNaN().count(), 1) << others;
        EXPECT_TRUE(std::isnan(heights(2, 3))) << others;
    }
}

TEST(Mnt, ReadsMeasuredSurfacesAndListsOtherQuantities) {
    auto volts = surface_with_a_zero();
    volts.z_unit = volts.z_shown = "V";
    volts.name = "current";
    const auto channels = opened(mnt_file(mnt_contents({surface_with_a_zero(), volts})));
    ASSERT_EQ(channels.size(), 2u);
    EXPECT_TRUE(channels[0].info.is_height);
    EXPECT_EQ(channels[0].info.name, "A48");
    EXPECT_FALSE(channels[1].info.is_height);
    EXPECT_EQ(channels[1].info.unit, "V");
}

TEST(Mnt, DocumentWithoutSurfaceIsRefused) {
    EXPECT_NE(message_of([] { (void)opened(mnt_file(mnt_contents({}))); }).find("no measured surface"),
              std::string::npos);
}

TEST(Mnt, OtherCompoundFilesAreNotMnt) {
    const auto content = CompoundFile({{"WordDocument", std::string(5000, 'w')}}).content();
    EXPECT_NE(message_of([&] { (void)opened(content); }).find("no supported format"), std::string::npos);
}

TEST(Mnt, CountsThatDoNotFitTheGridAreRefused) {
    auto contents = mnt_contents({surface_with_a_zero()});
    const auto at =
        contents.find(std::string("\x01\x00\x04\x00\x00\x00\x00\x00\x00\x00\x14\x00\x00\x00", 14));  // 20 counts
    ASSERT_NE(at, std::string::npos);
    contents[at + 10] = '\x15';
    EXPECT_NE(message_of([&] { (void)opened(mnt_file(contents)); }).find("an array of 21 elements, expected 20"),
              std::string::npos);
}

}  // namespace
}  // namespace setae::formats::tests::mnt_test
