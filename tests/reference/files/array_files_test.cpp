// SPDX-License-Identifier: GPL-3.0-or-later
// Real files of array containers against expected/topography_files.json.
#include <cmath>

#include <gtest/gtest.h>

#include "expected_file.hpp"
#include "reference_data.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/formats/channel.hpp"

namespace setae::formats::array_files_test {
namespace {

constexpr const char* folder = "topography/surfacetopography/";

struct ArrayFile {
    const char* name;
    std::size_t channel;
    const char* channel_name;
    ReadOptions given;  ///< what the file does not state
    double unit;        ///< of the expected values [m]
    std::vector<double> size;
};

void PrintTo(const ArrayFile& file, std::ostream* stream) { *stream << file.name << " channel " << file.channel; }

class ArrayFiles : public testing::TestWithParam<ArrayFile> {};

TEST_P(ArrayFiles, HaveTheHeightsOfAnotherReader) {
    const auto file = std::string(folder) + GetParam().name;
    SETAE_REQUIRE_REFERENCE_DATA(path, file);
    const auto entry = expected_entry(file, GetParam().channel);
    auto options = GetParam().given;
    options.keep_values = true;  // the other reader takes every value as a height
    const auto channel = open(path.string(), options).at(GetParam().channel);
    EXPECT_EQ(channel.info.name, GetParam().channel_name);
    ASSERT_EQ(channel.info.size.size(), GetParam().size.size());
    for (std::size_t k = 0; k < GetParam().size.size(); ++k)
        EXPECT_NEAR(channel.info.size[k], GetParam().size[k], 1e-12 * GetParam().size[k]);
    expect_heights_of(channel, entry, GetParam().unit);
}

INSTANTIATE_TEST_SUITE_P(
    Real, ArrayFiles,
    testing::Values(
        ArrayFile{
            "multiple_data_sets.h5", 0, "dataset1", {.size = {{1e-6, 2e-6}}, .unit = "um"}, units::um, {1e-6, 2e-6}},
        ArrayFile{
            "multiple_data_sets.h5", 1, "dataset2", {.size = {{1e-6, 2e-6}}, .unit = "nm"}, units::nm, {1e-6, 2e-6}},
        ArrayFile{"nc-1.nc", 0, "heights", {}, units::nm, {5e-9, 10e-9}},
        ArrayFile{"example-2d.npy", 0, "heights", {.size = {{1e-6, 2e-6}}, .unit = "m"}, 1.0, {1e-6, 2e-6}}));

TEST(ArrayFilesOfContainers, ReadTheInstrumentFromAttributes) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "topography/containers/index_json.zip");
    const auto channels = open(path.string());
    ASSERT_EQ(channels.size(), 2u);
    EXPECT_EQ(channels[0].info.metadata.instrument.name, "made");
    EXPECT_DOUBLE_EQ(channels[0].info.metadata.instrument.tip_radius.value(), 10e-9);
}

TEST(ArrayFilesWithMarks, HaveNoDataMarksRemoved) {
    SETAE_REQUIRE_REFERENCE_DATA(path, std::string(folder) + "multiple_data_sets.h5");
    // 116 points are exactly 5.77e-4, the others −3.3e-4 to −2.2e-4 and hardly any value twice
    const auto channel = open(path.string(), {.size = {{1e-6, 2e-6}}, .unit = "nm"}).at(1);
    const auto map = std::get<topography::HeightMap>(channel.read());
    EXPECT_EQ(map.heights.isNaN().count(), 116);
}

TEST(ArrayFilesWithoutSize, AreListedWithTheSizeMissing) {
    SETAE_REQUIRE_REFERENCE_DATA(path, std::string(folder) + "multiple_data_sets.h5");
    const auto channels = open(path.string());
    ASSERT_EQ(channels.size(), 2u);
    EXPECT_EQ(channels[1].info.shape, (std::vector<Index>{640, 480}));
    try {
        (void)channels[1].read();
        FAIL() << "read";
    } catch (const InvalidArgument& error) {
        EXPECT_NE(std::string(error.what()).find("`size`"), std::string::npos) << error.what();
    }
}

TEST(WrongNpy, IsRefusedByItsSignature) {
    SETAE_REQUIRE_REFERENCE_DATA(path, std::string(folder) + "wrongnpyfile.npy");
    try {
        (void)open(path.string());
        FAIL() << "opened";
    } catch (const FormatError& error) {
        EXPECT_NE(std::string(error.what()).find("at byte 0: begins with '\\xef\\xbf\\xbdNUMPY"), std::string::npos)
            << error.what();
    }
}

}  // namespace
}  // namespace setae::formats::array_files_test
