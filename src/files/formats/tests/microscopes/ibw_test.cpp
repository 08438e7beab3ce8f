// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "error_message.hpp"
#include "format_samples.hpp"
#include "igor_builder.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/formats/format.hpp"

using namespace setae::tests;

namespace setae::formats::tests::ibw_test {
namespace {

using topography::HeightMap;

IgorContent asylum_content() {
    ByteBuilder numbers;
    for (int k = 0; k < 5 * 3 * 2; ++k) numbers.number(static_cast<float>(k));
    return {.points = {3, 2, 5, 0},
            .step = {1e-8, 1e-8, 1, 1},
            .data_unit = "m",
            .lateral_unit = "m",
            .note = "MicroscopeModel:Cypher\rUserIn0Unit: nA\rScanAngle: 330\r",
            .labels = {"HeightTrace", "PhaseRetrace", "NapPotentialTraceMod0", "AmplitudeTrace", "UserIn0Trace"},
            .numbers = numbers.content()};
}

std::vector<Channel> opened(const IgorContent& content, const ReadOptions& options = {}) {
    return formats::open(bytes::memory_source("a.ibw", igor_wave_5(std::endian::little, content)), options);
}
std::string message(const IgorContent& content) {
    return message_of([&] {
        for (const auto& channel : opened(content)) (void)channel.read();
    });
}

TEST(Ibw, UnitOfAnAsylumChannelFollowsFromItsName) {
    const auto channels = opened(asylum_content());
    const char* expected[] = {"m", "deg", "V", "m", "nA"};
    for (std::size_t k = 0; k < channels.size(); ++k) {
        EXPECT_EQ(channels[k].info.unit, expected[k]) << channels[k].info.name;
        EXPECT_EQ(channels[k].info.is_height, k == 0) << channels[k].info.name;
    }
    EXPECT_EQ(channels[1].info.metadata.attributes.at("line_direction"), "retrace");
    EXPECT_EQ(channels[0].info.metadata.instrument.name, "Cypher");
    EXPECT_EQ(channels[0].info.metadata.attributes.at("scan_angle"), "330");
}

TEST(Ibw, SizeIsNumberOfPointsTimesSpacing) {
    const auto info = opened(asylum_content()).at(0).info;
    EXPECT_DOUBLE_EQ(info.size.at(0), 3e-8);
    EXPECT_DOUBLE_EQ(info.size.at(1), 2e-8);
}

TEST(Ibw, HeightsUseTheUnitOfTheWaveNotOfTheAxes) {
    auto content = asylum_content();
    content.data_unit = "nm";
    content.lateral_unit = "um";
    content.step = {0.01, 0.01, 1, 1};
    EXPECT_EQ(opened(content).at(0).info.unit, "nm");
    const auto map = std::get<HeightMap>(opened(content).at(0).read());
    EXPECT_DOUBLE_EQ(map.size[0], 3e-8);
    EXPECT_DOUBLE_EQ(map.heights(1, 1), 1e-9);
    EXPECT_DOUBLE_EQ(map.heights(2, 0), 5e-9);
}

TEST(Ibw, LongUnitOverridesTheShortUnit) {
    auto content = asylum_content();
    content.note.clear();
    content.long_data_unit = "micron";
    EXPECT_EQ(opened(content).at(0).info.unit, "µm");
}

TEST(Ibw, WaveWithoutUnitsRequiresUnitAndSize) {
    auto content = asylum_content();
    content.note.clear();
    content.data_unit = content.lateral_unit = "";
    EXPECT_NE(message(content).find("`size`"), std::string::npos);
    const auto map = std::get<HeightMap>(opened(content, {.size = {{3e-6, 2e-6}}, .unit = "nm"}).at(0).read());
    EXPECT_DOUBLE_EQ(map.heights(1, 1), 1e-9);
    EXPECT_DOUBLE_EQ(map.size[1], 2e-6);
}

TEST(Ibw, DateIsReadFromTheNoteOrTheWave) {
    auto content = asylum_content();
    content.created = 3654699240u;  // 2019-10-23 18:14:00: 42299 days and 65640 s after 1904
    EXPECT_EQ(opened(content).at(0).info.metadata.acquisition_time, "2019-10-23 18:14:00");
    content.note += "Date:2019-10-24\rTime:12:14:13 PM\r";
    EXPECT_EQ(opened(content).at(0).info.metadata.acquisition_time, "2019-10-24 12:14:13 PM");
}

TEST(Ibw, OtherDataThanTopographyIsRefusedByName) {
    auto volume = asylum_content();
    volume.points = {3, 2, 1, 5};
    EXPECT_NE(message(volume).find("four dimensions"), std::string::npos);
    auto curves = asylum_content();
    curves.points = {6, 5, 0, 0};
    curves.labels = {"Raw", "Time", "b", "c", "d"};
    EXPECT_NE(message(curves).find("curves of 5 columns"), std::string::npos);
    curves.labels = {"ZSnsr", "Defl", "b", "c", "d"};
    EXPECT_NE(message(curves).find("setae jkr fit"), std::string::npos);
    auto series = asylum_content();
    series.lateral_unit = "s";
    EXPECT_NE(message(series).find("a wave over 's'"), std::string::npos);
    auto complex = asylum_content();
    complex.type = 3;
    EXPECT_NE(message(complex).find("numbers of type 3"), std::string::npos);
}

TEST(Ibw, RefusesHeadersThatAnnounceMoreThanTheFile) {
    auto content = asylum_content();
    content.points = {2000000000, 2000000000, 2000000000, 0};
    EXPECT_NE(message(content).find("the wave announces 2000000000 × 2000000000"), std::string::npos);
}

}  // namespace
}  // namespace setae::formats::tests::ibw_test
