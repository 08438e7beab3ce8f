// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "error_message.hpp"
#include "format_samples.hpp"
#include "setae/core/constants.hpp"
#include "setae/formats/format.hpp"
#include "wsxm_samples.hpp"

using namespace setae::tests;

namespace setae::formats::tests::wsxm_test {
namespace {

const WsxmFile floats{.type = "double",
                      .amplitude = "    Z Amplitude: 18.5 nm\r\n",
                      .range = "    Maximum: 341.0009\r\n    Minimum: 1\r\n"};

bytes::Source file(const std::string& content) { return bytes::memory_source("scan.stp", content); }

Channel only_channel(const std::string& content) { return open(file(content), {}).at(0); }

std::string refusal(const std::string& content) {
    return message_of([&] { (void)open(file(content), {}); });
}

TEST(Wsxm, FloatsAreNotScaledByTheRangeOfTheHeader) {
    const auto raw = lopsided_heights(6, 4, 1.0);
    const auto heights = topography::all_heights(only_channel(wsxm_file<double>(floats, raw)).read());
    EXPECT_DOUBLE_EQ(heights[0], raw(0, 0) * units::nm);
    EXPECT_DOUBLE_EQ(heights[23], raw(5, 3) * units::nm);
}

TEST(Wsxm, IsReadWithoutPrinting) {
    testing::internal::CaptureStdout();
    (void)only_channel(wsxm_file<double>(floats, lopsided_heights(6, 4, 1.0))).read();
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}

TEST(Wsxm, ReadsMetadataOfTheHeader) {
    const auto metadata = only_channel(wsxm_file<double>(floats, lopsided_heights(6, 4, 1.0))).info.metadata;
    EXPECT_EQ(metadata.acquisition_time, "03/11/2011, 20:23:46.484");
    EXPECT_EQ(metadata.instrument.name, "Dulcinea controller 24");
    EXPECT_EQ(metadata.instrument.type, "afm");
    EXPECT_EQ(metadata.attributes.at("z_offset"), "136.524 nm");
}

TEST(Wsxm, RangeInOtherNumbersIsNotAppliedToIntegers) {
    auto header = floats;
    header.type = "short";
    header.range = "    Maximum: 133.9231\r\n    Minimum: 115.038\r\n";
    const auto heights =
        topography::all_heights(only_channel(wsxm_file<std::int16_t>(header, lopsided_heights(6, 4, 1.0))).read());
    EXPECT_NEAR(heights.maxCoeff() - heights.minCoeff(), 18.5 * units::nm, 1e-20);
}

TEST(Wsxm, FlatIntegersAreFlat) {
    auto header = floats;
    header.type = "short";
    header.range = "    Maximum: 5\r\n    Minimum: 5\r\n";
    const Array2D flat = Array2D::Constant(6, 4, 5.0);
    EXPECT_EQ(topography::all_heights(only_channel(wsxm_file<std::int16_t>(header, flat)).read()).abs().maxCoeff(),
              0.0);
}

TEST(Wsxm, CurrentIsListedOnly) {
    auto header = floats;
    header.amplitude = "    Z Amplitude: 1.2 nA\r\n";
    const auto channel = only_channel(wsxm_file<double>(header, lopsided_heights(6, 4, 1.0)));
    EXPECT_FALSE(channel.info.is_height);
    EXPECT_EQ(channel.info.unit, "nA");
}

TEST(Wsxm, CurvesAreRefusedWithTheCommandToUse) {
    auto header = floats;
    header.second_line = "FZ File";
    EXPECT_NE(refusal(wsxm_file<double>(header, lopsided_heights(6, 4, 1.0)))
                  .find("at byte 41: WSxM: 'FZ File': force-distance curves"),
              std::string::npos)
        << refusal(wsxm_file<double>(header, lopsided_heights(6, 4, 1.0)));
    header.second_line = "IV File";
    EXPECT_NE(refusal(wsxm_file<double>(header, lopsided_heights(6, 4, 1.0)))
                  .find("got 'IV File', expected 'SxM Image file'"),
              std::string::npos);
}

TEST(Wsxm, IntegersWithoutAmplitudeAreRefused) {
    auto header = floats;
    header.type = "short";
    header.amplitude = "";
    EXPECT_NE(refusal(wsxm_file<std::int16_t>(header, lopsided_heights(6, 4, 1.0))).find("no 'Z Amplitude'"),
              std::string::npos);
    header.type = "long";
    EXPECT_NE(refusal(wsxm_file<std::int16_t>(header, lopsided_heights(6, 4, 1.0))).find("image data type 'long'"),
              std::string::npos);
}

TEST(Wsxm, ScaleFactorThatIsNotAppliedGivesAWarning) {
    auto header = floats;
    header.range += "    Z Scale Factor: 2.5\r\n";
    const auto alerts = only_channel(wsxm_file<double>(header, lopsided_heights(6, 4, 1.0))).info.alerts;
    ASSERT_EQ(alerts.size(), 1u);
    EXPECT_EQ(alerts[0].code, "SCALE_NOT_APPLIED");
}

TEST(Wsxm, ReadsPastLongCommentsInTheHeader) {
    auto header = floats;
    header.range += "    Comments: " + std::string(200'000, 'x') + "\r\n";
    const auto raw = lopsided_heights(6, 4, 1.0);
    EXPECT_DOUBLE_EQ(topography::all_heights(only_channel(wsxm_file<double>(header, raw)).read())[0],
                     raw(0, 0) * units::nm);
}

TEST(Wsxm, DataBeginAtTheAnnouncedHeaderSize) {
    const auto raw = lopsided_heights(6, 4, 1.0);
    auto content = wsxm_file<double>(floats, raw);
    const auto end = content.find("[Header end]\r\n") + 14;
    content.insert(end, 16, ' ');
    const auto digits = content.find("size: ") + 6;
    content.replace(digits, content.find('\r', digits) - digits, std::to_string(end + 16));  // as many digits as before
    EXPECT_DOUBLE_EQ(topography::all_heights(only_channel(content).read())[0], raw(0, 0) * units::nm);
}

}  // namespace
}  // namespace setae::formats::tests::wsxm_test
