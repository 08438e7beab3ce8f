// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>

#include <gtest/gtest.h>

#include "patched_sample.hpp"

namespace setae::formats::tests::nms_test {
namespace {

TEST(Nms, PitchIsInNanometres) {
    const auto info = channels_of(nms_samples().at(0).content).at(0).info;
    EXPECT_DOUBLE_EQ(info.size.at(0), 7 * 312.5e-9) << "not mm, which would make a map of kilometres";
    EXPECT_DOUBLE_EQ(info.size.at(1), 4 * 625e-9);
    EXPECT_EQ(info.unit, "µm");
}

TEST(Nms, ReadsTimeTitleAndPicture) {
    const auto channels = channels_of(nms_samples().at(1).content);
    ASSERT_EQ(channels.size(), 2u);
    EXPECT_EQ(channels[0].info.name, "Confocal Height Image");
    EXPECT_EQ(channels[0].info.metadata.acquisition_time, "2022-02-09T13:25");
    EXPECT_EQ(channels[0].info.metadata.attributes.at("software_version"), "OM_MS_2.0");
    EXPECT_FALSE(channels[1].info.is_height);
    EXPECT_EQ(channels_of(nms_samples().at(0).content).size(), 1u) << "no picture behind the heights";
}

TEST(Nms, LeadingZerosAreNotTakenForAnotherFormat) {
    auto file = nms_samples().at(0).content;
    file.replace(0, 16, 16, '\0');
    EXPECT_EQ(detect_format(bytes::memory_source("file", file)).identifier, "nms");
}

TEST(Nms, InconsistentHeadersAreNotNms) {
    const auto file = nms_samples().at(2).content;
    const auto detected = [](const std::string& content) {
        return refusal(content).find("which no supported format") == std::string::npos;
    };
    EXPECT_TRUE(detected(file));
    EXPECT_FALSE(detected(with_number<std::uint32_t>(file, 1352, 3467))) << "length of the header";
    EXPECT_FALSE(detected(with_number(file, 24, -3.0))) << "highest below lowest";
    EXPECT_FALSE(detected(with_number(file, 16, std::numeric_limits<double>::quiet_NaN())));
    EXPECT_FALSE(detected(with_number<std::uint32_t>(file, 1368, 0))) << "no points";
    EXPECT_FALSE(detected(with_number<std::uint32_t>(file, 1372, 100001)));
    EXPECT_FALSE(detected(with_number(file, 1376, 0.0))) << "no pitch";
    EXPECT_FALSE(detected(std::string(8192, '\0')));
}

}  // namespace
}  // namespace setae::formats::tests::nms_test
