// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "error_message.hpp"
#include "format_samples.hpp"
#include "patched_sample.hpp"
#include "setae/formats/format.hpp"

using namespace setae::tests;

namespace setae::formats::tests::lext_test {
namespace {

std::vector<Channel> opened(const std::string& content) {
    return formats::open(bytes::memory_source("a.lext", content), {});
}
std::string sample() { return lext_samples().at(0).content; }
std::string message(const std::string& content) {
    return message_of([&] { (void)opened(content); });
}

/// SurfaceTopography left its arrays as rows by columns.
TEST(Lext, FirstIndexIsX) {
    const auto map = std::get<topography::HeightMap>(opened(sample()).at(1).read());
    EXPECT_EQ(map.shape(), (std::array<Index, 2>{7, 5}));
    EXPECT_NEAR(map.pixel_size()[0], 125000.5e-12 * 1.001, 1e-18);
    EXPECT_NEAR(map.pixel_size()[1], 250000e-12 * 0.998, 1e-18);
}

TEST(Lext, ListsIntensityAndIgnoresThumbnails) {
    const auto channels = opened(sample());
    ASSERT_EQ(channels.size(), 2u);
    EXPECT_EQ(channels[0].info.name, "intensity");
    EXPECT_FALSE(channels[0].info.is_height);
    EXPECT_EQ(channels[1].info.metadata.instrument.name, "OLYMPUS OLS4100");
    EXPECT_EQ(channels[1].info.metadata.acquisition_time, "2013:03:18 10:21:00");
}

TEST(Lext, UnsupportedContentIsNamed) {
    EXPECT_NE(message(replaced(sample(), "HEIGHT", "HEIGHX")).find("no page named HEIGHT"), std::string::npos)
        << message(replaced(sample(), "HEIGHT", "HEIGHX"));
    EXPECT_NE(message(replaced(sample(), "<HeightDataUnitZ>2", "<HeightDataUnitZ>3")).find("<HeightDataUnitZ> is '3'"),
              std::string::npos);
    EXPECT_NE(message(replaced(sample(), "<HeightDataPerPixelZ>10000", "<HeightDataPerPixelZ>-1000"))
                  .find("'-1000', expected a positive number"),
              std::string::npos);
    EXPECT_NE(message(replaced(sample(), "<?xml version=\"1.0\" enco", "<!DOCTYPE a [ ]>       x")).find("DOCTYPE"),
              std::string::npos);
}

}  // namespace
}  // namespace setae::formats::tests::lext_test
