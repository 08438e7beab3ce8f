// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "error_message.hpp"
#include "format_samples.hpp"
#include "nanonis_samples.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/formats/format.hpp"

using namespace setae::tests;

namespace setae::formats::tests::nanonis_test {
namespace {

const auto map = lopsided_heights(6, 4, units::nm);

std::vector<Channel> opened(const std::string& content, const ReadOptions& options = {}) {
    return open(bytes::memory_source("a.sxm", content), options);
}

TEST(Nanonis, ListsChannelsWithScanDirection) {
    const auto channels = opened(nanonis_file(map, "up", "3.0E-6 2.0E-6"));
    ASSERT_EQ(channels.size(), 3u);
    EXPECT_EQ(channels[0].info.name, "Z (forward)");
    EXPECT_EQ(channels[1].info.name, "Z (backward)");
    EXPECT_EQ(channels[2].info.name, "Current (forward)");
    EXPECT_FALSE(channels[2].info.is_height);
    EXPECT_EQ(preferred_channel(channels), 0u);
    EXPECT_EQ(channels[0].info.metadata.acquisition_time, "2008-11-23 10:11:12");
    EXPECT_EQ(channels[0].info.metadata.attributes.at("scan_direction"), "up");
}

TEST(Nanonis, RangeOfZeroIsReportedMissing) {
    const auto content = nanonis_file(map, "down", "0.0 0.0");
    EXPECT_NE(message_of([&] { (void)opened(content)[0].read(); }).find("`size`"), std::string::npos);
    EXPECT_DOUBLE_EQ(std::get<topography::HeightMap>(opened(content, {.size = {{1e-6, 2e-6}}})[0].read()).size[1],
                     2e-6);
}

TEST(Nanonis, NamesTheDamageInTheError) {
    EXPECT_NE(message_of([] {
                  (void)opened(nanonis_file(map, "down", "1e-6 1e-6", "INT LSBFIRST"));
              }).find("expected FLOAT MSBFIRST"),
              std::string::npos);
    const auto whole = nanonis_file(map, "down", "1e-6 1e-6");
    EXPECT_NE(message_of([&] { (void)opened(whole.substr(0, whole.size() - 4)); }).find("truncated"),
              std::string::npos);
    auto without_mark = whole;
    without_mark[without_mark.find('\x1a')] = ' ';
    EXPECT_NE(message_of([&] { (void)opened(without_mark); }).find("0x1a 0x04"), std::string::npos);
    auto without_channels = whole;
    without_channels.replace(without_channels.find("DATA_INFO"), 9, "DATA_XXXX");
    EXPECT_NE(message_of([&] { (void)opened(without_channels); }).find("without channels"), std::string::npos);
}

}  // namespace
}  // namespace setae::formats::tests::nanonis_test
